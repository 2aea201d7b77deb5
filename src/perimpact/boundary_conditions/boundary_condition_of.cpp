#include "perimpact/boundary_conditions/boundary_condition_of.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "perimpact/deck_model/setup_error.hpp"

namespace perimpact {

using namespace fccda;

namespace {

struct Face {
  std::size_t axis;
  double sign;  // of its outward normal
  explicit Face(int index) : axis(static_cast<std::size_t>(index / 2)), sign(index % 2 == 0 ? 1 : -1) {}
  Vec3d normal() const {
    Vec3d n{};
    n[axis] = sign;
    return n;
  }
};

/// Key of a boundary condition in the deck, and its particles.
struct Place {
  const BoundedParticles& of;
  std::string key;  ///< "bodies.plate.boundary_conditions.grip.fixed"

  std::vector<std::uint32_t> slots(const std::string& region) const {
    if (region.empty()) return {of.particles.slot_of().begin(), of.particles.slot_of().end()};
    const std::vector<std::size_t> slots = of.slots_of(region, key + ".particle_set");
    return {slots.begin(), slots.end()};
  }

  TimeTable factor(const std::vector<double>& times, const std::vector<double>& factors) const {
    if (times.empty() && factors.empty()) return TimeTable(1);
    return table(key, times, factors);
  }

