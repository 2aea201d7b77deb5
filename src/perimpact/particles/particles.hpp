/// Particles of one body: positions, velocities and force densities.
///
/// Arrays run over *slots*: cells of a lattice or points of a cloud, padded to packs of eight. `slot_of` skips slots without a particle.
/// In a run of several ranks they are those of this rank: the slots of its share, which owns some of their particles; the others are ghosts.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "perimpact/particles/cloud.hpp"
#include "perimpact/particles/crushed_material.hpp"
#include "perimpact/particles/lattice.hpp"
#include "perimpact/particles/particles_view.hpp"
#include "perimpact/particles/share.hpp"
#include "perimpact/particles/slot_array.hpp"

namespace perimpact {

/// Density of a body's particles.
struct Density {
  Density(double of_material, double scaling = 1) : material(of_material), mass_scaling(scaling) {}
  double of_inertia() const { return mass_scaling * material; }

  double material;      ///< [kg/m³] of weight
  double mass_scaling;  ///< [-] inertia over the mass of the material
};

class Particles {
 public:
  /// One particle in each cell that is `inside`: 1 for each slot with a particle, else 0. `reach`: of the stencil, in cells per direction.
  Particles(const Lattice& lattice, int reach, Density density, std::span<const std::uint8_t> inside) : Particles(lattice, reach, density, inside, Share()) {}
  /// The same of a share, whose lattice that is.
  Particles(const Lattice& lattice, int reach, Density density, std::span<const std::uint8_t> inside, Share share);
  /// The same for each cell whose centre is `inside`.
  Particles(const Lattice& lattice, int reach, Density density, const std::function<bool(const Vec3d&)>& inside);

  /// One particle per point, in the same order; those of a share of the cloud.
  Particles(const Cloud& cloud, Density density, const Share& share = Share());

  /// Moves the lattice of the body to that first cell, and all particles to the centres of their cells.
  void move_lattice(const std::array<int, 3>& first);

  /// Removes particles, as if their cells were outside the solid. `slots` ascending, owned. Existing families are not updated. Collective.
  void remove(std::span<const std::size_t> slots);

  const Share& share() const { return share_; }
  /// Numbers of all particles of the body, `components` of each, in order, from those by slot of this rank; on the root, elsewhere empty. Collective.
  template <class T>
  std::vector<T> gather(std::span<const T> of_slots, std::size_t components) const;
  /// Number of particles of the body, on all ranks. Collective.
  std::size_t size_of_body() const { return static_cast<std::size_t>(share_.ranks().sum(static_cast<std::int64_t>(size()))); }
  /// Lattice of the body on all ranks; null for a point cloud.
  const Lattice* whole_lattice() const { return share_.is_of_lattice() ? &share_.whole() : lattice(); }
  std::size_t slots_of_whole() const { return share_.is_whole() ? slots() : share_.slots_of_whole(); }  ///< of the body on all ranks
  /// Positions and velocities of ghosts become those of their owners; in the second form when the refresh is completed (Share::begin_refresh).
  void refresh_ghosts();
  void begin_refresh_ghosts();

  const Lattice* lattice() const { return lattice_ ? &*lattice_ : nullptr; }  ///< null for a point cloud
  std::size_t slots() const { return slots_; }                                ///< length of the arrays; a multiple of eight
  std::size_t row_slots() const { return row_slots_; }                        ///< of a row of the lattice; of a cloud, of a block of it
  std::size_t rows() const { return (slots_ + row_slots_ - 1) / row_slots_; }
  std::size_t size() const { return slot_of_.size(); }                 ///< number of owned particles
  std::span<const std::uint32_t> slot_of() const { return slot_of_; }  ///< slot of each owned particle, ascending
  bool is_occupied(std::size_t slot) const { return (occupied_[slot / 8] >> (slot % 8)) & 1u; }
  std::uint8_t occupied(std::size_t eight) const { return occupied_[eight]; }  ///< bit l: of slot 8·eight + l, also of ghosts
  bool owns(std::size_t slot) const { return is_occupied(slot) && is_owned_eight(slot / 8); }
  /// True for eights whose particles are owned; all, unless the body is shared by ranks.
  bool is_owned_eight(std::size_t eight) const { return owned_eights_.empty() || owned_eights_[eight] != 0; }
  /// Slots of the owned cells of a row; an empty range for rows of ghosts.
  struct Range {
    std::size_t begin, end;
  };
  Range owned_slots(std::size_t row) const;
  /// Those of them whose bonds reach no ghost; requires a partial share.
  Range interior_slots(std::size_t row) const;

