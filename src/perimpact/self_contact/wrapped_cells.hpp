/// Linked cells (cell list) with periodic indices, for neighbour search. The indices of the cubes wrap around a table of fixed size, so that
/// distant fragments cost no memory. Distant cubes may share a cell of the table; the search compares distances in any case.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/pack.hpp"
#include "base/vec3.hpp"
#include "perimpact/particles/slot_array.hpp"

namespace perimpact {

using fccda::Vec3d;

/// Squared distances [m²] of `place` from a pack of points, which begins at `first`. The array is padded to full packs.
template <class Pack>
Pack squared_distances(const VectorArray& points, std::size_t first, const Vec3d& place) {
  const std::array<const double*, 3> x = points.pointers();
  const Pack dx = fccda::load<Pack>(x[0] + first) - Pack(place.x), dy = fccda::load<Pack>(x[1] + first) - Pack(place.y),
             dz = fccda::load<Pack>(x[2] + first) - Pack(place.z);
  return fccda::fused_multiply_add(dz, dz, fccda::fused_multiply_add(dy, dy, dx * dx));
}

class WrappedCells {
 public:
  /// `edge` [m]: points nearer than this lie in the same cell or in cells around it.
  void sort(const VectorArray& points, double edge);

  std::size_t size() const { return first_.empty() ? 0 : first_.size() - 1; }  ///< cells of the table
  std::uint32_t cell_of(std::size_t point) const { return cell_of_[point]; }   ///< cell that contains the point
  std::span<const std::uint32_t> points_in(std::size_t cell) const { return {points_.data() + first_[cell], first_[cell + 1] - first_[cell]}; }  ///< ascending

  /// Calls visit(point) for the points in the cell with a squared distance below `squared` [m²] from `place`, in ascending order. `among(first)`: bits of those
  /// to consider, of a pack of points in the order of points_by_cell() that begins at `first`.
  template <class Among, class Visit>
  void for_each_within(std::size_t cell, const Vec3d& place, double squared, const Among& among, const Visit& visit) const {
    using Pack = fccda::NativePack;
    for (std::size_t first = first_[cell]; first < first_[cell + 1]; first += fccda::lanes<Pack>) {
      unsigned near = fccda::bits_where_greater(Pack(squared), squared_distances<Pack>(sorted_, first, place));
      if (first_[cell + 1] - first < fccda::lanes<Pack>) near &= (1u << (first_[cell + 1] - first)) - 1u;
      if (near != 0) near &= among(first);
      fccda::for_each_bit(near, [&](std::size_t lane) { visit(points_[first + lane]); });
    }
  }
  std::span<const std::uint32_t> points_by_cell() const { return points_; }  ///< all points, cell by cell

  /// Calls visit(cell) for the cell and its neighbours, each once. `rings`: 1; with 2 the neighbours of these as well.
  template <class Visit>
  void for_each_around(std::size_t cell, const Visit& visit, std::size_t rings = 1) const {
    const std::array<std::size_t, 3> at = {cell & mask(0), (cell >> bits_[0]) & mask(1), cell >> (bits_[0] + bits_[1])};
    for (std::size_t dz = 0; dz < steps(2, rings); ++dz)
      for (std::size_t dy = 0; dy < steps(1, rings); ++dy)
        for (std::size_t dx = 0; dx < steps(0, rings); ++dx) {
          const std::size_t x = (at[0] + dx - rings) & mask(0), y = (at[1] + dy - rings) & mask(1), z = (at[2] + dz - rings) & mask(2);
          visit((z << (bits_[0] + bits_[1])) | (y << bits_[0]) | x);
        }
  }

 private:
  std::size_t mask(std::size_t axis) const { return (std::size_t{1} << bits_[axis]) - 1; }
  std::size_t steps(std::size_t axis, std::size_t rings) const { return std::min(mask(axis) + 1, 2 * rings + 1); }

  std::array<unsigned, 3> bits_{};  // of the number of cells along each axis: 0, or 2 at least, so that the neighbours of a cell are distinct
  std::vector<std::uint32_t> cell_of_, first_, points_;
  VectorArray sorted_;  // [m] the points, cell by cell
};

}  // namespace perimpact
