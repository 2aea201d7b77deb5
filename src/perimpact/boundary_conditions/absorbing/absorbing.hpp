/// Absorbing layer at the end of a body, which damps outgoing waves: the boundary condition `absorbing`.
///
///   ρ a = F/V - ρ α v,      α = α_L (s/L)²,      α_L = 3 c ln(1/R)/L        [1/s]
///
/// s is the distance from the layer's inner side, L its thickness, c the P-wave speed √((κ + 4µ/3)/ρ). A plane wave at normal incidence decays
/// by exp(-∫ α/(2c) ds), if α is small compared with its frequency; after reflection at the free end, the share R of its amplitude remains.
/// Profile and reflection coefficient R follow Collino and Tsogka (Geophysics 66 (2001) 294), with α/2 in place of their damping, because
/// only the velocity is damped here, not the strain.
///
/// The damping is implicit in the velocity (damped.hpp), so that it does not limit the time step.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "perimpact/boundary_conditions/actions/damped.hpp"
#include "perimpact/boundary_conditions/actions/listed_eights.hpp"
#include "perimpact/boundary_conditions/actions/reaction_ledger.hpp"
#include "perimpact/boundary_conditions/actions/slot_sum.hpp"
#include "perimpact/particles/particles.hpp"

namespace perimpact {

/// α [1/s] at the depth `depth` in a layer of the thickness `thickness` [m].
double layer_damping(double depth, double thickness, double wave_speed, double reflection);

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

class Absorbing {
 public:
  /// `damping`: α [1/s] of each slot.
  Absorbing(std::vector<std::uint32_t> slots, std::span<const double> damping);

  std::span<const std::uint32_t> slots() const { return slots_; }
  Vec3d damping(std::size_t k) const;  ///< [1/s] of the slot with the number k, along x, y and z

  /// Excludes constrained directions from damping. `constrained` ascending.
  void leave_out(std::span<const std::uint32_t> constrained, std::size_t axis);

  AbsorbingView view(Particles& particles, double dt);

  /// Damps the force densities for the next step of dt [s], after all other forces except constraints. Records force and work.
  void damp(Particles& particles, double dt);
  void record(const Resistance& sum);

  template <class Setup>
  static Traffic collectives_in_step(const Setup&) {
    return reduction_of_sums<Resistance>();
  }

  ReactionLedger account;

  template <class Visitor>
  void visit_record(const std::string& name, Visitor&& visit) {
    account.visit_record(name, visit);
    forces_.visit_record(name, slots_, eights_, visit);
  }

 private:
  std::vector<std::uint32_t> slots_;
  ListedEights eights_;
  std::array<std::vector<double>, 3> damping_;  // [1/s] by place, along x, y and z
  ForcesOnTheWay forces_;
};

}  // namespace perimpact