  double density() const { return inertia_; }                                                 ///< [kg/m³] of inertia
  double material_density() const { return density_.material; }                               ///< [kg/m³] of weight
  double mass_scaling() const { return density_.mass_scaling; }                               ///< [-] the ratio of both
  double spacing() const { return spacing_; }                                                 ///< [m] of the lattice; for a cloud, the mean particle size
  double volume(std::size_t slot) const { return lattice_ ? cell_volume_ : volumes_[slot]; }  ///< [m³]
  double mass(std::size_t slot) const { return inertia_ * volume(slot); }                     ///< [kg] of inertia
  double material_mass(std::size_t slot) const { return density_.material * volume(slot); }   ///< [kg] of weight
  double total_mass() const;                                                                  ///< [kg] of the material
  double size_of(std::size_t slot) const;                                                     ///< [m] edge of a cube of its volume; of a square in a plane body
  bool is_plane() const { return thickness_.has_value(); }                                    ///< all forces and velocities lie in the plane z
  std::optional<double> thickness() const { return thickness_; }                              ///< [m] of a plane body
  std::span<const std::uint32_t> numbers() const { return numbers_; }                         ///< Cloud::numbers by slot; empty without
  std::size_t slack() const { return slack_; }                                                ///< of fields over these slots
  Vec3d reference(std::size_t slot) const { return lattice_ ? lattice_->centre(slot) : reference_[slot]; }  ///< [m] X
  Vec3d displacement(std::size_t slot) const { return position.at(slot) - reference(slot); }                ///< [m] u = x - X

  /// Calls visit(span) for each array of particles on a lattice that kernels read or write.
  template <class Visit>
  void visit_arrays(const Visit& visit) const {
    for (const VectorArray* array : {&position, &velocity, &force_density}) visit(array->with_slack());
    visit(std::span(occupied_));
  }
  /// Valid until particles are moved or copied.
  ParticlesView view() const { return {position.pointers(), velocity.pointers(), occupied_.data(), lattice_ ? nullptr : volumes_.data(), cell_volume_}; }

  VectorArray position;       ///< [m] x
  VectorArray velocity;       ///< [m/s] v at mid-step (symplectic Euler)
  VectorArray force_density;  ///< [N/m³] sum of all forces at `position`

  CrushedMaterial crushed;  ///< by impactors

  template <class Visitor>
  void visit_state(const std::string& name, Visitor&& visit) {
    constexpr const char* axis[] = {"_x", "_y", "_z"};
    for (std::size_t c = 0; c < 3; ++c) visit(name + ".position" + axis[c], std::span<double>(position.component(c), slots_));
    for (std::size_t c = 0; c < 3; ++c) visit(name + ".velocity" + axis[c], std::span<double>(velocity.component(c), slots_));
    for (std::size_t c = 0; c < 3; ++c) visit(name + ".force_density" + axis[c], std::span<double>(force_density.component(c), slots_));
    crushed.visit_state(name, visit);
  }

 private:
  void mark_owned_eights();
  void number_particles();

  Share share_;
  std::optional<Lattice> lattice_;
  std::size_t slots_, row_slots_, slack_;
  Density density_;
  double inertia_, spacing_;  // [kg/m³], [m]
  std::optional<double> thickness_;
  double cell_volume_ = 0;              // of a lattice
  std::vector<Vec3d> reference_;        // of a cloud
  std::vector<double> volumes_;         // of a cloud
  std::vector<std::uint32_t> numbers_;  // of a cloud
  std::vector<std::uint8_t> occupied_;
  std::vector<std::uint8_t> owned_eights_;  // 1 for eights that are owned; empty if all are
  std::vector<std::uint32_t> slot_of_;
};

template <class T>
std::vector<T> Particles::gather(std::span<const T> of_slots, std::size_t components) const {
  const std::vector<T> all = share_.gather(of_slots, {.each = fccda::byte_lanes * components});
  const std::vector<std::uint8_t> occupied = share_.gather(std::span<const std::uint8_t>(occupied_), {.each = 1});
  std::vector<T> particles;
  for (std::size_t eight = 0; eight < occupied.size() && !all.empty(); ++eight)
    fccda::for_each_bit(occupied[eight], [&](std::size_t lane) {
      const auto first = all.begin() + static_cast<std::ptrdiff_t>((eight * fccda::byte_lanes + lane) * components);
      particles.insert(particles.end(), first, first + static_cast<std::ptrdiff_t>(components));
    });
  return particles;
}

inline Particles::Range Particles::owned_slots(std::size_t row) const {
  const std::size_t begin = row * row_slots_, end = begin + row_slots_ < slots_ ? begin + row_slots_ : slots_;
  if (owned_eights_.empty()) return {begin, end};
  std::size_t first = begin, last = end;
  while (first < end && owned_eights_[first / 8] == 0) first += 8;
  while (last > first && owned_eights_[last / 8 - 1] == 0) last -= 8;
  return {first, last};
}

inline Particles::Range Particles::interior_slots(std::size_t row) const {
  if (!lattice_) {
    const Range owned = owned_slots(row);
    for (std::size_t eight = owned.begin / 8; eight < owned.end / 8; ++eight)
      if (share_.reads_ghosts(eight)) return {owned.begin, owned.begin};
    return owned;
  }
  const CellBox box = share_.interior();
  const std::size_t per_layer = static_cast<std::size_t>(lattice_->cells[1]);
  const auto j = static_cast<int>(row % per_layer), k = static_cast<int>(row / per_layer);
  if (j < box.low[1] || j >= box.high[1] || k < box.low[2] || k >= box.high[2]) return {0, 0};
  const Range owned = owned_slots(row);
  const std::size_t begin = row * row_slots_ + static_cast<std::size_t>(box.low[0]);
  return {begin, std::max(begin, box.high[0] == lattice_->cells[0] ? owned.end : row * row_slots_ + static_cast<std::size_t>(box.high[0]))};
}

/// [m] bounding box of all particles of the body, each with half a spacing around it. Collective.
Vec3d extent(const Particles& particles);

}  // namespace perimpact
