/// Regular lattice of cells with one particle per cell: the discretisation of solids.
///
/// Cells are stored x fastest, and rows are padded to packs of eight, so that a row loads as contiguous SIMD lanes and a neighbour is at a
/// constant offset. The memory index of a cell is its *slot*; padding cells have slots without particles.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "base/pack.hpp"
#include "base/vec3.hpp"

namespace perimpact {

using fccda::Vec3d;

struct Lattice {
  std::array<int, 3> cells{};       ///< number of cells in x, y and z
  double spacing{};                 ///< [m]
  Vec3d origin{};                   ///< [m] centre of cell (0, 0, 0) of an unbounded lattice
  std::array<int, 3> first{};       ///< cell of the unbounded lattice that is cell (0, 0, 0) here; not zero after a moving window has moved
  std::optional<double> thickness;  ///< [m] of a plane body, which is one layer of cells in z; if absent, cells are cubes

  double cell_volume() const { return spacing * spacing * thickness.value_or(spacing); }  ///< [m³]

  std::size_t row_slots() const { return fccda::in_eights(static_cast<std::size_t>(cells[0])); }
  std::size_t rows() const { return static_cast<std::size_t>(cells[1]) * static_cast<std::size_t>(cells[2]); }
  std::size_t slots() const { return rows() * row_slots(); }

  std::size_t slot(int i, int j, int k) const {
    return (static_cast<std::size_t>(k) * static_cast<std::size_t>(cells[1]) + static_cast<std::size_t>(j)) * row_slots() + static_cast<std::size_t>(i);
  }
  std::array<int, 3> cell(std::size_t slot) const {
    const std::size_t row = slot / row_slots();
    const std::size_t ny = static_cast<std::size_t>(cells[1]);
    return {static_cast<int>(slot % row_slots()), static_cast<int>(row % ny), static_cast<int>(row / ny)};
  }
  /// Difference of the slots of cells that differ by (di, dj, dk).
  std::ptrdiff_t offset(int di, int dj, int dk) const {
    return (static_cast<std::ptrdiff_t>(dk) * cells[1] + dj) * static_cast<std::ptrdiff_t>(row_slots()) + di;
  }
  bool contains(int i, int j, int k) const { return i >= 0 && i < cells[0] && j >= 0 && j < cells[1] && k >= 0 && k < cells[2]; }

  /// Centre of the cell [m].
  Vec3d centre(std::size_t slot) const {
    const auto [i, j, k] = cell(slot);
    return {origin.x + (first[0] + i) * spacing, origin.y + (first[1] + j) * spacing, origin.z + (first[2] + k) * spacing};
  }
};

}  // namespace perimpact
