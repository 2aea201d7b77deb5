#include "perimpact/device/body_passes.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include "perimpact/particles/advance.hpp"
#include "perimpact/particles/sum_over_eights.hpp"

namespace perimpact::device {

using fccda::byte_lanes;

namespace {

/// Numbers of the eights whose mark is not 0.
std::vector<std::uint32_t> marked(std::span<const std::uint8_t> marks) {
  std::vector<std::uint32_t> eights;
  for (std::size_t eight = 0; eight < marks.size(); ++eight)
    if (marks[eight] != 0) eights.push_back(static_cast<std::uint32_t>(eight));
  return eights;
}

}  // namespace

BodyPasses::BodyPasses(Device& device, Body& body)
    : device_(&device),
      slots_(body.particles.slots()),
      rows_(body.family.offsets().size()),
      tiles_(*body.particles.lattice()),
      mirrors_(device),
      motion_(device, mirrors_, {&body.particles.position, &body.particles.velocity}),
      forces_(device, mirrors_, {&body.particles.force_density}),
      eights_(device, mirrors_, slots_),
      words_(device, words_of(slots_, rows_)),
      travel_(device, travel_blocks(body.particles)),
      energy_(device, slots_),
      energy_of_eights_(device, slots_ / byte_lanes),
      fracture_(device, slots_),
      motion_sums_(device, slots_ / byte_lanes),
      found_(device, slots_),
      is_hot_(device, slots_),
      hot_bits_(device, slots_ / byte_lanes),
      broken_count_(device, 1),
      broken_(device, slots_) {
  const auto add = [&](const auto& array) { mirrors_.add(array); };
  body.particles.visit_arrays(add);
  add(body.family.offsets());
  body.internal.with_kernel([&](const auto& force) { force.visit_arrays(add); });
  upload_bonds(body.family);
  if (body.internal.correspondence()) known_ = KnownShapes(device, slots_, words_of(slots_, rows_));
}

void BodyPasses::renew() {
  motion_.changed_on_host();
  forces_.changed_on_host();
  is_renewed_ = true;
}

void BodyPasses::advance(Particles& particles, double dt, std::span<double> travel) {
  forces_.to_device();
  motion_.to_device();
  const Motion motion = mirrors_.on_device(motion_of(particles, dt));
  device_->launch(AdvanceKernel{motion}, slots_);
  device_->launch(TravelKernel{motion, slots_, travel_.data()}, travel.size());
  motion_.changed_on_device();
  device_->download(travel.data(), travel_.data(), travel.size_bytes());
}

MotionSums BodyPasses::motion_sums(const Particles& particles, double dt) {
  motion_.to_device();
  forces_.to_device();
  const std::size_t eights = slots_ / byte_lanes;
  device_->launch(MotionSumsKernel{mirrors_.on_device(particles.view()), mirrors_.at(particles.force_density.pointers()), particles.density(),
                                   dt / particles.density(), motion_sums_.data()},
                  eights);
  std::vector<MotionSums> sums(eights);
  device_->download(sums.data(), motion_sums_.data(), eights * sizeof(MotionSums));
  return exact_sum_of_eights(particles.share().ranks(), eights, [&](std::size_t eight) { return sums[eight]; });
}

void BodyPasses::evaluate(Body& body, double dt, bool with_energy) {
  if (std::exchange(is_renewed_, false)) {
    upload_bonds(body.family);
    if (const PlasticForce* plastic = body.internal.plastic()) mirrors_.upload(plastic->pressures());
    is_flow_outdated_ = true;
  }
  motion_.to_device();
  body.internal.with_kernel_and_sums([&](auto& force, SumsOfEights& sums) { pass(force, body, dt, with_energy, sums); });
}

void BodyPasses::pass(OrdinaryStateForce& force, Body& body, double dt, bool with_energy, SumsOfEights& sums) {
  forget_broken();
  const Findings findings = this->findings();
  const bool has_dilatation = force.law().needs_dilatation();
  force.with_view_of_lattice(body.particles, bonds(body.family), rows_, dt, [&](const auto& view_of_host, const auto& corrections_of_host) {
    const auto view = mirrors_.on_device(view_of_host);
    const auto corrections = mirrors_.on_device(corrections_of_host);
    using Corrections = std::decay_t<decltype(corrections)>;
    const auto launch = [&](const auto& kernel) { launch_tiled(kernel); };
    if (has_dilatation) {
      for_each_visit(force.breaking(), body, [&](const auto& breaker) {
        launch(DilatationKernel<std::decay_t<decltype(breaker)>, Corrections>{view, breaker, corrections, findings});
      });
      with_constant(with_energy, [&](auto energy) {
        launch(ForceKernel<Unbreakable, Corrections, true, energy.value>{view, {}, corrections, findings, with_energy});
      });
      return;
    }
    for_each_visit(force.breaking(), body, [&](const auto& breaker) {
      using Breaker = std::decay_t<decltype(breaker)>;
      if constexpr (Breaker::is_armed && !is_noting<Breaker>)
        launch(ForceKernel<Breaker, Corrections, false, true>{view, breaker, corrections, findings, with_energy});
      else
        with_constant(with_energy, [&](auto energy) {
          launch(ForceKernel<Breaker, Corrections, false, energy.value>{view, breaker, corrections, findings, with_energy});
        });
    });
  });
  forces_.changed_on_device();
  enter_broken(body.family, sums);
  const std::optional<BreakingRule>& rule = force.breaking().rule();
  if (with_energy) enter_energy(sums, rule && rule->hardening > 0 && !has_dilatation);
}

void BodyPasses::pass(PlasticForce& force, Body& body, double dt, bool with_energy, SumsOfEights& sums) {
  force.pass_with(body.particles, body.family, {.with_energy = with_energy, .dt = dt}, [&](PlasticForce::Packs which) {
    const bool again = which == PlasticForce::Packs::affected;
    const PlasticForce::Evaluation evaluation = force.evaluation();
    upload_flow(evaluation);
    forget_broken();
    if (again) mirrors_.upload(evaluation.affected);
    const bool all = !again || with_energy;
    const PlasticSlots slots = plastic_slots(evaluation, body.particles, all);
    if (again) begin_return(evaluation, slots);
    launch(force, slots, body, {.may_break = !again && force.breaking().is_armed(), .dt = dt});
    forces_.changed_on_device();
    enter_stress(evaluation, all);
    if (again) enter_return(evaluation, body.particles, dt);
    pressures_there_ = std::span(evaluation.pressure, slots_);
    enter_broken(body.family, sums);
    if (with_energy) enter_density(body.particles, sums);
  });
  device_->outdate(pressures_there_);
}

/// Brings the pressures of the last pass to the host.
void BodyPasses::pressures_to_host() {
  if (!pressures_there_.empty()) mirrors_.download(std::exchange(pressures_there_, {}));
}

/// What the last flow has changed.
void BodyPasses::upload_flow(const PlasticForce::Evaluation& evaluation) {
  if (std::exchange(is_flow_outdated_, false)) {
    for (const std::span<const double> array : evaluation.with_slack) mirrors_.upload(array);
    return mirrors_.upload(evaluation.is_plastic);
  }
  const std::vector<std::uint32_t> changed = marked(evaluation.flows);
  if (changed.empty()) return;
  eights_.to_device(changed, evaluation.of_flow);
  mirrors_.upload(evaluation.is_plastic);
}

PlasticSlots BodyPasses::plastic_slots(const PlasticForce::Evaluation& evaluation, Particles& particles, bool all) const {
  PlasticSlots slots{mirrors_.at(evaluation.is_plastic.data()),
                     all ? nullptr : mirrors_.at(evaluation.affected.data()),
                     {},
                     {},
                     mirrors_.at(evaluation.pressure),
                     energy_.data(),
                     is_hot_.data()};
  slots.force = mirrors_.at(particles.force_density.writable_pointers());
  slots.stress = mirrors_.at(evaluation.stress);
  return slots;
}

/// The kernels of PlasticForce::evaluate().
void BodyPasses::launch(PlasticForce& force, const PlasticSlots& slots, const Body& body, const PassOptions& options) {
  const Findings findings = this->findings();
  const double elastic_limit = force.evaluation().elastic_limit;
  force.with_view_of_lattice(body.particles, bonds(body.family), rows_, options.dt, [&](const auto& view_of_host, const auto& corrections_of_host) {
    const auto view = mirrors_.on_device(view_of_host);
    const auto corrections = mirrors_.on_device(corrections_of_host);
    using Corrections = std::decay_t<decltype(corrections)>;
    const auto dilatations = [&]<Visit visit>() {
      launch_tiled(PlasticDilatationKernel<false, visit, Corrections>{view, corrections, findings, slots});
      launch_tiled(PlasticDilatationKernel<true, visit, Corrections>{view, corrections, findings, slots});
    };
    const auto forces = [&]<bool with_theta, Visit visit>() {
      launch_tiled(PlasticForceKernel<false, with_theta, visit, Corrections>{view, corrections, findings, slots});
      launch_tiled(PlasticForceKernel<true, with_theta, visit, Corrections>{view, corrections, findings, slots});
    };
    if (force.law().needs_dilatation()) {
      if (options.may_break) {
        dilatations.template operator()<Visit::first>();
        dilatations.template operator()<Visit::second>();
      } else {
        dilatations.template operator()<Visit::only>();
      }
      forces.template operator()<true, Visit::only>();
      return;
    }
    if (options.may_break) {
      forces.template operator()<false, Visit::first>();
      forces.template operator()<false, Visit::second>();
    } else {
      forces.template operator()<false, Visit::only>();
    }
    launch_tiled(HotStressKernel<Corrections>{view, corrections, slots, elastic_limit});
  });
}

/// Which stresses are known, and those of the eights that were evaluated.
void BodyPasses::enter_stress(const PlasticForce::Evaluation& evaluation, bool all) {
  device_->launch(HotBitsKernel{is_hot_.data(), hot_bits_.data()}, evaluation.is_hot.size());
  device_->download(evaluation.is_hot.data(), hot_bits_.data(), evaluation.is_hot.size());
  std::vector<std::uint32_t> hot = marked(evaluation.is_hot);
  if (!all) std::erase_if(hot, [&](std::uint32_t eight) { return evaluation.affected[eight] == 0; });
  eights_.to_host(hot, evaluation.stress);
}

/// The forces of affected eights before they are evaluated again.
void BodyPasses::begin_return(const PlasticForce::Evaluation& evaluation, const PlasticSlots& slots) {
  returning_ = marked(evaluation.affected);
  if (returning_.size() > most_returning_) {
    most_returning_ = std::min(std::max(returning_.size(), 2 * most_returning_), slots_ / byte_lanes);
    list_of_returning_ = DeviceArray<std::uint32_t>(*device_, most_returning_);
    forces_before_ = DeviceArray<double>(*device_, 3 * most_returning_ * byte_lanes);
    lost_work_ = DeviceArray<double>(*device_, most_returning_ * byte_lanes);
  }
  device_->upload(list_of_returning_.data(), returning_.data(), returning_.size() * sizeof(std::uint32_t));
  const EightList list{list_of_returning_.data(), returning_.size()};
  device_->launch(GatherKernel<EightList, 3>{list, {slots.force[0], slots.force[1], slots.force[2]}, forces_before_.data()}, list.places());
}

/// The work that the forces do less after a flow. That of eights which are not affected does not change.
void BodyPasses::enter_return(const PlasticForce::Evaluation& evaluation, const Particles& particles, double dt) {
  const EightList list{list_of_returning_.data(), returning_.size()};
  device_->launch(
      LostWorkKernel{list, mirrors_.on_device(particles.view()), forces_before_.data(), mirrors_.at(particles.force_density.pointers()), dt, lost_work_.data()},
      list.places());
  std::vector<double> lost(list.places());
  device_->download(lost.data(), lost_work_.data(), lost.size() * sizeof(double));
  const double* next = lost.data();
  for (const std::uint32_t eight : returning_)
    for (std::size_t lane = 0; lane < byte_lanes; ++lane) evaluation.dissipation[eight] += *next++;
}

/// The energy of each eight, from densities.
void BodyPasses::enter_density(const Particles& particles, SumsOfEights& sums) {
  std::vector<double> density(slots_);
  device_->download(density.data(), energy_.data(), density.size() * sizeof(double));
  std::fill(sums.energy.begin(), sums.energy.end(), 0.0);
  for (std::size_t slot = 0; slot < slots_; ++slot) sums.energy[slot / byte_lanes] += energy_of_pack(density[slot], particles, slot);
}

ArraysOfBody BodyPasses::arrays(Particles& particles) const {
  const ParticlesView view = mirrors_.on_device(particles.view());
  return {view.position, view.velocity, mirrors_.at(particles.force_density.writable_pointers()), words_.data(), words_of_slot(rows_)};
}

BondsOfSlots BodyPasses::bonds(const Family& family) const { return {words_.data(), mirrors_.at(family.offsets().data()), rows_}; }

Findings BodyPasses::findings() const { return {found_.data(), energy_.data(), fracture_.data(), {broken_count_.data(), broken_.data()}}; }

void BodyPasses::forget_broken() {
  constexpr std::uint32_t none = 0;
  device_->upload(broken_count_.data(), &none, sizeof none);
}

void BodyPasses::upload_bonds(const Family& family) {
  const std::size_t words = words_of_slot(rows_);
  std::vector<std::uint32_t> of_slots(words_of(slots_, rows_), 0);
  for (std::size_t eight = 0; eight < slots_ / byte_lanes; ++eight) {
    const std::uint8_t* const bytes = family.bytes(eight);
    for (std::size_t row = 0; row < rows_; ++row)
      fccda::for_each_bit(bytes[row], [&](std::size_t lane) {
        of_slots[first_word(eight * byte_lanes + lane, words) + row / bonds_of_word * slots_of_group] |= 1u << (row % bonds_of_word);
      });
  }
  device_->upload(words_.data(), of_slots.data(), of_slots.size() * sizeof(std::uint32_t));
}

/// The bonds that broke, in the family and the sums; whether any did. Only those of slots where some did travel.
bool BodyPasses::enter_broken(Family& family, SumsOfEights& sums) {
  std::uint32_t count = 0;
  device_->download(&count, broken_count_.data(), sizeof count);
  if (count == 0) return false;
  const std::size_t words = words_of_slot(rows_);
  if (count > most_broken_) {
    most_broken_ = std::min(std::max<std::size_t>(count, 2 * most_broken_), slots_);
    words_of_broken_ = DeviceArray<std::uint32_t>(*device_, words * most_broken_);
    fracture_of_broken_ = DeviceArray<double>(*device_, most_broken_);
  }
  device_->launch(GatherBondsKernel{broken_.data(), count, words, words_.data(), fracture_.data(), words_of_broken_.data(), fracture_of_broken_.data()}, count);
  std::vector<std::uint32_t> slots(count), of_slots(words * count);
  std::vector<double> fracture(count);
  device_->download(slots.data(), broken_.data(), slots.size() * sizeof(std::uint32_t));
  device_->download(of_slots.data(), words_of_broken_.data(), of_slots.size() * sizeof(std::uint32_t));
  device_->download(fracture.data(), fracture_of_broken_.data(), fracture.size() * sizeof(double));
  std::vector<std::uint32_t> places(count);
  std::iota(places.begin(), places.end(), 0u);
  std::sort(places.begin(), places.end(), [&](std::uint32_t a, std::uint32_t b) { return slots[a] < slots[b]; });  // the order in which the host adds
  for (const std::uint32_t place : places) {
    const std::size_t eight = slots[place] / byte_lanes, lane = slots[place] % byte_lanes;
    std::uint8_t* const bytes = family.bytes(eight);
    for (std::size_t row = 0; row < rows_; ++row) {
      const std::uint32_t word = of_slots[row / bonds_of_word * count + place];
      const auto is_intact = static_cast<unsigned>(word >> (row % bonds_of_word)) & 1u, was_intact = (unsigned{bytes[row]} >> lane) & 1u;
      sums.broken_ends[eight] += was_intact - is_intact;
      bytes[row] = static_cast<std::uint8_t>((bytes[row] & ~(1u << lane)) | (is_intact << lane));
    }
    sums.fracture_energy[eight] += fracture[place];
  }
  return true;
}

/// The energy of each eight. `in_two_visits`: as the host adds it where particles are postponed, these last.
void BodyPasses::enter_energy(SumsOfEights& sums, bool in_two_visits) {
  if (!in_two_visits) {
    device_->launch(SumLanesKernel{energy_.data(), energy_of_eights_.data()}, sums.energy.size());
    return device_->download(sums.energy.data(), energy_of_eights_.data(), sums.energy.size() * sizeof(double));
  }
  std::vector<double> energy(slots_);
  std::vector<Found> found(slots_);
  device_->download(energy.data(), energy_.data(), energy.size() * sizeof(double));
  device_->download(found.data(), found_.data(), found.size() * sizeof(Found));
  std::fill(sums.energy.begin(), sums.energy.end(), 0.0);
  for (const bool is_postponed : {false, true})
    for (std::size_t slot = 0; slot < slots_; ++slot)
      if ((found[slot] != Found::nothing) == is_postponed) sums.energy[slot / byte_lanes] += energy[slot];
}

}  // namespace perimpact::device
