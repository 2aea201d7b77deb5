#include "io/deck/consistency_boundary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/deck/motion_table.hpp"
#include "io/deck/yaml_node.hpp"

namespace perimpact::deck {

namespace {

/// Body, key and deck of one boundary condition, as its checks need them.
struct Context {
  const BodySetup& body;
  std::string path;  // "bodies.plate.boundary_conditions.grip.fixed"
  const std::filesystem::path& folder;
  const Places& places;

  bool is_plane() const { return body.plane.as<Plane>() != Plane::none; }
  std::string place(std::string_view key) const { return places.of(fmt::format("{}.{}", path, key)); }
  void refuse_along_z(std::string_view key) const {
    if (is_plane()) refuse(place(key), fmt::format("{} acts along z, but body {} is 2-D and its particles stay in the plane; remove it.", key, body.name));
  }
  void check_factors(const std::vector<double>& times, const std::vector<double>& factors) const {
    check_as_many(factors.size(), times.size(), "factors", place(factors.empty() ? "times" : "factors"));
    check_increasing(times, place("times"));
  }
};

void check(FixedSetup& fixed, const Context& context) {
  std::set<std::string> seen;
  for (const std::string& direction : fixed.directions) {
    if (std::find(std::begin(axis_words), std::end(axis_words), direction) == std::end(axis_words))
      refuse(context.place("directions"),
             fmt::format("directions contains \"{}\", which is not a direction; known are {}.", direction, fmt::join(axis_words, ", ")));
    if (!seen.insert(direction).second) refuse(context.place("directions"), fmt::format("directions contains {} twice; keep one.", direction));
  }
}

void check_displacement(DisplacementSetup& history, const std::string& path, const Context& context) {
  const Places& places = context.places;
  const std::pair<std::string_view, bool> forms[] = {
      {"velocity", history.velocity.has_value()},  {"displacement", history.displacement.has_value()}, {"times", !history.times.empty()},
      {"velocities", !history.velocities.empty()}, {"displacements", !history.displacements.empty()},  {"file", !history.file.empty()}};
  std::string_view first;
  for (const auto& [key, is_given] : forms) {
    if (!is_given) continue;
    if (first.empty()) first = key;
    if (first != key && (first == "velocity" || first == "displacement"))
      refuse(places.of(fmt::format("{}.{}", path, key)),
             fmt::format("{} is given together with {}, which applies at all times; keep one of the two.", key, first));
  }
  if (first.empty()) refuse(places.of(path), fmt::format("{} needs a velocity or a displacement, times with either, or a file.", path));
  if (first == "velocity" || first == "displacement") return;
  check_table(history, path, places);
  read_table(history, false, path, context.folder, places);
}

void check(PrescribedSetup& prescribed, const Context& context) {
  if (!prescribed.x && !prescribed.y && !prescribed.z)
    refuse(context.places.of(context.path), fmt::format("{} prescribes no motion; give x, y or z.", context.path));
  for (std::size_t axis = 0; axis < std::size(axis_words); ++axis)
    if (auto& history = prescribed.of(axis)) check_displacement(*history, fmt::format("{}.{}", context.path, axis_words[axis]), context);
  if (prescribed.z) context.refuse_along_z("z");
}

void check(BodyForceSetup& load, const Context& context) {
  if (load.force_density == Vec3d{})
    refuse(context.place("force_density"), "force_density is [0, 0, 0], which has no effect; give a value, or remove the boundary condition.");
  if (load.force_density.z != 0) context.refuse_along_z("force_density");
  context.check_factors(load.times, load.factors);
}

void refuse_face_along_z(const Choice& face, const Context& context) {
  if (face.word().ends_with('z')) context.refuse_along_z("face");
}

void check(PressureSetup& load, const Context& context) {
  if (load.value == 0) refuse(context.place("value"), "value is 0, which has no effect; give a value, or remove the boundary condition.");
  refuse_face_along_z(load.face, context);
  context.check_factors(load.times, load.factors);
}

void check(FloatingSetup&, const Context& context) { context.refuse_along_z("gravity"); }

void check(AbsorbingSetup& layer, const Context& context) { refuse_face_along_z(layer.face, context); }

}  // namespace

void make_boundary_conditions_consistent(BodySetup& body, const std::filesystem::path& folder, const Places& places) {
  for (BoundaryConditionSetup& boundary : body.boundary_conditions)
    std::visit(
        [&]<class Kind>(Kind& kind) {
          check(kind, {body, fmt::format("bodies.{}.boundary_conditions.{}.{}", body.name, boundary.name, Kind::name), folder, places});
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
  for (const BodySetup& body : setup.bodies) {
    const std::string path = "bodies." + body.name;
    if (body.velocity != Vec3d{})
      refuse(places.of(path + ".velocity"), "velocity is not 0, but relax computes equilibrium states without motion; remove one of the two.");
    if (body.elastic().plasticity)
      refuse(places.of(path + ".material.plasticity"),
             "plasticity depends on the path, but relax computes equilibrium states without a path; remove one of the two.");
    for (const BoundaryConditionSetup& boundary : body.boundary_conditions)
      if (std::holds_alternative<AbsorbingSetup>(boundary.kind))
        refuse(places.of(fmt::format("{}.boundary_conditions.{}.absorbing", path, boundary.name)),
               "absorbing damps waves, but relax computes equilibrium states without motion; remove one of the two.");
  }
}

}  // namespace perimpact::deck