  static TimeTable table(const std::string& key, const std::vector<double>& times, const std::vector<double>& values) {
    try {
      return TimeTable(times, values);
    } catch (const InputError& error) {
      throw SetupError(key, error.what());
    }
  }
};

Boundary made(const FixedSetup& fixed, const Place& place) {
  PrescribedDisplacement::Histories histories;
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (fixed.directions.empty() || std::find(fixed.directions.begin(), fixed.directions.end(), axis_words[axis]) != fixed.directions.end())
      histories[axis] = DisplacementHistory::rest();
  return PrescribedDisplacement(place.slots(fixed.particle_set), std::move(histories));
}

DisplacementHistory displacement_history_of(const DisplacementSetup& setup, const std::string& key) {
  if (setup.velocity) return {DisplacementHistory::Of::velocity, TimeTable(*setup.velocity)};
  if (setup.displacement) return {DisplacementHistory::Of::displacement, TimeTable(*setup.displacement)};
  if (!setup.velocities.empty()) return {DisplacementHistory::Of::velocity, Place::table(key, setup.times, setup.velocities)};
  return {DisplacementHistory::Of::displacement, Place::table(key, setup.times, setup.displacements)};
}

Boundary made(const PrescribedSetup& prescribed, const Place& place) {
  PrescribedDisplacement::Histories histories;
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (const auto& course = prescribed.of(axis)) histories[axis] = displacement_history_of(*course, fmt::format("{}.{}", place.key, axis_words[axis]));
  return PrescribedDisplacement(place.slots(prescribed.particle_set), std::move(histories));
}

Boundary made(const BodyForceSetup& load, const Place& place) {
  std::vector<std::uint32_t> slots = place.slots(load.particle_set);
  std::vector<double> volumes;
  for (const std::uint32_t slot : slots) volumes.push_back(place.of.particles.volume(slot));
  return Load(std::move(slots), std::move(volumes), place.of.particles, load.force_density, place.factor(load.times, load.factors));
}

/// The outermost particles of a lattice share the area equally, those of a point cloud by volume.
Boundary made(const PressureSetup& load, const Place& place) {
  const Face face(load.face.index);
  const Particles& particles = place.of.particles;
  std::vector<std::uint32_t> slots = place.slots(load.particle_set);
  std::vector<double> areas;
  if (const Lattice* lattice = particles.lattice()) {
    slots = outermost(*lattice, slots, load.face.index);
    const double cell = lattice->spacing * particles.thickness().value_or(lattice->spacing);
    areas.assign(slots.size(), load.area ? *load.area / static_cast<double>(slots.size()) : cell);
  } else {
    if (!load.area)
      throw SetupError(place.key,
                       fmt::format("body {} is a point cloud without faces; give the area [m2] that the particles of the set share.", place.of.body.name));
    double volume = 0;
    for (const std::uint32_t slot : slots) volume += particles.volume(slot);
    for (const std::uint32_t slot : slots) areas.push_back(*load.area * particles.volume(slot) / volume);
  }
  return Load(std::move(slots), std::move(areas), particles, -load.value * face.normal(), place.factor(load.times, load.factors));
}

Boundary made(const FloatingSetup& floating, const Place& place) {
  const Particles& particles = place.of.particles;
  std::vector<std::uint32_t> slots = place.slots(floating.particle_set);
  Water water{.level = floating.level.value_or(0),
              .density = floating.density,
              .gravity = floating.gravity,
              .drag = floating.drag,
              .added_mass = floating.added_mass,
              .damping = floating.damping};
  const std::optional<double> floats_at = floating_level(particles, slots, water);
  if (!floating.level) {
    if (!floats_at)
      throw SetupError(place.key,
                       fmt::format("body {} of {} kg/m3 sinks in water of {} kg/m3, so that it has no equilibrium level; give the level, or correct a density.",
                                   place.of.body.name, particles.density(), floating.density));
    water.level = *floats_at;
  }
  return Floating(std::move(slots), water, floats_at.value_or(std::numeric_limits<double>::quiet_NaN()));
}

/// The damping is strongest at the end of the layer; if the body continued there, waves from that side would be reflected.
void expect_end_of_body(const AbsorbingSetup& layer, const std::vector<std::uint32_t>& slots, const Place& place) {
  const Lattice* lattice = place.of.particles.lattice();
  if (!lattice) return;
  const Face face(layer.face.index);
  const std::vector<std::uint32_t> ends = outermost(*lattice, slots, layer.face.index);
  std::size_t behind = 0;
  for (const std::uint32_t slot : ends) {
    std::array<int, 3> cell = lattice->cell(slot);
    cell[face.axis] += face.sign > 0 ? 1 : -1;
    const bool is_inside = lattice->contains(cell[0], cell[1], cell[2]);
    behind += is_inside && place.of.particles.is_occupied(lattice->slot(cell[0], cell[1], cell[2])) ? 1 : 0;
  }
  if (2 * behind <= ends.size()) return;
  throw SetupError(place.key, fmt::format("the layer ends where body {} continues towards {}, so that waves from there are reflected at its "
                                          "strongest damping; extend particle set {} to the end of the body, or name the face that it reaches.",
                                          place.of.body.name, layer.face.word(), layer.particle_set));
}

Boundary made(const AbsorbingSetup& layer, const Place& place) {
  const Face face(layer.face.index);
  std::vector<std::uint32_t> slots = place.slots(layer.particle_set);
  expect_end_of_body(layer, slots, place);
  std::vector<double> depths;  // [m] along the face's normal
  for (const std::uint32_t slot : slots) depths.push_back(face.sign * place.of.particles.reference(slot)[face.axis]);
  const auto [first, last] = std::minmax_element(depths.begin(), depths.end());
  const double spacing = place.of.particles.spacing(), inner = *first - 0.5 * spacing, thickness = *last + 0.5 * spacing - inner;
  const double speed = std::sqrt(place.of.elastic.p_wave_modulus() / place.of.particles.density());
  std::vector<double> damping;
  for (const double depth : depths) damping.push_back(layer_damping(depth - inner, thickness, speed, layer.reflection));
  return Absorbing(std::move(slots), damping);
}

}  // namespace

std::vector<std::uint32_t> outermost(const Lattice& lattice, std::span<const std::uint32_t> slots, int face_index) {
  const Face face(face_index);
  std::map<std::array<int, 2>, std::uint32_t> last_of_row;
  for (const std::uint32_t slot : slots) {
    const std::array<int, 3> cell = lattice.cell(slot);
    const std::array<int, 2> row = {cell[(face.axis + 1) % 3], cell[(face.axis + 2) % 3]};
    const auto [found, is_first] = last_of_row.try_emplace(row, slot);
    if (!is_first && face.sign * (cell[face.axis] - lattice.cell(found->second)[face.axis]) > 0) found->second = slot;
  }
  std::vector<std::uint32_t> all;
  for (const auto& entry : last_of_row) all.push_back(entry.second);
  std::sort(all.begin(), all.end());
  return all;
}

NamedBoundaryCondition boundary_condition_of(const BoundaryConditionSetup& boundary, const BoundedParticles& of) {
  return std::visit(
      [&]<class Kind>(const Kind& kind) {
        const Place place{of, fmt::format("bodies.{}.boundary_conditions.{}.{}", of.body.name, boundary.name, Kind::name)};
        return NamedBoundaryCondition{fmt::format("{}.{}", of.body.name, boundary.name), Kind::name, made(kind, place)};
      },
      boundary.kind);
}

}  // namespace perimpact
