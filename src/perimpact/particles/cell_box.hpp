/// Box of cells of a lattice.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

namespace perimpact {

struct CellBox {
  std::array<int, 3> low{}, high{};  ///< cells low <= cell < high

  int size(std::size_t axis) const { return std::max(0, high[axis] - low[axis]); }
  std::size_t cells() const { return static_cast<std::size_t>(size(0)) * static_cast<std::size_t>(size(1)) * static_cast<std::size_t>(size(2)); }
  bool contains(const std::array<int, 3>& cell) const {
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (cell[axis] < low[axis] || cell[axis] >= high[axis]) return false;
    return true;
  }
  CellBox grown(const std::array<int, 3>& by) const {
    CellBox box = *this;
    for (std::size_t axis = 0; axis < 3; ++axis) box.low[axis] -= by[axis], box.high[axis] += by[axis];
    return box;
  }
  bool operator==(const CellBox&) const = default;
};

inline CellBox intersection(const CellBox& a, const CellBox& b) {
  CellBox box;
  for (std::size_t axis = 0; axis < 3; ++axis) box.low[axis] = std::max(a.low[axis], b.low[axis]), box.high[axis] = std::min(a.high[axis], b.high[axis]);
  return box;
}

}  // namespace perimpact
