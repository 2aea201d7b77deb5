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

void expect_supported_by(int ranks, const Setup& setup) {
  if (ranks == 1) return;
  for (const BodySetup& body : setup.bodies) {
    const std::string key = "bodies." + body.name;
    if (is_cloud(body)) refuse(key + ".shape", "bodies from a file of particles are");
  }
}

void expect_parts_for_all(const RanksInTurn& in_turn) {
  if (!in_turn.all_have_parts())
    throw SetupError("bodies", fmt::format("{} ranks are too many: the bodies can be divided among at most {}, since lattices are cut across x at multiples of "
                                           "eight cells only. Use fewer.",
                                           in_turn.ranks(), in_turn.parts()));
}

}  // namespace perimpact
