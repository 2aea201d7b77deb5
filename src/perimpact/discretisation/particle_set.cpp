#include "perimpact/discretisation/particle_set.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <string>

#include "base/nearest_word.hpp"
#include "base/parallel.hpp"
#include "perimpact/deck_model/setup_error.hpp"
#include "perimpact/discretisation/body_solid.hpp"

namespace perimpact {

namespace {

[[noreturn]] void refuse_name(std::string_view region, const BodySetup& body, const std::string& key) {
  std::vector<std::string> names;
  for (const SolidSetup& one : body.particle_sets) names.push_back(one.name);
  const std::string_view meant = fccda::nearest_word(region, names);
  const std::string remedy = names.empty()   ? fmt::format("it has none; add one under bodies.{}.particle_sets.", body.name)
                             : meant.empty() ? fmt::format("its particle sets are {}.", fmt::join(names, ", "))
                                             : fmt::format("did you mean {}?", meant);
  throw SetupError(key, fmt::format("body {} has no particle set {}; {}", body.name, region, remedy));
}

}  // namespace

std::vector<std::size_t> slots_in(std::string_view region, const BodySetup& body, const Particles& particles, const std::string& key) {
  const auto found = std::find_if(body.particle_sets.begin(), body.particle_sets.end(), [&](const SolidSetup& one) { return one.name == region; });
  if (found == body.particle_sets.end()) refuse_name(region, body, key);
  const std::string key_of_region = fmt::format("bodies.{}.particle_sets.{}", body.name, region);
  const Solid solid = solid_of(*found, body, key_of_region);
  const std::span<const std::uint32_t> slots = particles.slot_of();
  std::vector<std::uint8_t> inside(slots.size());
  const double margin = surface_share * particles.spacing();
  fccda::parallel_for(static_cast<std::ptrdiff_t>(slots.size()), [&](std::ptrdiff_t p) {
    const auto k = static_cast<std::size_t>(p);
    inside[k] = solid.contains(particles.reference(slots[k]), margin) ? 1 : 0;
  });
  std::vector<std::size_t> in;
  for (std::size_t k = 0; k < slots.size(); ++k)
    if (inside[k] != 0) in.push_back(slots[k]);
  if (!particles.share().ranks().any(!in.empty()))
    throw SetupError(key_of_region, fmt::format("particle set {} of body {} contains no particle; its position is relative to the body's position, in metres: "
                                                "move it, or make it larger than a spacing of {:.3g} m.",
                                                region, body.name, particles.spacing()));
  return in;
}

}  // namespace perimpact
