#include "perimpact/device/body_on_device.hpp"

#include <string>
#include <string_view>

#include <fmt/format.h>

#include "perimpact/deck_model/setup_error.hpp"
#include "perimpact/device/body_passes.hpp"
#include "perimpact/device/mirrored_vectors.hpp"
#include "perimpact/discretisation/cloud_of.hpp"
#include "perimpact/particles/advance.hpp"

namespace perimpact {

namespace {

[[noreturn]] void refuse(const std::string& key, std::string_view what) {
  throw SetupError(key, fmt::format("{} not supported on a device; omit --device.", what));
}

}  // namespace

void expect_supported_by_devices(const Setup& setup) {
  if (setup.time.relax) refuse("time.relax", "quasi-static increments are");
  for (const BodySetup& body : setup.bodies) {
    const std::string key = "bodies." + body.name;
    if (is_cloud(body)) refuse(key + ".shape", "bodies from a file of particles are");
  }
}

BodyOnDevice::BodyOnDevice(Device& device, Body& body) : passes_(std::make_unique<device::BodyPasses>(device, body)) {}
BodyOnDevice::BodyOnDevice(BodyOnDevice&&) noexcept = default;
BodyOnDevice::~BodyOnDevice() = default;

void BodyOnDevice::advance(Particles& particles, double dt, std::span<double> travel) { passes_->advance(particles, dt, travel); }
void BodyOnDevice::evaluate(Body& body, double dt, bool with_energy) { passes_->evaluate(body, dt, with_energy); }
MotionSums BodyOnDevice::motion(const Body& body, double dt) { return passes_->motion_sums(body.particles, dt); }
void BodyOnDevice::renew() { passes_->renew(); }

void BodyOnDevice::to_host() const {
  passes_->motion().to_host();
  passes_->forces().to_host();
  passes_->pressures_to_host();
}
void BodyOnDevice::to_host(std::span<const std::uint32_t> slots) const {
  passes_->motion().to_host(slots);
  passes_->forces().to_host(slots);
}
void BodyOnDevice::moved_on_host(std::span<const std::uint32_t> slots) { passes_->motion().changed_on_host(slots); }
void BodyOnDevice::loaded_on_host() { passes_->forces().changed_on_host(); }
void BodyOnDevice::loaded_on_host(std::span<const std::uint32_t> slots) { passes_->forces().changed_on_host(slots); }

DeviceTraffic BodyOnDevice::traffic_of_step(Body& body, const SlotsOnHost& on_host) {
  const Particles& particles = body.particles;
  constexpr std::size_t vector = 3 * sizeof(double), flag = sizeof(std::uint32_t), number = sizeof(std::uint32_t);
  DeviceTraffic traffic{flag, sizeof(double) * travel_blocks(particles) + flag};
  const auto is_most = [&](std::size_t listed) { return device::MirroredVectors::is_most(listed, particles.slots()); };
  const auto count = [&](std::size_t& way, std::size_t listed, std::size_t vectors) {
    way += vectors * vector * (is_most(listed) ? particles.slots() : listed);
    if (!is_most(listed)) traffic.uploaded += number * listed;
  };
  constexpr std::size_t motion = 2, force = 1;  // vectors
  count(traffic.downloaded, on_host.due, motion);
  if (!is_most(on_host.loaded)) count(traffic.downloaded, on_host.due, force);  // otherwise they have been there since the step before
  count(traffic.uploaded, on_host.displaced, motion);
  count(traffic.downloaded, on_host.loaded, motion);
  count(traffic.downloaded, on_host.loaded, force);
  count(traffic.uploaded, on_host.loaded, force);
  traffic.downloaded += on_host.broken * (number + sizeof(double) + sizeof(std::uint32_t) * device::words_of_slot(body.family.offsets().size()));
  if (PlasticForce* plastic = body.internal.plastic()) {
    traffic.downloaded += particles.slots() / fccda::byte_lanes;                                          // whether the stress is known
    if (plastic->law().needs_dilatation()) traffic.downloaded += 6 * sizeof(double) * particles.slots();  // then it is known of all
  }
  return traffic;
}

}  // namespace perimpact
