#include "perimpact/device/short_range_on_device.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "perimpact/device/body_passes.hpp"
#include "perimpact/device/kernels.hpp"
#include "perimpact/particles/sum_over_eights.hpp"

namespace perimpact {

namespace device {

namespace {

constexpr std::size_t blocks_of(std::size_t count) { return (count + moved_block - 1) / moved_block; }

/// The first member of each eight with members, and their number.
std::vector<std::uint32_t> first_members(std::span<const NearPairs::Member> members) {
  std::vector<std::uint32_t> first;
  for (std::size_t m = 0; m < members.size(); ++m)
    if (m == 0 || members[m].id / fccda::byte_lanes != members[m - 1].id / fccda::byte_lanes) first.push_back(static_cast<std::uint32_t>(m));
  first.push_back(static_cast<std::uint32_t>(members.size()));
  return first;
}

}  // namespace

class ShortRangePasses {
 public:
  ShortRangePasses(Device& device, std::vector<BodyPasses*> bodies) : device_(&device), bodies_(std::move(bodies)) {}

  void add_forces(ShortRange& contact, std::span<const ContactingBody> bodies, double dt);
  void to_host(ShortRange& contact);

 private:
  template <class T>
  DeviceArray<T> uploaded(const std::vector<T>& numbers) const {
    DeviceArray<T> array(*device_, numbers.size());
    device_->upload(array.data(), numbers.data(), numbers.size() * sizeof(T));
    return array;
  }
  void upload_list(ShortRange& contact, std::span<const ContactingBody> bodies);
  DisplacementExtremes moved(const NearPairs& pairs);
  void insert_broken_pairs(const NearPairs& pairs, const ShortRangeView& view);

  Device* device_;
  std::vector<BodyPasses*> bodies_;
  bool is_here_ = false;  // the state is on the device

