/// Columns of a lattice body in water: the particles above one another in the initial position.
///
/// Forces of water that belong to an area of the sheet, and not to a particle, act on columns: the water that it entrains, and the air above
/// a top that is still dry (docs/theory/floating_bodies.md).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "perimpact/particles/particles.hpp"

namespace perimpact {

class WaterColumns {
 public:
  static constexpr std::uint32_t none = 0xffffffff;

  /// Of a body on a lattice; `slots` ascending. Particles are named by their index in `slots`.
  WaterColumns(const Particles& particles, std::span<const std::uint32_t> slots);

  std::size_t count() const { return tops_.size(); }
  std::size_t column_of(std::size_t particle) const { return column_of_[particle]; }
  /// Particles of a column, upward.
  std::span<const std::uint32_t> particles_of(std::size_t column) const { return {members_.data() + begin_[column], begin_[column + 1] - begin_[column]}; }
  /// The uppermost particle, if it is also that of the body; else none.
  std::uint32_t top(std::size_t column) const { return tops_[column]; }

 private:
  std::vector<std::uint32_t> column_of_, members_;
  std::vector<std::size_t> begin_;
  std::vector<std::uint32_t> tops_;
};

}  // namespace perimpact
