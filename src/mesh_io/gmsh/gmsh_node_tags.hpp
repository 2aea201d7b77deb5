/// Map from the node numbers of a file, which are arbitrary, to node indices.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace fccda {

/// Node tags, sorted rather than hashed: no file can cost more than O(n log n), and ascending numbers need no sorting.
class NodeTags {
 public:
  void add(std::int64_t tag) { tags_.emplace_back(tag, static_cast<int>(tags_.size())); }  ///< tag of the next node; the number of nodes must fit an int
  std::size_t size() const { return tags_.size(); }

  /// Call after the last node and before find(). Returns a duplicate number where there is one.
  std::optional<std::int64_t> finish();

  /// The index of the node with that number, from 0; nothing where there is none.
  std::optional<int> find(std::int64_t tag) const;

 private:
  std::vector<std::pair<std::int64_t, int>> tags_;
};

}  // namespace fccda
