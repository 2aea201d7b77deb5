/// Partition of a lattice over ranks: one box of cells each. A pure function of the number of cells, so that every rank knows the boxes of all without
/// messages.
///
/// Cuts across x are at multiples of eight cells, since eight slots share the bytes of their bonds and are summed together. Two kinds of partition are
/// compared, and the one whose busiest rank has the least work is taken, where a ghost counts as a part of a cell that is computed:
///
///   regular    a grid of boxes, by every way to write the number of ranks as a product of three: at most 26 neighbours
///   bisected   recursive bisection, each time along the best axis: for numbers of ranks without suitable factors
#pragma once

#include <array>
#include <span>
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

/// The same; throws InputError where there are not as many blocks.
std::vector<CellBox> boxes_of_ranks(const PartitionRule& rule, int ranks);

/// The cells of a rank's own lattice: its box, and `reach` cells around it, in x whole eights.
CellBox with_ghosts(const CellBox& box, const PartitionRule& rule);

/// Cells that a rank sends to another and receives from it in a refresh of ghosts.
struct ExchangedCells {
  int rank;  ///< the other
  CellBox send, receive;
};

/// Those of a rank with each other that is within reach, by ascending rank. `boxes`: of all ranks.
std::vector<ExchangedCells> exchanged_cells(std::span<const CellBox> boxes, int rank, int reach);

}  // namespace perimpact
