/// Particles of one body: positions, velocities and force densities.
///
/// Arrays run over *slots*: cells of a lattice or points of a cloud, padded to packs of eight. `slot_of` skips slots without a particle.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "perimpact/particles/cloud.hpp"
#include "perimpact/particles/lattice.hpp"
#include "perimpact/particles/slot_array.hpp"

namespace perimpact {

class Particles {
 public:
  /// One particle in each cell that is `inside`: 1 for each slot with a particle, else 0. `reach`: of the stencil, in cells per direction.
  Particles(const Lattice& lattice, int reach, double density, std::span<const std::uint8_t> inside);
  /// The same for each cell whose centre is `inside`.
  Particles(const Lattice& lattice, int reach, double density, const std::function<bool(const Vec3d&)>& inside);

  /// One particle per point, in the same order.
  Particles(const Cloud& cloud, double density);

  /// Moves the lattice to that first cell, and all particles to the centres of their cells.
  void move_lattice(const std::array<int, 3>& first);

  /// Removes particles, as if their cells were outside the solid. `slots` ascending. Existing families are not updated.
  void remove(std::span<const std::size_t> slots);

  const Lattice* lattice() const { return lattice_ ? &*lattice_ : nullptr; }  ///< null for a point cloud
  std::size_t slots() const { return slots_; }                                ///< length of the arrays; a multiple of eight
  std::size_t row_slots() const { return row_slots_; }                        ///< of a row of the lattice; of a cloud, of a block of it
  std::size_t rows() const { return (slots_ + row_slots_ - 1) / row_slots_; }
  std::size_t size() const { return slot_of_.size(); }                 ///< number of particles
  std::span<const std::uint32_t> slot_of() const { return slot_of_; }  ///< slot of each particle, ascending
  bool is_occupied(std::size_t slot) const { return (occupied_[slot / 8] >> (slot % 8)) & 1u; }
  std::uint8_t occupied(std::size_t eight) const { return occupied_[eight]; }  ///< bit l: of slot 8·eight + l

  double density() const { return density_; }                                                 ///< [kg/m³]
  double spacing() const { return spacing_; }                                                 ///< [m] of the lattice; for a cloud, the mean particle size
  double volume(std::size_t slot) const { return lattice_ ? cell_volume_ : volumes_[slot]; }  ///< [m³]
  double mass(std::size_t slot) const { return density_ * volume(slot); }                     ///< [kg]
  double total_mass() const;                                                                  ///< [kg]
  double size_of(std::size_t slot) const;                                                     ///< [m] edge of a cube of its volume; of a square in a plane body
  bool is_plane() const { return thickness_.has_value(); }                                    ///< all forces and velocities lie in the plane z
  std::optional<double> thickness() const { return thickness_; }                              ///< [m] of a plane body
  std::span<const std::uint32_t> numbers() const { return numbers_; }                         ///< Cloud::numbers, of the first slots
  std::size_t slack() const { return slack_; }                                                ///< of fields over these slots
  Vec3d reference(std::size_t slot) const { return lattice_ ? lattice_->centre(slot) : reference_[slot]; }  ///< [m] X
  Vec3d displacement(std::size_t slot) const { return position.at(slot) - reference(slot); }                ///< [m] u = x - X

  VectorArray position;       ///< [m] x
  VectorArray velocity;       ///< [m/s] v at mid-step (symplectic Euler)
  VectorArray force_density;  ///< [N/m³] sum of all forces at `position`

  template <class Visitor>
  void visit_state(const std::string& name, Visitor&& visit) {
    constexpr const char* axis[] = {"_x", "_y", "_z"};
    for (std::size_t c = 0; c < 3; ++c) visit(name + ".position" + axis[c], std::span<double>(position.component(c), slots_));
    for (std::size_t c = 0; c < 3; ++c) visit(name + ".velocity" + axis[c], std::span<double>(velocity.component(c), slots_));
    for (std::size_t c = 0; c < 3; ++c) visit(name + ".force_density" + axis[c], std::span<double>(force_density.component(c), slots_));
  }

 private:
  void number_particles();

  std::optional<Lattice> lattice_;
  std::size_t slots_, row_slots_, slack_;
  double density_, spacing_;
  std::optional<double> thickness_;
  double cell_volume_ = 0;              // of a lattice
  std::vector<Vec3d> reference_;        // of a cloud
  std::vector<double> volumes_;         // of a cloud
  std::vector<std::uint32_t> numbers_;  // of a cloud
  std::vector<std::uint8_t> occupied_;
  std::vector<std::uint32_t> slot_of_;
};

/// [m] bounding box of all particles, each with half a spacing around it.
Vec3d extent(const Particles& particles);

}  // namespace perimpact
