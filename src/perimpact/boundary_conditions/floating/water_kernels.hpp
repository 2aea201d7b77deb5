/// Forces of still water on packs of particles (floating.hpp).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "base/host_device.hpp"
#include "base/pack_functions.hpp"
#include "perimpact/boundary_conditions/actions/damped.hpp"
#include "perimpact/boundary_conditions/actions/listed_eights.hpp"
#include "perimpact/boundary_conditions/floating/water_columns.hpp"

namespace perimpact {

/// Still water and its effect on particles.
struct Water {
  double level;                ///< [m] z of the free surface
  double density;              ///< [kg/m³]
  double gravity;              ///< [m/s²] along -z
  double drag;                 ///< [-] C_d
  double added_mass;           ///< [-] C_a
  double damping;              ///< [1/s] α
  double entrained_depth = 0;  ///< [m] d
  double dry_top = 0;          ///< [m] depth below the level down to which the top of a whole column stays dry

  /// t of a particle of that height [m] at z [m]: 0 where it just emerges, 1 where it just submerges.
  template <class Pack>
  FCCDA_HD Pack immersion(Pack z, Pack height) const {
    return (Pack(level) - z) / height + Pack(0.5);
  }
  /// Its submerged share.
  template <class Pack>
  FCCDA_HD Pack submerged(Pack z, Pack height) const {
    return fccda::smaller(Pack(1.0), fccda::larger(Pack(0.0), immersion(z, height)));
  }
  /// Whether a dry top at z lies deeper than it stays dry.
  FCCDA_HD bool floods(double z, double height) const { return level - z - 0.5 * height > dry_top; }
  FCCDA_HD bool adds_mass() const { return added_mass != 0 || entrained_depth != 0; }
};

/// What the kernels of water read and write.
struct WaterView {
  ParticlesView particles;
  EightsView eights;
  ColumnsView columns;
  std::array<double*, 3> force;              // [N/m³] by slot
  std::array<const std::uint8_t*, 3> moves;  // of each eight: the directions that are not constrained
  const std::uint8_t* exposed;               // of each eight: drag acts
  const std::uint8_t* in_contact;            // of each eight: no added mass
  const std::uint8_t* is_dry;                // by place: the top of a column that is dry there; null without a dry top
  const double* intact;                      // [-] by place: 1 - D; null without an entrained depth
  double* wetness;                           // [-] W of each column; null without an entrained depth
  const double* carriers;                    // of each column: its particles that neither contact nor a constraint moves; null without an entrained depth
  ForcesOnTheWay::View latest;
  const double* heights;  // [m] by slot, of a point cloud; null on a lattice
  double height;          // [m] of each particle of a lattice
  double density;         // [kg/m³] of the inertia of the body
  double weight;          // [N/m³] of the body
  Water water;

  template <class Visit>
  void visit_pointers(const Visit& visit) {
    particles.visit_pointers(visit), eights.visit_pointers(visit), columns.visit_pointers(visit), latest.visit_pointers(visit);
    for (std::size_t c = 0; c < 3; ++c) visit(force[c]), visit(moves[c]);
    visit(exposed), visit(in_contact), visit(is_dry), visit(intact), visit(wetness), visit(carriers), visit(heights);
  }

