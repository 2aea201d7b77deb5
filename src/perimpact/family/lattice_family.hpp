/// The bonds of a body on a lattice: one bit a bond, kept at both of its ends and always equal there.
///
/// For eight neighbouring slots the bits of one stencil bond are one byte, and the bytes of the stencil follow one another:
/// the kernel reads a byte where it needs the mask of a pack, and no neighbour is ever stored.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "perimpact/family/stencil.hpp"
#include "perimpact/particles/particles.hpp"

namespace perimpact {

class LatticeFamily {
 public:
  /// All bonds between particles of the body are intact.
  LatticeFamily(Stencil stencil, const Particles& particles);

  const Stencil& stencil() const { return stencil_; }
  std::span<const std::ptrdiff_t> offsets() const { return offsets_; }  ///< in slots, of each stencil bond

  /// The bytes of slots 8·eight … 8·eight + 7, one a stencil bond; bit l belongs to slot 8·eight + l.
  std::uint8_t* bytes(std::size_t eight) { return bits_.data() + eight * stencil_.size(); }
  const std::uint8_t* bytes(std::size_t eight) const { return bits_.data() + eight * stencil_.size(); }
  bool is_intact(std::size_t slot, std::size_t bond) const { return (bytes(slot / 8)[bond] >> (slot % 8)) & 1u; }

  std::size_t initial_bonds() const { return initial_bonds_; }  ///< each counted once
  std::size_t intact_bonds() const;                             ///< each counted once

  double initial_volume(std::size_t slot) const { return initial_volume_[slot]; }  ///< [m³] Σ v V over the family before any bond broke
  double intact_volume(std::size_t slot) const;                                    ///< [m³] the same over intact bonds
  /// φ = 1 - Σ µ v V / Σ v V [-] (Silling and Askari 2005); 0 for a particle that never had a bond.
  double damage(std::size_t slot) const;

  template <class Visitor>
  void visit_state(const std::string& name, Visitor&& visit) {
    visit(name + ".bonds", std::span<std::uint8_t>(bits_));
  }

 private:
  Stencil stencil_;
  std::vector<std::ptrdiff_t> offsets_;
  std::vector<std::uint8_t> bits_;
  std::vector<double> initial_volume_;
  std::size_t initial_bonds_ = 0;
};

}  // namespace perimpact
