/// Cost of the parts of a body in an earlier run of several ranks, by which ranks divide it again.
#pragma once

#include <span>
#include <vector>

#include "perimpact/particles/cell_box.hpp"

namespace perimpact {

/// A part that one rank owned.
struct MeasuredPart {
  CellBox cells;  ///< of the lattice of the whole body; of a point cloud, its eights along x, with one row of one layer
  double cost;    ///< [s] of each cell, on any scale
};

/// The parts of a body, which tile it; empty if nothing was measured.
using MeasuredLoad = std::vector<MeasuredPart>;

/// That of a body, in loads of all or none.
inline MeasuredLoad load_of_body(std::span<const MeasuredLoad> loads, std::size_t body) { return body < loads.size() ? loads[body] : MeasuredLoad{}; }

/// [s] of a box of cells.
inline double cost_of(std::span<const MeasuredPart> load, const CellBox& box) {
  double cost = 0;
  for (const MeasuredPart& part : load) cost += part.cost * static_cast<double>(intersection(part.cells, box).cells());
  return cost;
}

/// Seven numbers of each part, for a file: cells low <= cell < high along each axis, and the cost.
std::vector<double> numbers_of(const MeasuredLoad& load);
MeasuredLoad load_of(std::span<const double> numbers);

/// [s] of each layer of a box of cells across an axis.
std::vector<double> costs_of_layers(std::span<const MeasuredPart> load, const CellBox& box, std::size_t axis);

}  // namespace perimpact
