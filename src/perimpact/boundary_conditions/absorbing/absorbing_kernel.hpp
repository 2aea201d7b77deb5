/// Damping of an absorbing layer on packs of particles (absorbing.hpp).
#pragma once

#include <array>
#include <cstddef>

#include "base/host_device.hpp"
#include "base/pack_functions.hpp"
#include "perimpact/boundary_conditions/actions/damped.hpp"
#include "perimpact/boundary_conditions/actions/listed_eights.hpp"

namespace perimpact {

/// What the kernel of the layer reads and writes.
struct AbsorbingView {
  ParticlesView particles;
  EightsView eights;
  std::array<double*, 3> force;          // [N/m³] by slot
  std::array<const double*, 3> damping;  // [1/s] by place
  ForcesOnTheWay::View latest;
  double density;  // [kg/m³]
  double dt;       // [s]

  template <class Visit>
  void visit_pointers(const Visit& visit) {
    particles.visit_pointers(visit), eights.visit_pointers(visit), latest.visit_pointers(visit);
    for (std::size_t c = 0; c < 3; ++c) visit(force[c]), visit(damping[c]);
  }
};

/// Damps the force densities of the pack at a place.
template <class Pack>
FCCDA_HD ResistanceOfPack<Pack> damp_pack(const AbsorbingView& layer, std::size_t place) {
  using namespace fccda;
  const std::size_t slot = layer.eights.slot(place);
  const unsigned bits = bits_at<Pack>(layer.eights.lanes, place);
  const Pack volume = volume_of_pack<Pack>(layer.particles, slot);
  Vec3<Pack> force, way;
  for (std::size_t c = 0; c < 3; ++c) {
    const Pack before = load<Pack>(layer.force[c] + slot), velocity = load<Pack>(layer.particles.velocity[c] + slot);
    const Pack after = damped(before, velocity, layer.density, load<Pack>(layer.damping[c] + place), layer.dt);
    store(layer.force[c] + slot, choose(bits, after, before));
    force[c] = volume * (after - before), way[c] = Pack(layer.dt) * velocity;
  }
  return layer.latest.record_force(place, bits, force, way);
}

}  // namespace perimpact
