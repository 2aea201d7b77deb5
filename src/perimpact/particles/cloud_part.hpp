/// Part of a point cloud that a rank owns, and the ghosts around it. The points follow a space-filling curve, and each part is a range of their eights: so it
/// is compact, and no eight is divided.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace perimpact {

/// How the eights of a cloud are divided among ranks: a pure function of three numbers.
class CloudPartition {
 public:
  /// A small cloud is divided among fewer ranks than there are, from `first_rank` on, which is one of them.
  CloudPartition(std::size_t eights, int ranks, int first_rank = 0)
      : eights_(eights), ranks_(ranks), first_rank_(first_rank), parts_(static_cast<int>(std::min(eights, static_cast<std::size_t>(ranks)))) {}

  int parts() const { return parts_; }
  std::size_t eights() const { return eights_; }
  int rank_of(int part) const { return (part + first_rank_) % ranks_; }
  /// Part of a rank; parts() if it has none, whose range is empty.
  int part_of(int rank) const { return std::min((rank - first_rank_ + ranks_) % ranks_, parts_); }
  /// First eight of a part, and one past the last of that before it.
  std::size_t begin(int part) const { return eights_ * static_cast<std::size_t>(part) / static_cast<std::size_t>(parts_); }
  std::size_t end(int part) const { return part == parts_ ? eights_ : begin(part + 1); }
  int owner_of(std::size_t eight) const {
    int part = static_cast<int>(eight * static_cast<std::size_t>(parts_) / eights_);
    while (eight >= end(part)) ++part;  // rounding down
    return rank_of(part);
  }

 private:
  std::size_t eights_;
  int ranks_, first_rank_, parts_;
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