  // since the last list
  std::optional<Mirrors> mirrors_;  // of the arrays of ShortRange
  DeviceArray<ArraysOfBody> arrays_;
  DeviceArray<SlotOfBody> particles_;
  std::array<DeviceArray<double>, 3> reference_;
  DeviceArray<DisplacementExtremes> moved_, moved_together_;
  DeviceArray<std::uint32_t> slots_, list_, first_member_;
  std::size_t eights_ = 0, times_exposed_ = 0;
  DeviceArray<PairSum> pair_sums_, sums_;
};

void ShortRangePasses::add_forces(ShortRange& contact, std::span<const ContactingBody> bodies, double dt) {
  for (BodyPasses* body : bodies_) body->motion().to_device(), body->forces().to_device();
  NearPairs& pairs = contact.near_pairs();
  contact.reserve_all_pairs();  // the kernel that inserts pairs reports nothing
  pairs.use_common_skin();      // moved() is of all particles
  if (!is_here_) pairs.forget();
  if (pairs.needs_new_list(bodies, is_here_ ? moved(pairs) : DisplacementExtremes{})) {
    to_host(contact);
    for (BodyPasses* body : bodies_) body->motion().to_host();
    contact.make_list(bodies);
    upload_list(contact, bodies);
  }
  const std::size_t members = pairs.members().size();
  if (members == 0) return contact.enter({});
  const ShortRangeView view = mirrors_->on_device(contact.view(dt));
  if (std::exchange(times_exposed_, pairs.times_exposed()) != pairs.times_exposed() && !pairs.exposed().empty()) mirrors_->upload(pairs.exposed());
  device_->launch(GatherMembersKernel{view, arrays_.data(), slots_.data()}, members);
  insert_broken_pairs(pairs, view);
  device_->launch(DensityKernel{view}, members);
  device_->launch(PairForcesKernel{view, arrays_.data(), slots_.data(), pair_sums_.data()}, members);
  for (BodyPasses* body : bodies_) body->forces().changed_on_device();
  device_->launch(SumMembersKernel{first_member_.data(), pair_sums_.data(), sums_.data()}, eights_);
  std::vector<PairSum> sums(eights_);
  device_->download(sums.data(), sums_.data(), eights_ * sizeof(PairSum));
  contact.enter(exact_sum_of_eights(pairs.ranks(), eights_, [&](std::size_t eight) { return sums[eight]; }));
}

void ShortRangePasses::to_host(ShortRange& contact) {
  if (!std::exchange(is_here_, false)) return;
  contact.visit_changed_arrays([&](const auto& array) {
    if (!array.empty()) mirrors_->download(array);
  });
}

void ShortRangePasses::upload_list(ShortRange& contact, std::span<const ContactingBody> bodies) {
  is_here_ = true;
  const NearPairs& pairs = contact.near_pairs();
  const auto members = pairs.members();
  mirrors_.emplace(*device_);
  contact.visit_arrays([&](const auto& array) { mirrors_->add(array); });
  times_exposed_ = pairs.times_exposed();

  std::vector<ArraysOfBody> arrays;
  for (std::size_t b = 0; b < bodies.size(); ++b) arrays.push_back(bodies_[b]->arrays(bodies[b].particles));
  arrays_ = uploaded(arrays);
  std::vector<SlotOfBody> particles;
  for (const NearPairs::Member& particle : pairs.particles()) particles.push_back({particle.body, particle.slot});
  particles_ = uploaded(particles);
  for (std::size_t c = 0; c < 3; ++c) {
    reference_[c] = DeviceArray<double>(*device_, particles.size());
    device_->upload(reference_[c].data(), pairs.reference_positions().component(c), particles.size() * sizeof(double));
  }
  moved_ = DeviceArray<DisplacementExtremes>(*device_, blocks_of(particles.size()));
  moved_together_ = DeviceArray<DisplacementExtremes>(*device_, blocks_of(blocks_of(particles.size())));

  std::vector<std::uint32_t> slots;
  for (const NearPairs::Member& member : members) slots.push_back(member.slot);
  slots_ = uploaded(slots);
  list_ = DeviceArray<std::uint32_t>(*device_, members.size());
  const std::vector<std::uint32_t> first = first_members(members);
  first_member_ = uploaded(first);
  eights_ = first.size() - 1;
  pair_sums_ = DeviceArray<PairSum>(*device_, members.size());
  sums_ = DeviceArray<PairSum>(*device_, eights_);
}

DisplacementExtremes ShortRangePasses::moved(const NearPairs& pairs) {
  const std::size_t particles = pairs.particles().size(), blocks = blocks_of(particles);
  device_->launch(
      MovedKernel{
          arrays_.data(), particles_.data(), particles, {reference_[0].data(), reference_[1].data(), reference_[2].data()}, pairs.drift(), moved_.data()},
      blocks);
  device_->launch(MovedTogetherKernel{moved_.data(), blocks, moved_together_.data()}, blocks_of(blocks));
  std::vector<DisplacementExtremes> of_blocks(blocks_of(blocks));
  device_->download(of_blocks.data(), moved_together_.data(), of_blocks.size() * sizeof(DisplacementExtremes));
  DisplacementExtremes all;
  for (const DisplacementExtremes& moved : of_blocks) all.include(moved);
  return all;
}

void ShortRangePasses::insert_broken_pairs(const NearPairs& pairs, const ShortRangeView& view) {
  const std::vector<std::uint32_t> list = pairs.members_with_broken_bonds();
  if (list.empty()) return;
  device_->upload(list_.data(), list.data(), list.size() * sizeof(std::uint32_t));
  device_->launch(InsertBrokenPairsKernel{view, arrays_.data(), slots_.data(), list_.data()}, list.size());
}

}  // namespace device

namespace {

std::vector<device::BodyPasses*> passes_of(std::span<BodyOnDevice* const> bodies) {
  std::vector<device::BodyPasses*> all;
  for (BodyOnDevice* body : bodies) all.push_back(&body->passes());
  return all;
}

}  // namespace

ShortRangeOnDevice::ShortRangeOnDevice(Device& device, std::vector<BodyOnDevice*> bodies)
    : passes_(std::make_unique<device::ShortRangePasses>(device, passes_of(bodies))) {}
ShortRangeOnDevice::ShortRangeOnDevice(ShortRangeOnDevice&&) noexcept = default;
ShortRangeOnDevice::~ShortRangeOnDevice() = default;

void ShortRangeOnDevice::add_forces(ShortRange& contact, std::span<const ContactingBody> bodies, double dt) { passes_->add_forces(contact, bodies, dt); }
void ShortRangeOnDevice::to_host(ShortRange& contact) { passes_->to_host(contact); }

DeviceTraffic ShortRangeOnDevice::traffic_of_step(const ShortRange& contact) {
  const NearPairs& pairs = contact.near_pairs();
  const std::size_t eights = device::first_members(pairs.members()).size() - 1;
  const std::size_t blocks = device::blocks_of(device::blocks_of(pairs.particles().size()));
  return {.uploaded = 0, .downloaded = eights * sizeof(PairSum) + blocks * sizeof(DisplacementExtremes)};
}

}  // namespace perimpact
