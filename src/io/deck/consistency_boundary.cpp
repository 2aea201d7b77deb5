#include "io/deck/consistency_boundary.hpp"

#include <fmt/format.h>

#include <string>

#include "io/deck/motion_table.hpp"
#include "io/deck/yaml_node.hpp"
#include "perimpact/deck_model/deck_context.hpp"

namespace perimpact::deck {

void make_boundary_conditions_consistent(BodySetup& body, bool is_quasi_static, const std::filesystem::path& folder, const Places& places) {
  const auto read = [&](MotionTable& table, const std::string& key) { read_table(table, false, key, folder, places); };
  const std::string path = "bodies." + body.name;
  for (BoundaryConditionSetup& boundary : body.boundary_conditions)
    std::visit(
        [&]<class Kind>(Kind& kind) {
          BodyContext deck{{fmt::format("{}.boundary_conditions.{}.{}", path, boundary.name, Kind::name), places}, body, path, is_quasi_static, read};
          kind.check(deck);
        },
        boundary.kind);
}

void check_relaxation(const Setup& setup, const Places& places) {
  if (!setup.time.relax) return;
  if (setup.time.step) refuse(places.of("time.step"), "step is given together with relax, which has increments instead of time steps; remove one of the two.");
  if (setup.output.history_interval)
    refuse(places.of("output.history_interval"), "history_interval is given, but relax writes one row per increment; remove history_interval.");
  if (setup.contact.fragments.law.as<FragmentLaw>() != FragmentLaw::none)
    refuse(places.of("contact.fragments.law"), "law is repulsive, but relax does not support short-range contact; remove one of the two.");
  if (setup.contact.impactors.crushing_pressure)
    refuse(places.of("contact.impactors.crushing_pressure"),
           "crushing_pressure acts in contact with impactors, but relax computes equilibrium states without contact; remove one of the two.");
  for (const BodySetup& body : setup.bodies) {
    const std::string path = "bodies." + body.name;
    if (body.velocity != Vec3d{})
      refuse(places.of(path + ".velocity"), "velocity is not 0, but relax computes equilibrium states without motion; remove one of the two.");
  }
}

}  // namespace perimpact::deck
