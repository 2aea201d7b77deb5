#include "io/deck/consistency_fragments.hpp"

#include <fmt/format.h>

#include <string>

#include "io/deck/yaml_node.hpp"

namespace perimpact::deck {

void check_fragments(const FragmentContactSetup& fragments, const Places& places) {
  if (fragments.law.as<FragmentLaw>() != FragmentLaw::none) return;
  const FragmentContactSetup absent;
  for (const Field<FragmentContactSetup>& field : FragmentContactSetup::fields()) {
    const auto* number = std::get_if<double FragmentContactSetup::*>(&field.member);
    if (!number || fragments.*(*number) == absent.*(*number)) continue;
    refuse(places.of(fmt::format("contact.fragments.{}", field.name)),
           fmt::format("{} is {}, but law is none, so there is no short-range contact; set law: repulsive, or remove {}.", field.name, fragments.*(*number),
                       field.name));
  }
}

}  // namespace perimpact::deck