  template <class Pack>
  FCCDA_HD Pack heights_at(std::size_t slot) const {
    return heights ? fccda::load<Pack>(heights + slot) : Pack(height);
  }
  template <class Pack>
  FCCDA_HD unsigned dry_at(std::size_t place) const {
    unsigned bits = 0;
    if (is_dry)
      for (std::size_t lane = 0; lane < fccda::lanes<Pack>; ++lane) bits |= unsigned{is_dry[place + lane]} << lane;
    return bits;
  }
  /// The particles of a pack on which more than weight and buoyancy acts. Drag acts on few of a thick body.
  template <class Pack>
  FCCDA_HD unsigned resisted_at(std::size_t place) const {
    const unsigned all = bits_at<Pack>(eights.lanes, place);
    return water.damping != 0 || water.adds_mass() ? all : all & bits_at<Pack>(exposed, place);
  }
};

/// Weight and buoyancy of each particle of a pack, and their potential.
template <class Pack>
struct HydrostaticsOfPack {
  Pack lift, potential;  ///< [N] [J]
};

/// Adds weight and buoyancy to the force densities of the pack at a place.
template <class Pack>
FCCDA_HD HydrostaticsOfPack<Pack> lift_pack(const WaterView& body, std::size_t place) {
  using namespace fccda;
  const std::size_t slot = body.eights.slot(place);
  const unsigned all = bits_at<Pack>(body.eights.lanes, place), dry = body.dry_at<Pack>(place);
  const double weight = body.weight, lift = body.water.density * body.water.gravity;  // [N/m³]
  const Pack z = load<Pack>(body.particles.position[2] + slot), height = body.heights_at<Pack>(slot), volume = volume_of_pack<Pack>(body.particles, slot);
  const Pack t = body.water.immersion(z, height), zero(0.0), one(1.0);
  // ∫ S dz/Δ from the particle upward
  const Pack below = choose(dry | bits_where_greater(one, t), Pack(0.5) * t * t, t - Pack(0.5)), column = choose(bits_where_greater(t, zero), below, zero);
  const Pack share = larger(zero, t), net = Pack(lift) * choose(dry, share, smaller(one, share)) - Pack(weight);
  double* const force = body.force[2] + slot;
  const Pack before = load<Pack>(force);
  store(force, choose(all, before + net, before));
  return {select(all, volume * net), select(all, volume * (Pack(weight) * z + Pack(lift) * height * column))};
}

/// Updates W of the columns of a pack.
template <class Pack>
FCCDA_HD void wet_pack(const WaterView& body, std::size_t column) {
  using namespace fccda;
  Pack wetness(0.0);
  const std::uint32_t* const begin = body.columns.begin + column / byte_lanes;
  for (std::uint32_t member = begin[0]; member < begin[1]; ++member) {
    const std::size_t place = std::size_t{body.columns.members[member]} * byte_lanes + column % byte_lanes, slot = body.eights.slot(place);
    const Pack wet = body.water.submerged(load<Pack>(body.particles.position[2] + slot), body.heights_at<Pack>(slot));
    wetness = larger(select(bits_at<Pack>(body.eights.lanes, place), wet), wetness);
  }
  store(body.wetness + column, wetness);
}

/// [kg/m³] of the water that the particles of a pack, of which that share is submerged, move along.
template <class Pack>
FCCDA_HD Pack entrained_by_pack(const WaterView& body, std::size_t place, std::size_t slot, Pack height, Pack wet) {
  using namespace fccda;
  if (body.water.entrained_depth == 0) return Pack(body.water.added_mass * body.water.density) * wet;
  const std::size_t column = slot % body.columns.count;
  return Pack(body.water.density * body.water.entrained_depth) * load<Pack>(body.wetness + column) * load<Pack>(body.intact + place) /
         (load<Pack>(body.carriers + column) * height);
}

/// Applies drag, damping and added mass in a step of dt [s] to the pack at a place.
template <class Pack>
FCCDA_HD ResistanceOfPack<Pack> resist_pack(const WaterView& body, std::size_t place, double dt) {
  using namespace fccda;
  const unsigned resisted = body.resisted_at<Pack>(place);
  if (resisted == 0) return {};
  const Water& water = body.water;
  const std::size_t slot = body.eights.slot(place);
  Vec3<Pack> velocity, before, after;
  for (std::size_t c = 0; c < 3; ++c) velocity[c] = load<Pack>(body.particles.velocity[c] + slot), before[c] = load<Pack>(body.force[c] + slot);
  const Pack height = body.heights_at<Pack>(slot), volume = volume_of_pack<Pack>(body.particles, slot);
  const Pack wet = water.submerged(load<Pack>(body.particles.position[2] + slot), height);
  const unsigned drags = bits_at<Pack>(body.exposed, place) & bits_where_greater(wet, Pack(0.0));
  const Pack drag = Pack(0.5 * water.density * water.drag) * height * height * wet * square_root(dot(velocity, velocity)) / (Pack(body.density) * volume);
  const Pack damping = Pack(water.damping) + select(drags, drag);
  for (std::size_t c = 0; c < 3; ++c)
    after[c] = choose(resisted & bits_at<Pack>(body.moves[c], place), damped(before[c], velocity[c], body.density, damping, dt), before[c]);
  if (water.adds_mass()) {
    const Pack share = Pack(body.density) / (Pack(body.density) + entrained_by_pack(body, place, slot, height, wet));
    after.z = choose(resisted & bits_at<Pack>(body.moves[2], place) & ~bits_at<Pack>(body.in_contact, place), after.z * share, after.z);
  }
  for (std::size_t c = 0; c < 3; ++c) store(body.force[c] + slot, after[c]);
  return body.latest.record_force(place, resisted, volume * (after - before), Pack(dt) * velocity);
}

}  // namespace perimpact
