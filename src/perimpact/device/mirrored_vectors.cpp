#include "perimpact/device/mirrored_vectors.hpp"

#include <algorithm>
#include <utility>

#include "base/contract.hpp"

namespace perimpact::device {

MirroredVectors::MirroredVectors(Device& device, const Mirrors& mirrors, std::vector<VectorArray*> arrays)
    : device_(&device), mirrors_(&mirrors), arrays_(std::move(arrays)), slots_(arrays_.front()->slots()), is_here_(slots_, 0) {}

void MirroredVectors::to_host() {
  if (is_on_host_) return;
  to_device();  // or the changes of the host would be overwritten
  for (VectorArray* array : arrays_)
    for (double* component : array->writable_pointers()) mirrors_->download(std::span(component, slots_));
  is_on_host_ = true;
}

void MirroredVectors::to_host(std::span<const std::uint32_t> slots) {
  if (is_on_host_) return;
  std::vector<std::uint32_t> missing;
  for (const std::uint32_t slot : slots)
    if (is_here_[slot] == 0) missing.push_back(slot), is_here_[slot] = 1;
  here_.insert(here_.end(), missing.begin(), missing.end());
  if (is_most(missing.size(), slots_)) return to_host();
  if (!missing.empty()) gather(missing);
}

void MirroredVectors::to_device() {
  if (is_on_device_ && pending_.empty()) return;
  std::sort(pending_.begin(), pending_.end());
  pending_.erase(std::unique(pending_.begin(), pending_.end()), pending_.end());
  if (!is_on_device_ || (is_on_host_ && is_most(pending_.size(), slots_))) {
    for (const VectorArray* array : arrays_)
      for (const double* component : array->pointers()) mirrors_->upload(std::span(component, slots_));
  } else {
    scatter(pending_);
  }
  is_on_device_ = true;
  pending_.clear();
}

void MirroredVectors::changed_on_host() {
  EXPECTS(is_on_host_);
  is_on_device_ = false;
}

void MirroredVectors::changed_on_host(std::span<const std::uint32_t> slots) {
  EXPECTS(is_on_host_ || std::all_of(slots.begin(), slots.end(), [&](std::uint32_t slot) { return is_here_[slot] != 0; }));
  if (is_on_device_) pending_.insert(pending_.end(), slots.begin(), slots.end());
}

void MirroredVectors::changed_on_device() {
  for (const std::uint32_t slot : here_) is_here_[slot] = 0;
  here_.clear();
  pending_.clear();
  is_on_host_ = false;
  is_on_device_ = true;
  for (VectorArray* array : arrays_)
    for (double* component : array->writable_pointers()) device_->outdate(std::span(component, slots_));
}

SlotList MirroredVectors::upload_list(std::span<const std::uint32_t> slots) {
  if (slots.size() > capacity_) {
    capacity_ = std::max(slots.size(), std::min(2 * capacity_, slots_));
    list_ = DeviceArray<std::uint32_t>(*device_, capacity_);
    numbers_ = DeviceArray<double>(*device_, 3 * arrays_.size() * capacity_);
  }
  device_->upload(list_.data(), slots.data(), slots.size_bytes());
  on_the_way_.resize(3 * arrays_.size() * slots.size());
  return {list_.data(), slots.size()};
}

void MirroredVectors::gather(std::span<const std::uint32_t> slots) {
  const SlotList list = upload_list(slots);
  for (std::size_t a = 0; a < arrays_.size(); ++a)
    device_->launch(GatherKernel<SlotList, 3>{list, mirrors_->at(std::as_const(*arrays_[a]).pointers()), numbers_.data() + a * 3 * slots.size()}, slots.size());
  device_->download(on_the_way_.data(), numbers_.data(), on_the_way_.size() * sizeof(double));
  const double* from = on_the_way_.data();
  for (VectorArray* array : arrays_)
    for (double* component : array->writable_pointers())
      for (const std::uint32_t slot : slots) component[slot] = *from++;
}

void MirroredVectors::scatter(std::span<const std::uint32_t> slots) {
  const SlotList list = upload_list(slots);
  double* to = on_the_way_.data();
  for (const VectorArray* array : arrays_)
    for (const double* component : array->pointers())
      for (const std::uint32_t slot : slots) *to++ = component[slot];
  device_->upload(numbers_.data(), on_the_way_.data(), on_the_way_.size() * sizeof(double));
  for (std::size_t a = 0; a < arrays_.size(); ++a)
    device_->launch(ScatterKernel<SlotList, 3>{list, numbers_.data() + a * 3 * slots.size(), mirrors_->at(arrays_[a]->writable_pointers())}, slots.size());
}

}  // namespace perimpact::device
