/// Partition of a lattice over ranks: one box of cells each, by recursive bisection. A pure function of the number of cells, so that every rank knows the
/// boxes of all without messages.
///
/// Cuts across x are at multiples of eight cells, since eight slots share the bytes of their bonds and are summed together. Each bisection divides the
/// ranks in half, and takes the axis with the least of imbalance and communication: what the busier half has too much, and the cells within the reach of
/// the cut.
#pragma once

#include <array>
#include <vector>

#include "perimpact/particles/cell_box.hpp"

namespace perimpact {

struct PartitionRule {
  std::array<int, 3> cells{};  ///< of the whole lattice
  int reach = 1;               ///< of the stencil, in cells
  bool keeps_columns = false;  ///< no cut across z
};

/// The box of each rank, at most `ranks`; fewer where there are not as many blocks of cells to divide.
std::vector<CellBox> partition(const PartitionRule& rule, int ranks);

}  // namespace perimpact
