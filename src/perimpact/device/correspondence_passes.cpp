// The passes of a correspondence material: those of CorrespondenceForce, on a device.
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "perimpact/device/body_passes.hpp"

namespace perimpact::device {

using fccda::byte_lanes;

/// No bonds are known at first, so that the first pass computes K⁻¹.
BodyPasses::KnownShapes::KnownShapes(Device& device, std::size_t slots, std::size_t word_count)
    : words(device, word_count), nearness(device, slots / byte_lanes), raised(device, slots / byte_lanes), energy_before(device, slots) {
  const std::vector<std::uint32_t> none(word_count, 0);
  device.upload(words.data(), none.data(), none.size() * sizeof(std::uint32_t));
  const std::vector<std::uint8_t> far_off(slots / byte_lanes, correspondence::far_off);
  device.upload(nearness.data(), far_off.data(), far_off.size());
}

template <std::size_t D>
void BodyPasses::pass(CorrespondenceForce<D>& force, Body& body, double dt, bool with_energy, SumsOfEights& sums) {
  forget_broken();
  const Findings findings = this->findings();
  const BondsOfSlots now = bonds(body.family);
  CorrespondenceView<D> view = mirrors_.on_device(force.view_of_lattice(body.particles, now, now.with(known_.words.data()), dt));
  view.broken = known_.nearness.data();
  const bool is_bond_level = force.law().is_bond_level();
  for_each_visit(force.breaking(), body, [&]<class Breaker>(const Breaker& breaker) {
    if (is_bond_level)
      device_->launch(GradientKernel<D, Breaker>{view, breaker, findings}, slots_);
    else
      device_->launch(ResponseKernel<D, Breaker>{view, breaker, findings, with_energy}, slots_);
  });
  const bool broke = enter_broken(body.family, sums);
  if (is_bond_level) {
    if (broke) account_for_broken(view, sums);
    device_->launch(BondLevelStressKernel<D>{view}, slots_);
    if (with_energy) device_->launch(BondLevelEnergyKernel<D, false>{view, findings.energy}, slots_);
    device_->launch(BondLevelReturnKernel<D>{view}, slots_);
  }
  device_->launch(CorrespondenceForceKernel<D>{view}, slots_);
  forces_.changed_on_device();
  const std::optional<BreakingRule>& rule = force.breaking().rule();
  if (with_energy) enter_energy(sums, rule && rule->hardening > 0 && !is_bond_level);
}

/// As CorrespondenceForce::account_for_broken(). Of slots near broken bonds two energies travel.
template <std::size_t D>
void BodyPasses::account_for_broken(const CorrespondenceView<D>& view, SumsOfEights& sums) {
  const std::size_t eights = slots_ / byte_lanes;
  device_->launch(NearnessKernel{view.known, correspondence::broke_here, view.broken, known_.raised.data()}, eights);
  device_->launch(NearnessKernel{view.known, correspondence::changed, known_.raised.data(), view.broken}, eights);
  std::vector<std::uint8_t> nearness(eights);
  device_->download(nearness.data(), known_.nearness.data(), eights);
  std::vector<std::uint32_t> slots;
  for (std::uint32_t slot = 0; slot < slots_; ++slot)
    if (nearness[slot / byte_lanes] >= correspondence::changed) slots.push_back(slot);

  device_->launch(RenewGradientKernel<D>{view}, slots_);
  device_->launch(RenewRateKernel<D>{view}, slots_);
  device_->launch(BondLevelEnergyKernel<D, true>{view.before(), known_.energy_before.data()}, slots_);
  device_->launch(FollowBrokenKernel<D>{view}, slots_);
  device_->launch(BondLevelEnergyKernel<D, true>{view, energy_.data()}, slots_);

  const DeviceArray<std::uint32_t> list(*device_, slots.size());
  const DeviceArray<double> gathered(*device_, 2 * slots.size());
  device_->upload(list.data(), slots.data(), slots.size() * sizeof(std::uint32_t));
  device_->launch(GatherKernel<SlotList, 2>{{list.data(), slots.size()}, {known_.energy_before.data(), energy_.data()}, gathered.data()}, slots.size());
  std::vector<double> energies(2 * slots.size());
  device_->download(energies.data(), gathered.data(), energies.size() * sizeof(double));
  for (std::size_t k = 0; k < slots.size(); ++k) sums.fracture_energy[slots[k] / byte_lanes] += energies[k];
  for (std::size_t k = 0; k < slots.size(); ++k) sums.fracture_energy[slots[k] / byte_lanes] -= energies[slots.size() + k];

  nearness.assign(eights, correspondence::far_off);
  device_->upload(known_.nearness.data(), nearness.data(), eights);
}

template void BodyPasses::pass(CorrespondenceForce<2>&, Body&, double, bool, SumsOfEights&);
template void BodyPasses::pass(CorrespondenceForce<3>&, Body&, double, bool, SumsOfEights&);

}  // namespace perimpact::device
