/// The particles of one body: where they are, how fast, and what pulls at them.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "perimpact/particles/lattice.hpp"
#include "perimpact/particles/slot_array.hpp"

namespace perimpact {

class Particles {
 public:
  /// One particle in each cell whose centre is `inside`. `reach`: how many cells the stencil will reach in each direction.
  Particles(const Lattice& lattice, int reach, double density, const std::function<bool(const Vec3d&)>& inside);

  /// Takes particles out of the body, as if their cells had not been inside the solid. `slots` ascending. Families made before do not
  /// know of it.
  void remove(std::span<const std::size_t> slots);

  const Lattice& lattice() const { return lattice_; }
  std::size_t size() const { return slot_of_.size(); }                 ///< number of particles
  std::span<const std::uint32_t> slot_of() const { return slot_of_; }  ///< slot of each particle, ascending
  bool is_occupied(std::size_t slot) const { return (occupied_[slot / 8] >> (slot % 8)) & 1u; }

  double density() const { return density_; }                                                 ///< [kg/m³]
  double volume() const { return lattice_.spacing * lattice_.spacing * lattice_.spacing; }    ///< [m³] of one particle
  double mass() const { return density_ * volume(); }                                         ///< [kg] of one particle
  std::size_t slack() const { return slack_; }                                                ///< of fields over these slots
  Vec3d reference(std::size_t slot) const { return lattice_.centre(slot); }                   ///< [m] X
  Vec3d displacement(std::size_t slot) const { return position.at(slot) - reference(slot); }  ///< [m] u = x - X

  VectorArray position;       ///< [m] x
  VectorArray velocity;       ///< [m/s] v, half a step behind the positions' next change (symplectic Euler)
  VectorArray force_density;  ///< [N/m³] of all forces at `position`

  template <class Visitor>
  void visit_state(const std::string& name, Visitor&& visit) {
    constexpr const char* axis[] = {"_x", "_y", "_z"};
    for (std::size_t c = 0; c < 3; ++c) visit(name + ".position" + axis[c], std::span<double>(position.component(c), lattice_.slots()));
    for (std::size_t c = 0; c < 3; ++c) visit(name + ".velocity" + axis[c], std::span<double>(velocity.component(c), lattice_.slots()));
    for (std::size_t c = 0; c < 3; ++c) visit(name + ".force_density" + axis[c], std::span<double>(force_density.component(c), lattice_.slots()));
  }

 private:
  Lattice lattice_;
  std::size_t slack_;
  double density_;
  std::vector<std::uint8_t> occupied_;
  std::vector<std::uint32_t> slot_of_;
};

}  // namespace perimpact
