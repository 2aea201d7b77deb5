/// Nodes by the numbers that a file gives them, which may be any and in any order.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace fccda {

/// Sorted, not hashed: no file can make it slower than n log n, and numbers in ascending order cost nothing.
class NodeTags {
 public:
  void add(std::int64_t tag) { tags_.emplace_back(tag, static_cast<int>(tags_.size())); }  ///< of the next node; at most as many as an int counts
  std::size_t size() const { return tags_.size(); }

  /// Call after the last node and before find(). A number that two nodes have, where there is one.
  std::optional<std::int64_t> finish();

  /// Which node has the number, counted from 0; nothing where none has.
  std::optional<int> find(std::int64_t tag) const;

 private:
  std::vector<std::pair<std::int64_t, int>> tags_;
};

}  // namespace fccda
