/// Columns of a lattice body in water: the particles above one another in the initial position.
///
/// Forces of water that belong to an area of the sheet, and not to a particle, act on columns: the water that it entrains, and the air above
/// a top that is still dry (docs/theory/floating_bodies.md).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "perimpact/boundary_conditions/actions/listed_eights.hpp"
#include "perimpact/particles/particles.hpp"

namespace perimpact {

/// Columns as kernels see them.
struct ColumnsView {
  std::size_t count = 0;
  const std::uint32_t* begin = nullptr;    ///< of the eights of each stack in `members`
  const std::uint32_t* members = nullptr;  ///< eights above one another, by their numbers in the list, upward

  template <class Visit>
  void visit_pointers(const Visit& visit) {
    visit(begin), visit(members);
  }
};

/// Columns are numbered by the slots of the lowest layer of the lattice: column c has the slots c, c + count(), …. Particles are named by their places.
class WaterColumns {
 public:
  static constexpr std::uint32_t none = 0xffffffff;

  /// Of a body on a lattice.
  WaterColumns(const Particles& particles, const ListedEights& eights);

  std::size_t count() const { return tops_.size(); }
  std::size_t column_of(std::size_t slot) const { return slot % tops_.size(); }
  /// The uppermost particle, if it is also that of the body; else none.
  std::uint32_t top(std::size_t column) const { return tops_[column]; }
  std::span<const double> layers() const { return layers_; }  ///< number of particles of each column
  template <class Visit>
  void visit_arrays(const Visit& visit) const {
    visit(std::span(begin_)), visit(std::span(members_));
  }
  ColumnsView view() const { return {tops_.size(), begin_.data(), members_.data()}; }

 private:
  std::vector<std::uint32_t> tops_, begin_, members_;
  std::vector<double> layers_;
};

}  // namespace perimpact
