/// What a device launches and copies for one body: behind BodyOnDevice, apart from which nothing needs the kernels.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

#include "perimpact/body/body.hpp"
#include "perimpact/device/bonds_of_slots.hpp"
#include "perimpact/device/device.hpp"
#include "perimpact/device/eights_in_transit.hpp"
#include "perimpact/device/kernels.hpp"
#include "perimpact/device/lattice_tiles.hpp"
#include "perimpact/device/mirrored_vectors.hpp"
#include "perimpact/device/mirrors.hpp"

namespace perimpact::device {

/// The functions are those of BodyOnDevice.
class BodyPasses {
 public:
  BodyPasses(Device& device, Body& body);

  void advance(Particles& particles, double dt, std::span<double> travel);
  void evaluate(Body& body, double dt, bool with_energy);
  MotionSums motion_sums(const Particles& particles, double dt);
  void renew();
  void pressures_to_host();
  MirroredVectors& motion() { return motion_; }  ///< positions and velocities
  MirroredVectors& forces() { return forces_; }  ///< force densities
  Mirrors& mirrors() { return mirrors_; }        ///< of the arrays of the body
  ArraysOfBody arrays(Particles& particles) const;

 private:
  void pass(OrdinaryStateForce& force, Body& body, double dt, bool with_energy, SumsOfEights& sums);
  void pass(PlasticForce& force, Body& body, double dt, bool with_energy, SumsOfEights& sums);
  template <std::size_t D>
  void pass(CorrespondenceForce<D>& force, Body& body, double dt, bool with_energy, SumsOfEights& sums);
  template <std::size_t D>
  void account_for_broken(const CorrespondenceView<D>& view, SumsOfEights& sums);
  void upload_flow(const PlasticForce::Evaluation& evaluation);
  PlasticSlots plastic_slots(const PlasticForce::Evaluation& evaluation, Particles& particles, bool all) const;
  void launch(PlasticForce& force, const PlasticSlots& slots, const Body& body, const PassOptions& options);
  void enter_stress(const PlasticForce::Evaluation& evaluation, bool all);
  void begin_return(const PlasticForce::Evaluation& evaluation, const PlasticSlots& slots);
  void enter_return(const PlasticForce::Evaluation& evaluation, const Particles& particles, double dt);
  void enter_density(const Particles& particles, SumsOfEights& sums);
  /// Of a kernel that loops over bonds, for each slot.
  template <class Kernel>
  void launch_tiled(const Kernel& kernel) {
    device_->launch(Tiled<Kernel>{kernel, tiles_}, tiles_.threads());
  }
  BondsOfSlots bonds(const Family& family) const;
  Findings findings() const;
  void forget_broken();
  template <class Visit>
  void for_each_visit(const Breaking& breaking, const Body& body, const Visit& visit);
  void upload_bonds(const Family& family);
  bool enter_broken(Family& family, SumsOfEights& sums);
  void enter_energy(SumsOfEights& sums, bool in_two_visits);

  Device* device_;
  std::size_t slots_, rows_;
  LatticeTiles tiles_;
  bool is_renewed_ = false;
  bool is_flow_outdated_ = false;      // on the device, in any slots
  std::span<double> pressures_there_;  // [Pa] of the host, of which the device has later values
  Mirrors mirrors_;
  MirroredVectors motion_, forces_;
  EightsInTransit eights_;
  DeviceArray<std::uint32_t> words_;  // bonds
  DeviceArray<double> travel_, energy_, energy_of_eights_, fracture_;
  DeviceArray<MotionSums> motion_sums_;  // of eights
  DeviceArray<Found> found_;
  DeviceArray<std::uint8_t> is_hot_, hot_bits_;
  // of eights that are evaluated again
  std::vector<std::uint32_t> returning_;
  std::size_t most_returning_ = 0;  // room, in eights
  DeviceArray<std::uint32_t> list_of_returning_;
  DeviceArray<double> forces_before_, lost_work_;     // [N/m³], [J]
  DeviceArray<std::uint32_t> broken_count_, broken_;  // a GrowingList
  std::size_t most_broken_ = 0;                       // room in the arrays of a list, in slots
  DeviceArray<std::uint32_t> words_of_broken_;
  DeviceArray<double> fracture_of_broken_;

  // of a correspondence material
  struct KnownShapes {
    KnownShapes() = default;
    KnownShapes(Device& device, std::size_t slots, std::size_t word_count);
    DeviceArray<std::uint32_t> words;            // bonds for which K⁻¹ was computed
    DeviceArray<std::uint8_t> nearness, raised;  // of each eight, to bonds that broke in the pass
    DeviceArray<double> energy_before;           // [J] of each slot near them
  };
  KnownShapes known_;
};

/// visit(breaker) for each visit of the bonds in a pass in which they may break.
template <class Visit>
void BodyPasses::for_each_visit(const Breaking& breaking, const Body& body, const Visit& visit) {
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
        device_->launch(PressedStrengthKernel{bonds(body.family), pressed.lengths, mirrors_.on_device(body.particles.view()).position,
                                              hardening_slope(*breaking.rule()), mirrors_.at(breaking.half_strength().component(0)),
                                              mirrors_.writable(breaking.pressed_half_strength().component(0)), found_.data()},
                        slots_);
        visit(pressed);
      });
    }
  });
}

}  // namespace perimpact::device
