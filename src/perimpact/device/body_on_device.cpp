#include "perimpact/device/body_on_device.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "perimpact/deck_model/setup_error.hpp"
#include "perimpact/discretisation/cloud_of.hpp"
#include "perimpact/particles/advance.hpp"

namespace perimpact {

using namespace device;
using fccda::byte_lanes;

namespace {

/// f(array) for the components of an array, without slack.
template <class F>
void for_each_component(const VectorArray& array, const F& f) {
  for (const double* component : array.pointers()) f(std::span<const double>(component, array.slots()));
}

[[noreturn]] void refuse(const std::string& key, std::string_view what) {
  throw SetupError(key, fmt::format("{} not supported on a device; omit --device.", what));
}

}  // namespace

void expect_supported_by_devices(const Setup& setup) {
  if (setup.time.relax) refuse("time.relax", "quasi-static increments are");
  for (const BodySetup& body : setup.bodies) {
    const std::string key = "bodies." + body.name;
    if (is_cloud(body)) refuse(key + ".shape", "bodies from a file of particles are");
    if (body.moving_window) refuse(key + ".moving_window", "moving windows are");
    if (body.elastic().plasticity) refuse(key + ".material.plasticity", "materials that yield are");
    std::visit(
        [&](const auto& material) {
          using Force = typename Material<std::decay_t<decltype(material)>>::Force;
          if constexpr (!std::is_constructible_v<Force, OrdinaryStateForce>) refuse(key + ".material.model", fmt::format("the model {} is", material.name));
        },
        body.material);
  }
}

BodyOnDevice::BodyOnDevice(Device& device, const Body& body)
    : device_(&device),
      slots_(body.particles.slots()),
      rows_(body.family.offsets().size()),
      mirrors_(device),
      words_(device, words_of(slots_, rows_)),
      travel_(device, travel_blocks(body.particles)),
      energy_(device, slots_),
      fracture_(device, slots_),
      found_(device, slots_),
      any_broken_(device, 1) {
  const auto add = [&](const auto& array) { mirrors_.add(array); };
  body.particles.visit_arrays(add);
  add(body.family.offsets());
  body.internal.ordinary_state()->visit_arrays(add);
  upload_bonds(body.family);
}

void BodyOnDevice::upload_motion(const Particles& particles) {
  for (const VectorArray* array : {&particles.position, &particles.velocity}) for_each_component(*array, [&](auto part) { mirrors_.upload(part); });
}

void BodyOnDevice::advance(Particles& particles, double dt, std::span<double> travel) {
  if (is_renewed_) upload_motion(particles);
  for_each_component(particles.force_density, [&](auto part) { mirrors_.upload(part); });
  const Motion motion = mirrors_.on_device(motion_of(particles, dt));
  device_->launch(AdvanceKernel{motion}, slots_);
  device_->launch(TravelKernel{motion, slots_, travel_.data()}, travel.size());
  for (VectorArray* array : {&particles.position, &particles.velocity})
    for (double* component : array->writable_pointers()) mirrors_.download(std::span(component, slots_));
  device_->download(travel.data(), travel_.data(), travel.size_bytes());
}

void BodyOnDevice::evaluate(Body& body, double dt, bool with_energy) {
  if (std::exchange(is_renewed_, false)) upload_bonds(body.family);
  upload_motion(body.particles);
  body.internal.with_kernel_and_sums([&](auto& force, SumsOfEights& sums) {
    if constexpr (std::is_same_v<std::decay_t<decltype(force)>, OrdinaryStateForce>) pass(force, body, dt, with_energy, sums);
  });
}

/// visit(breaker) for each visit of the bonds in a pass in which they may break.
template <class Visit>
void BodyOnDevice::for_each_visit(const Breaking& breaking, const Body& body, const Visit& visit) {
  breaking.choose<StencilBonds>(body.family, true, [&](const auto& of_host) {
    using Breaker = std::decay_t<decltype(of_host)>;
    const Breaker breaker = mirrors_.on_device(of_host);
    if constexpr (!Breaker::is_armed) {
      visit(breaker);
    } else {
      visit(Noting<Breaker>{breaker});
      if (breaking.rule()->hardening == 0) return visit(breaker);
      breaking.choose_by_strength<StencilBonds>(body.family, breaking.pressed_half_strength(), [&](const auto& pressed_of_host) {
        const auto pressed = mirrors_.on_device(pressed_of_host);
        device_->launch(PressedStrengthKernel{BondsOfSlots(words_.data(), mirrors_.at(body.family.offsets().data()), rows_), pressed.lengths,
                                              mirrors_.on_device(body.particles.view()).position, hardening_slope(*breaking.rule()),
                                              mirrors_.at(breaking.half_strength().component(0)),
                                              mirrors_.writable(breaking.pressed_half_strength().component(0)), found_.data()},
                        slots_);
        visit(pressed);
      });
    }
  });
}

void BodyOnDevice::pass(OrdinaryStateForce& force, Body& body, double dt, bool with_energy, SumsOfEights& sums) {
  std::uint32_t any_broken = 0;
  device_->upload(any_broken_.data(), &any_broken, sizeof any_broken);
  const Findings findings{found_.data(), energy_.data(), fracture_.data(), any_broken_.data()};
  const BondsOfSlots bonds(words_.data(), mirrors_.at(body.family.offsets().data()), rows_);
  const bool has_dilatation = force.law().needs_dilatation();
  force.with_view_of_lattice(body.particles, bonds, rows_, dt, [&](const auto& view_of_host, const auto& corrections_of_host) {
    const auto view = mirrors_.on_device(view_of_host);
    const auto corrections = mirrors_.on_device(corrections_of_host);
    using Corrections = std::decay_t<decltype(corrections)>;
    const auto launch = [&](const Kernel& kernel) { device_->launch(kernel, slots_); };
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
  for (double* component : body.particles.force_density.writable_pointers()) mirrors_.download(std::span(component, slots_));
  device_->download(&any_broken, any_broken_.data(), sizeof any_broken);
  if (any_broken != 0) enter_broken(body.family, sums);
  const std::optional<BreakingRule>& rule = force.breaking().rule();
  if (with_energy) enter_energy(sums, rule && rule->hardening > 0 && !has_dilatation);
}

void BodyOnDevice::upload_bonds(const Family& family) {
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

/// The bonds that broke, in the family and the sums.
void BodyOnDevice::enter_broken(Family& family, SumsOfEights& sums) {
  const std::size_t words = words_of_slot(rows_);
  std::vector<Found> found(slots_);
  std::vector<double> fracture(slots_);
  std::vector<std::uint32_t> of_slots(words_of(slots_, rows_));
  device_->download(found.data(), found_.data(), found.size() * sizeof(Found));
  device_->download(fracture.data(), fracture_.data(), fracture.size() * sizeof(double));
  device_->download(of_slots.data(), words_.data(), of_slots.size() * sizeof(std::uint32_t));
  for (std::size_t slot = 0; slot < slots_; ++slot) {
    if (found[slot] != Found::broken) continue;
    const std::size_t eight = slot / byte_lanes, lane = slot % byte_lanes;
    std::uint8_t* const bytes = family.bytes(eight);
    for (std::size_t row = 0; row < rows_; ++row) {
      const std::uint32_t word = of_slots[first_word(slot, words) + row / bonds_of_word * slots_of_group];
      const auto is_intact = static_cast<unsigned>(word >> (row % bonds_of_word)) & 1u, was_intact = (unsigned{bytes[row]} >> lane) & 1u;
      sums.broken_ends[eight] += was_intact - is_intact;
      bytes[row] = static_cast<std::uint8_t>((bytes[row] & ~(1u << lane)) | (is_intact << lane));
    }
    sums.fracture_energy[eight] += fracture[slot];
  }
}

/// The energy of each eight. `in_two_visits`: as the host adds it where particles are postponed, these last.
void BodyOnDevice::enter_energy(SumsOfEights& sums, bool in_two_visits) {
  std::vector<double> energy(slots_);
  std::vector<Found> found(slots_, Found::nothing);
  device_->download(energy.data(), energy_.data(), energy.size() * sizeof(double));
  if (in_two_visits) device_->download(found.data(), found_.data(), found.size() * sizeof(Found));
  std::fill(sums.energy.begin(), sums.energy.end(), 0.0);
  for (const bool is_postponed : {false, true})
    for (std::size_t slot = 0; slot < slots_; ++slot)
      if ((found[slot] != Found::nothing) == is_postponed) sums.energy[slot / byte_lanes] += energy[slot];
}

DeviceTraffic BodyOnDevice::traffic_of_step(const Particles& particles) {
  constexpr std::size_t vector = 3 * sizeof(double), flag = sizeof(std::uint32_t);
  // up: forces, then positions and velocities; down: positions and velocities, then forces
  return {3 * vector * particles.slots() + flag, 3 * vector * particles.slots() + sizeof(double) * travel_blocks(particles) + flag};
}

}  // namespace perimpact
