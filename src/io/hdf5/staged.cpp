#include "io/hdf5/staged.hpp"

#include <algorithm>

namespace perimpact::hdf5 {

void StagedStorage::write_at(std::uint64_t offset, std::span<const std::byte> bytes) {
  const std::uint64_t before = offset < committed_ ? std::min<std::uint64_t>(bytes.size(), committed_ - offset) : 0;
  if (before > 0) keep(offset, bytes.first(before));
  if (before < bytes.size()) below_.write_at(offset + before, bytes.subspan(before));
  size_ = std::max(size_, offset + bytes.size());
}

void StagedStorage::keep(std::uint64_t offset, std::span<const std::byte> bytes) {
  const std::uint64_t end = offset + bytes.size();
  auto it = changes_.upper_bound(offset);
  if (it != changes_.begin()) --it;
  while (it != changes_.end() && it->first < end) {
    const std::uint64_t first = it->first, last = first + it->second.size();
    if (last <= offset) {
      ++it;
      continue;
    }
    std::vector<std::byte> old = std::move(it->second);
    it = changes_.erase(it);
    if (first < offset) changes_.emplace(first, std::vector<std::byte>(old.begin(), old.begin() + static_cast<std::ptrdiff_t>(offset - first)));
    if (last > end) changes_.emplace(end, std::vector<std::byte>(old.end() - static_cast<std::ptrdiff_t>(last - end), old.end()));
  }
  changes_[offset].assign(bytes.begin(), bytes.end());
}

void StagedStorage::read_at(std::uint64_t offset, std::span<std::byte> bytes) const {
  const std::uint64_t end = offset + bytes.size(), there = below_.size();
  std::ranges::fill(bytes, std::byte{});
  if (offset < there) below_.read_at(offset, bytes.first(std::min<std::uint64_t>(bytes.size(), there - offset)));
  for (const auto& [first, changed] : changes_) {
    const std::uint64_t from = std::max(first, offset), to = std::min(first + changed.size(), end);
    if (from < to)
      std::copy_n(changed.begin() + static_cast<std::ptrdiff_t>(from - first), to - from, bytes.begin() + static_cast<std::ptrdiff_t>(from - offset));
  }
}

void StagedStorage::resize(std::uint64_t size) {
  if (size > below_.size()) below_.resize(size);
  size_ = size;
}

void StagedStorage::commit() {
  below_.sync();
  const auto superblock = changes_.find(0);
  if (superblock != changes_.end()) below_.write_at(0, superblock->second);
  std::uint64_t first = page, last = 0;  // of the changes in the first page
  for (const auto& [offset, bytes] : changes_) {
    const std::uint64_t inside = offset < page ? std::min<std::uint64_t>(bytes.size(), page - offset) : 0;
    if (inside > 0) first = std::min(first, offset), last = std::max(last, offset + inside);
    if (inside < bytes.size()) below_.write_at(offset + inside, std::span(bytes).subspan(inside));
  }
  below_.sync();
  if (first < last) {
    std::vector<std::byte> bytes(last - first);
    read_at(first, bytes);
    below_.write_at(first, bytes);
  }
  if (size_ < below_.size()) below_.resize(size_);
  changes_.clear();
  committed_ = size_;
}

void StagedStorage::discard() {
  changes_.clear();
  size_ = committed_;
  if (below_.size() > committed_) below_.resize(committed_);
}

}  // namespace perimpact::hdf5
