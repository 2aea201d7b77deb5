#include "io/deck/consistency_impactor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

#include "io/deck/deck_file.hpp"
#include "io/deck/motion_table.hpp"
#include "io/deck/yaml_node.hpp"

namespace perimpact::deck {

namespace {

void check_mass(const ImpactorSetup& impactor, const std::string& path, const Places& places) {
  if (impactor.mass && impactor.density) refuse(places.of(path + ".density"), "density is given together with mass; keep one of the two.");
  if (!impactor.mass && !impactor.density) refuse(places.of(path), fmt::format("{} lacks mass [kg] or density [kg/m3]; for example mass: 1.57 kg.", path));
}

bool is_rotation(std::size_t degree) { return degree >= 3; }

bool is_free(const ImpactorSetup& impactor, std::size_t degree) {
  return std::find(impactor.free_dofs.begin(), impactor.free_dofs.end(), degree_words[degree]) != impactor.free_dofs.end();
}

/// An angle about one axis defines the attitude only if the impactor rotates about no other axis.
void check_only_turning_axis(const ImpactorSetup& impactor, std::size_t degree, const std::string& path, const Places& places) {
  for (std::size_t other = 3; other < std::size(degree_words); ++other) {
    if (other == degree) continue;
    const std::string_view word = degree_words[other];
    const std::string turns = is_free(impactor, other)                    ? fmt::format("{} is free", word)
                              : impactor.motion.of(other)                 ? fmt::format("motion.{} rotates it about another axis", word)
                              : impactor.angular_velocity[other - 3] != 0 ? fmt::format("angular_velocity rotates it about {} too", word.substr(1))
                                                                          : "";
    if (!turns.empty())
      refuse(places.of(path + ".displacements"), fmt::format("displacements of {} define the attitude only if the impactor rotates about no other axis, "
                                                             "because rotations do not commute, but {}; constrain the other rotations, or give velocities.",
                                                             degree_words[degree], turns));
  }
}

void check_motion(ImpactorSetup& impactor, const std::string& path, const std::filesystem::path& folder, const Places& places) {
  for (std::size_t degree = 0; degree < std::size(degree_words); ++degree) {
    MotionTable* table = impactor.motion.of(degree);
    if (!table) continue;
    const std::string_view word = degree_words[degree];
    const std::string key = fmt::format("{}.motion.{}", path, word);
    check_table(*table, key, places);
    read_table(*table, is_rotation(degree), key, folder, places);
    if (is_free(impactor, degree))
      refuse(places.of(key), fmt::format("{0} is free, so its motion cannot be prescribed; remove {0} from free_dofs, or remove its motion.", word));
    const std::string given = is_rotation(degree) ? "angular_velocity" : "velocity";
    const std::size_t axis = degree % 3;
    if ((is_rotation(degree) ? impactor.angular_velocity : impactor.velocity)[axis] != 0)
      refuse(places.of(path + "." + given),
             fmt::format("{} of {} is not 0, but motion.{} prescribes this degree of freedom; set it to 0, or remove that motion.", "xyz"[axis], given, word));
    if (is_rotation(degree) && !table->displacements.empty()) check_only_turning_axis(impactor, degree, key, places);
  }
}

void check_load(const LoadSetup& load, const std::string& path, const Places& places) {
  if (load.force == Vec3d{} && load.moment == Vec3d{})
    refuse(places.of(path), fmt::format("{} has neither a force [N] nor a moment [N m]; give one, or remove the load.", path));
  check_as_many(load.factors.size(), load.times.size(), "factors", path + (load.factors.empty() ? ".times" : ".factors"));
  check_increasing(load.times, path + ".times");
  check_as_many(load.speed_factors.size(), load.speeds.size(), "speed_factors", path + (load.speed_factors.empty() ? ".speeds" : ".speed_factors"),
                speed_argument);
  check_increasing(load.speeds, path + ".speeds", speed_argument);
  if (!load.speeds.empty() && load.force == Vec3d{})
    refuse(places.of(path + ".speeds"),
           fmt::format("speeds are velocities along the force, but {} has none; give a force, or remove speeds and speed_factors.", path));
}

void check_gauge(const GaugeSetup& gauge, DetectorKind detector, const std::string& path, const Places& places) {
  if (gauge.axis && *gauge.axis == Vec3d{}) refuse(places.of(path + ".axis"), "axis is [0, 0, 0], which has no direction; give one, for example [0, 0, 1].");
  if (!gauge.surface_parts.empty() && detector == DetectorKind::analytic)
    refuse(places.of(path + ".surface_parts"),
           "surface_parts is given, but the analytic detector has no panels; remove surface_parts, or set detector: swept.");
}

/// Calls f(key) for each way of remeshing that the impactor has. An empty map, as of a run.json, is none.
template <class F>
void for_each_remeshing(const ImpactorSetup& impactor, const F& f) {
  if (impactor.coarsen) f("coarsen");
  if (!impactor.refine.empty()) f("refine");
}

void check_remeshing(const ImpactorSetup& impactor, const std::string& path, DetectorKind detector, const Places& places) {
  if (detector != DetectorKind::analytic) return;
  for_each_remeshing(impactor, [&](std::string_view key) {
    refuse(places.of(fmt::format("{}.{}", path, key)),
           fmt::format("{0} is given, but the analytic detector has no panels; remove {0}, or set detector: swept.", key));
  });
}

/// Contact with an elastic impactor moves the vertices of its panels, those that the modes are given on.
void make_elastic_consistent(ImpactorSetup& impactor, DetectorKind detector, const std::string& path, const std::filesystem::path& folder,
                             const Places& places) {
  if (!impactor.elastic) return;
  if (detector != DetectorKind::swept)
    refuse(places.of(path + ".elastic"), fmt::format("{} is elastic, but the {} detector has rigid surfaces only; set detector: swept, or remove elastic.",
                                                     impactor.name, detector_words[static_cast<std::size_t>(detector)]));
  for_each_remeshing(impactor, [&](std::string_view key) {
    refuse(places.of(fmt::format("{}.{}", path, key)),
           fmt::format("{0} changes the vertices of the surface, on which the modes of elastic are given; remove {0}, remesh the surface before its modes are "
                       "computed, or remove elastic.",
                       key));
  });
  impactor.elastic->modes = full_path(folder / impactor.elastic->modes, places.of(path + ".elastic.modes"));
}

}  // namespace

void make_impactor_consistent(ImpactorSetup& impactor, DetectorKind detector, const std::filesystem::path& folder, const Places& places) {
  const std::string path = "impactors." + impactor.name;
  check_mass(impactor, path, places);
  check_motion(impactor, path, folder, places);
  check_remeshing(impactor, path, detector, places);
  make_elastic_consistent(impactor, detector, path, folder, places);
  for (const LoadSetup& load : impactor.loads) check_load(load, path + ".loads." + load.name, places);
  for (const GaugeSetup& gauge : impactor.gauges) check_gauge(gauge, detector, path + ".gauges." + gauge.name, places);
}

}  // namespace perimpact::deck
