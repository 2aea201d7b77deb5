#include "perimpact/device/body_on_device.hpp"

#include <doctest/doctest.h>

#include <map>
#include <random>
#include <string>
#include <vector>

#include "perimpact/bodies.hpp"
#include "perimpact/device/emulated_device.hpp"
#include "perimpact/particles/advance.hpp"

namespace perimpact {

namespace {

/// A deformed body in motion.
Body moving(const fixtures::BodyOptions& options) {
  Body body = fixtures::body(options);
  fixtures::shake(body, 2e-6);
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> speed(-30, 30);
  for (const std::uint32_t slot : body.particles.slot_of())
    body.particles.velocity.set(slot, {speed(random), speed(random), body.particles.is_plane() ? 0 : speed(random)});
  return body;
}

/// Everything that the state and the record of a body name, by name.
std::map<std::string, std::vector<double>> numbers_of(Body& body) {
  std::map<std::string, std::vector<double>> all;
  const auto visit = [&](std::string_view name, auto&& values) {
    const auto numbers = fccda::numbers_in(values);
    all[std::string(name)].assign(numbers.begin(), numbers.end());
  };
  body.visit_state(visit);
  body.visit_record(visit);
  return all;
}

/// Every failure rule, and none.
std::vector<fixtures::NamedOptions> with_failure(const fixtures::NamedOptions& one) {
  std::vector<fixtures::NamedOptions> all{one};
  const auto add = [&](const std::string& name, const FailureSetup& failure) {
    fixtures::BodyOptions options = one.options;
    options.critical_stretch = 6e-3;
    options.failure = failure;
    all.push_back({one.name + ", " + name, options});
  };
  FailureSetup failure;
  add("tension", failure);
  failure.compression_hardening = 0.3;
  add("tension with hardening", failure);
  failure.weibull_modulus = 5;
  add("scattered strength with hardening", failure);
  failure.compression.index = static_cast<int>(CompressionFailure::limit);
  failure.critical_compression = 8e-3;
  add("compressive limit with hardening", failure);
  failure.compression_hardening = 0;
  add("compressive limit", failure);
  return all;
}

constexpr double dt = 5e-8;
constexpr int steps = 6;

}  // namespace

TEST_CASE("device: state, energies and travel are bitwise those of the scalar kernel, for every material, correction and failure rule on a lattice") {
  std::size_t broken = 0, cases = 0;
  for (const fixtures::NamedOptions& material : fixtures::every_body({0.010, 0.007, 0.006})) {
    if (material.options.points != fixtures::Points::lattice || material.options.model == fixtures::Model::correspondence) continue;
    for (const fixtures::NamedOptions& one : with_failure(material)) {
      CAPTURE(one.name);
      Body on_host = moving(one.options), body = moving(one.options);
      on_host.internal.use_scalar_kernel();
      EmulatedDevice device;
      BodyOnDevice on_device(device, body);
      std::vector<double> travel_of_host(travel_blocks(body.particles)), travel(travel_of_host.size());
      for (int step = 0; step < steps; ++step) {
        const bool with_energy = step % 2 == 0;
        if (with_energy)
          on_host.internal.evaluate_with_energy(on_host.particles, on_host.family, dt);
        else
          on_host.internal.evaluate(on_host.particles, on_host.family, dt);
        on_device.evaluate(body, dt, with_energy);
        CHECK(body.internal.elastic_energy() == on_host.internal.elastic_energy());
        CHECK(numbers_of(body) == numbers_of(on_host));
        advance(on_host.particles, dt, travel_of_host);
        on_device.advance(body.particles, dt, travel);
        CHECK(travel == travel_of_host);
      }
      CHECK(numbers_of(body) == numbers_of(on_host));
      broken += body.internal.broken_bonds();
      ++cases;
    }
  }
  CHECK(cases > 60);
  CHECK(broken > 1000);
}

TEST_CASE("device: what travels in a step is what traffic_of_step says, also where bonds are armed") {
  EmulatedDevice device;
  Body body = fixtures::body({.critical_stretch = 1.0});
  BodyOnDevice on_device(device, body);
  std::vector<double> travel(travel_blocks(body.particles));
  const EmulatedDevice::Copied before = device.copied();
  on_device.advance(body.particles, dt, travel);
  on_device.evaluate(body, dt, false);
  const DeviceTraffic copied{device.copied().uploaded - before.uploaded, device.copied().downloaded - before.downloaded};
  CHECK(copied == BodyOnDevice::traffic_of_step(body.particles));
}

TEST_CASE("device: after renew() it continues from a state that the host has changed") {
  EmulatedDevice device;
  const fixtures::BodyOptions options{.critical_stretch = 6e-3};
  Body body = moving(options), other = moving(options);
  other.internal.use_scalar_kernel();
  BodyOnDevice on_device(device, body);
  on_device.evaluate(body, dt, false);
  std::vector<double> travel(travel_blocks(body.particles));
  for (Body* one : {&body, &other}) {
    *one->family.bytes(one->particles.slot_of().front() / 8) = 0;
    fixtures::shake(*one, 1e-6, 9);
  }
  other.internal.evaluate(other.particles, other.family, dt);
  on_device.renew();
  on_device.evaluate(body, dt, false);
  CHECK(body.particles.force_density.at(body.particles.slot_of().front()) == other.particles.force_density.at(other.particles.slot_of().front()));
  on_device.renew();
  for (Body* one : {&body, &other}) fixtures::shake(*one, 1e-6, 10);
  on_device.advance(body.particles, dt, travel);
  advance(other.particles, dt, travel);
  for (const std::uint32_t slot : body.particles.slot_of()) CHECK(body.particles.position.at(slot) == other.particles.position.at(slot));
}

}  // namespace perimpact
