/// Part of a point cloud that a rank owns, and the ghosts around it. The points follow a space-filling curve, and each part is a range of their eights: so it
/// is compact, and no eight is divided.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "perimpact/particles/measured_load.hpp"

namespace perimpact {

/// How the eights of a cloud are divided among ranks: a pure function of three numbers, and of what they cost in an earlier run if that was measured.
class CloudPartition {
 public:
  /// A small cloud is divided among fewer ranks than there are, from `first_rank` on, which is one of them.
  CloudPartition(std::size_t eights, int ranks, int first_rank = 0, std::span<const MeasuredPart> load = {});

  int parts() const { return static_cast<int>(cuts_.size()) - 1; }
  std::size_t eights() const { return cuts_.back(); }
  int rank_of(int part) const { return (part + first_rank_) % ranks_; }
  /// Part of a rank; parts() if it has none, whose range is empty.
  int part_of(int rank) const { return std::min((rank - first_rank_ + ranks_) % ranks_, parts()); }
  /// First eight of a part, and one past its last.
  std::size_t begin(int part) const { return cuts_[static_cast<std::size_t>(part)]; }
  std::size_t end(int part) const { return part == parts() ? eights() : cuts_[static_cast<std::size_t>(part) + 1]; }
  int owner_of(std::size_t eight) const { return rank_of(static_cast<int>(std::ranges::upper_bound(cuts_, eight) - cuts_.begin()) - 1); }

 private:
  int ranks_, first_rank_;
  std::vector<std::size_t> cuts_;  // first eight of each part, and the number of all
};

struct CloudPart {
  CloudPartition partition;
  std::vector<std::uint32_t> eights;       ///< of the whole cloud, owned and ghosts, ascending: those of the arrays of this rank
  std::vector<std::uint8_t> reads_ghosts;  ///< 1 for each of `eights` that is owned and within reach of a ghost
  /// Places in `eights` that this rank sends to another and receives from it in a refresh of ghosts, ascending.
  struct Exchanged {
    int rank;  ///< the other
    std::vector<std::uint32_t> send, receive;
  };
  std::vector<Exchanged> exchanged;  ///< with each rank within reach, ascending
};

}  // namespace perimpact
