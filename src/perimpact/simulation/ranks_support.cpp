#include "perimpact/simulation/ranks_support.hpp"

#include <fmt/format.h>

#include <string>
#include <string_view>

#include "perimpact/deck_model/setup_error.hpp"
#include "perimpact/discretisation/cloud_of.hpp"

namespace perimpact {

namespace {

[[noreturn]] void refuse(const std::string& key, std::string_view what) {
  throw SetupError(key, fmt::format("{} not supported in a run of several ranks; run it with one rank, which may have any number of threads.", what));
}

}  // namespace

void expect_supported_by(const Ranks& ranks, const Setup& setup) {
  if (ranks.size() == 1) return;
  if (setup.contact.fragments.law.as<FragmentLaw>() != FragmentLaw::none) refuse("contact.fragments", "contact between fragments and bodies is");
  for (const BodySetup& body : setup.bodies) {
    const std::string key = "bodies." + body.name;
    if (is_cloud(body)) refuse(key + ".shape", "bodies from a file of particles are");
  }
}

}  // namespace perimpact
