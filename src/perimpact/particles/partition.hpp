/// Partition of a lattice over ranks: one box of cells each. A pure function of the number of cells, and of what they cost in an earlier run if that was
/// measured, so that every rank knows the boxes of all without messages.
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
#include "perimpact/particles/measured_load.hpp"

namespace perimpact {

struct PartitionRule {
  std::array<int, 3> cells{};  ///< of the whole lattice
  int reach = 1;               ///< of the stencil, in cells
  bool keeps_columns = false;  ///< no cut across z
  MeasuredLoad load = {};      ///< empty: all cells cost the same
};

/// The box of each rank, at most `ranks`; fewer where there are not as many blocks of cells to divide.
std::vector<CellBox> partition(const PartitionRule& rule, int ranks);

/// The boxes of all ranks, from `first_rank` on; empty for ranks beyond the number of blocks of cells.
std::vector<CellBox> boxes_of_ranks(const PartitionRule& rule, int ranks, int first_rank = 0);
int count_parts(std::span<const CellBox> boxes);  ///< number that are not empty

/// Order of the ranks in several bodies: a body of a part for each rank begins with rank 0, and smaller ones with the rank after the last of the small body
/// before, so that many small bodies are divided evenly.
class RanksInTurn {
 public:
  explicit RanksInTurn(int ranks) : ranks_(ranks) {}
  int first_rank() const { return parts_ % ranks_; }  ///< of the next body
  void add(int parts);                                ///< of the next body
  bool all_have_parts() const { return is_divided_among_all_ || parts_ >= ranks_; }
  int ranks() const { return ranks_; }
  int parts() const { return parts_; }  ///< of small bodies

 private:
  int ranks_, parts_ = 0;  // of small bodies
  bool is_divided_among_all_ = false;
};

/// The cells of a rank's own lattice: its box, and `reach` cells around it, in x whole eights; one cell of a rank without a part, since no array is empty.
CellBox with_ghosts(const CellBox& box, const PartitionRule& rule);

/// The cells of a rank's box that no ghost is within `reach` of, in x whole eights. `own`: in a lattice of so many cells, which is with_ghosts() of it.
CellBox without_rim(const CellBox& own, const std::array<int, 3>& cells, const PartitionRule& rule);

/// Cells that a rank sends to another and receives from it in a refresh of ghosts.
struct ExchangedCells {
  int rank;  ///< the other
  CellBox send, receive;
};

/// Those of a rank with each other that is within reach, by ascending rank. `boxes`: of all ranks.
std::vector<ExchangedCells> exchanged_cells(std::span<const CellBox> boxes, int rank, int reach);

}  // namespace perimpact
