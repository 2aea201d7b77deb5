#include "perimpact/boundary_conditions/absorbing/boundary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "perimpact/deck_model/setup_error.hpp"

namespace perimpact {

namespace {

/// The damping is strongest at the end of the layer; if the body continued there, waves from that side would be reflected.
void expect_end_of_body(const AbsorbingSetup& layer, const std::vector<std::uint32_t>& slots, const BoundarySite& site) {
  const Lattice* lattice = site.of.particles.lattice();
  if (!lattice) return;
  const BodyFace face(layer.face.index);
  const Particles& particles = site.of.particles;
  const std::vector<std::uint32_t> ends = outermost(particles, slots, face);
  std::size_t behind = 0;
  for (const std::uint32_t slot : ends) {
    std::array<int, 3> cell = lattice->cell(slot);
    cell[face.axis] += face.sign > 0 ? 1 : -1;
    const bool is_inside = lattice->contains(cell[0], cell[1], cell[2]);
    behind += is_inside && particles.is_occupied(lattice->slot(cell[0], cell[1], cell[2])) ? 1 : 0;
  }
  Ranks& ranks = particles.share().ranks();
  if (2 * ranks.sum(static_cast<std::int64_t>(behind)) <= ranks.sum(static_cast<std::int64_t>(ends.size()))) return;
  throw SetupError(site.key, fmt::format("the layer ends where body {} continues towards {}, so that waves from there are reflected at its "
                                         "strongest damping; extend particle set {} to the end of the body, or name the face that it reaches.",
                                         site.of.body.name, layer.face.word(), layer.particle_set));
}

}  // namespace

Absorbing make_boundary(const AbsorbingSetup& layer, const BoundarySite& site) {
  const BodyFace face(layer.face.index);
  std::vector<std::uint32_t> slots = site.slots(layer.particle_set);
  expect_end_of_body(layer, slots, site);
  std::vector<double> depths;  // [m] along the face's normal
  for (const std::uint32_t slot : slots) depths.push_back(face.sign * site.of.particles.reference(slot)[face.axis]);
  std::array<double, 2> most{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};  // of -depth and depth
  for (const double depth : depths) most[0] = std::max(most[0], -depth), most[1] = std::max(most[1], depth);
  site.of.particles.share().ranks().max(most);
  const double spacing = site.of.particles.spacing(), inner = -most[0] - 0.5 * spacing, thickness = most[1] + 0.5 * spacing - inner;
  const double speed = std::sqrt(site.of.elastic.p_wave_modulus() / site.of.particles.density());
  std::vector<double> damping;
  for (const double depth : depths) damping.push_back(layer_damping(depth - inner, thickness, speed, layer.reflection));
  return Absorbing(std::move(slots), damping);
}

}  // namespace perimpact
