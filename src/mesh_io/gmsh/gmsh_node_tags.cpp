#include "mesh_io/gmsh/gmsh_node_tags.hpp"

#include <algorithm>

namespace fccda {

std::optional<std::int64_t> NodeTags::finish() {
  if (!std::is_sorted(tags_.begin(), tags_.end())) std::sort(tags_.begin(), tags_.end());
  const auto twice = std::adjacent_find(tags_.begin(), tags_.end(), [](const auto& a, const auto& b) { return a.first == b.first; });
  if (twice == tags_.end()) return {};
  return twice->first;
}

std::optional<int> NodeTags::find(std::int64_t tag) const {
  if (tags_.empty() || tag < tags_.front().first || tag > tags_.back().first) return {};
  // without gaps the index follows directly; the unsigned difference is exact where it is less than the count, and wraps otherwise
  const auto from_first = static_cast<std::uint64_t>(tag) - static_cast<std::uint64_t>(tags_.front().first);
  if (from_first < tags_.size() && tags_[from_first].first == tag) return tags_[from_first].second;
  const auto found = std::lower_bound(tags_.begin(), tags_.end(), tag, [](const auto& entry, std::int64_t wanted) { return entry.first < wanted; });
  if (found == tags_.end() || found->first != tag) return {};
  return found->second;
}

}  // namespace fccda
