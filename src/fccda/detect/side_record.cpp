#include "fccda/detect/side_record.hpp"

namespace fccda {

void SideRecord::begin(std::size_t point_count) {
  in_contact_before_.swap(in_contact_);
  in_contact_.clear();
  for (std::vector<std::uint64_t>* numbers : {&entered_, &in_contact_before_})  // the number of a new point must not refer to a removed one
    numbers->erase(std::lower_bound(numbers->begin(), numbers->end(), point_count), numbers->end());
  entered_at_t0_ = entered_;
  entered_count_at_t0_ = entered_count_;
  changed_.clear();
  renumbered_at_t0_ = renumbered_;
}

void SideRecord::begin_again() {
  in_contact_.clear();
  changed_.clear();
  entered_ = entered_at_t0_;
  entered_count_ = entered_count_at_t0_;
  renumbered_ = renumbered_at_t0_;
}

void SideRecord::add(std::span<const Changes* const> of_shares) {
  std::vector<std::uint64_t> entering, leaving;
  std::uint64_t entered_before = 0;
  for (const Changes* changes : of_shares) {
    entering.insert(entering.end(), changes->entering.begin(), changes->entering.end());
    leaving.insert(leaving.end(), changes->leaving.begin(), changes->leaving.end());
    in_contact_.insert(in_contact_.end(), changes->in_contact.begin(), changes->in_contact.end());
    entered_before += changes->entered_before;
  }
  std::sort(in_contact_.begin(), in_contact_.end());
  in_contact_.erase(std::unique(in_contact_.begin(), in_contact_.end()), in_contact_.end());
  if (entering.empty() && leaving.empty()) return;
  changed_.insert(changed_.end(), entering.begin(), entering.end());
  changed_.insert(changed_.end(), leaving.begin(), leaving.end());
  // One that leaves and enters again within a step is not counted again.
  entered_count_ +=
      static_cast<std::size_t>(std::count_if(entering.begin(), entering.end(), [&](std::uint64_t point) { return !has_entered(point); })) - entered_before;
  std::erase_if(entered_, [&](std::uint64_t point) { return std::binary_search(leaving.begin(), leaving.end(), point); });
  entered_.insert(entered_.end(), entering.begin(), entering.end());
  std::sort(entered_.begin(), entered_.end());
}

void SideRecord::press(std::size_t point) {
  const auto place = std::lower_bound(in_contact_.begin(), in_contact_.end(), point);
  if (place == in_contact_.end() || *place != point) in_contact_.insert(place, point);
}

void SideRecord::renumber() {
  entered_.clear();
  in_contact_.clear();
  renumbered_ = 1;
}

}  // namespace fccda
