#include "perimpact/device/body_on_device.hpp"

#include <string>
#include <string_view>
#include <type_traits>
#include <variant>

#include <fmt/format.h>

#include "perimpact/deck_model/setup_error.hpp"
#include "perimpact/device/body_passes.hpp"
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
    if (body.moving_window) refuse(key + ".moving_window", "moving windows are");
    std::visit(
        [&](const auto& material) {
          using Force = typename Material<std::decay_t<decltype(material)>>::Force;
          if constexpr (!std::is_constructible_v<Force, OrdinaryStateForce>) refuse(key + ".material.model", fmt::format("the model {} is", material.name));
        },
        body.material);
  }
}

BodyOnDevice::BodyOnDevice(Device& device, const Body& body) : passes_(std::make_unique<device::BodyPasses>(device, body)) {}
BodyOnDevice::BodyOnDevice(BodyOnDevice&&) noexcept = default;
BodyOnDevice::~BodyOnDevice() = default;

void BodyOnDevice::advance(Particles& particles, double dt, std::span<double> travel) { passes_->advance(particles, dt, travel); }
void BodyOnDevice::evaluate(Body& body, double dt, bool with_energy) { passes_->evaluate(body, dt, with_energy); }
void BodyOnDevice::renew() { passes_->renew(); }

DeviceTraffic BodyOnDevice::traffic_of_step(Body& body) {
  const Particles& particles = body.particles;
  constexpr std::size_t vector = 3 * sizeof(double), flag = sizeof(std::uint32_t);
  // up: forces, then positions and velocities; down: positions and velocities, then forces
  DeviceTraffic traffic{3 * vector * particles.slots() + flag, 3 * vector * particles.slots() + sizeof(double) * travel_blocks(particles) + flag};
  if (PlasticForce* plastic = body.internal.plastic()) {
    traffic.downloaded += (sizeof(double) + sizeof(std::uint8_t)) * particles.slots();  // pressure, and whether the stress is known
    if (plastic->law().needs_dilatation()) {                                            // then it is known of all
      traffic.downloaded += 6 * sizeof(double) * particles.slots();
      const PlasticForce::Evaluation evaluation = plastic->evaluation();
      traffic.uploaded += evaluation.is_plastic.size_bytes();
      for (const std::span<const double> array : evaluation.of_flow) traffic.uploaded += array.size_bytes();
    }
  }
  return traffic;
}

}  // namespace perimpact
