#include "perimpact/device/body_on_device.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "fixtures/larger.hpp"
#include "perimpact/device/emulated_device.hpp"
#include "perimpact/ices.hpp"
#include "perimpact/particles/advance.hpp"

using namespace perimpact;

namespace {

/// A deformed body in motion.
Body moving(const fixtures::BodyOptions& options) {
  Body body = fixtures::body(options);
  fixtures::shake(body, 2e-6);
  fixtures::set_random_velocities(body, 30);
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

/// A force as of a boundary condition, and a relocation as by contact.
void add_force_of_host(Particles& particles) {
  const std::uint32_t slot = particles.slot_of().back();
  particles.force_density.set(slot, particles.force_density.at(slot) + Vec3d{1e12, 0, 0});
}
void move_by_host(Particles& particles) {
  const std::uint32_t slot = particles.slot_of().front();
  particles.position.set(slot, particles.position.at(slot) + Vec3d{1e-7, 0, 0});
  particles.velocity.set(slot, 0.5 * particles.velocity.at(slot));
}

constexpr double dt = 5e-8;
constexpr int steps = 6;

}  // namespace

TEST_CASE("device: state, energies and travel are bitwise those of the scalar kernel, for every material, correction and failure rule on a lattice") {
  std::size_t broken = 0, cases = 0;
  for (const fixtures::NamedOptions& material : fixtures::every_body({0.010, 0.007, 0.006})) {
    if (material.options.points != fixtures::Points::lattice) continue;
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
        const bool reads_all = step % 3 == 0;
        if (reads_all) {
          on_device.to_host();
          CHECK(numbers_of(body) == numbers_of(on_host));
        }
        const std::uint32_t loaded[] = {body.particles.slot_of().back()}, moved[] = {body.particles.slot_of().front()};
        on_device.to_host(loaded);
        for (Body* each : {&body, &on_host}) add_force_of_host(each->particles);
        on_device.loaded_on_host(loaded);
        advance(on_host.particles, dt, travel_of_host);
        on_device.advance(body.particles, dt, travel);
        CHECK(travel == travel_of_host);
        on_device.to_host(moved);
        for (Body* each : {&body, &on_host}) move_by_host(each->particles);
        on_device.moved_on_host(moved);
      }
      on_device.to_host();
      CHECK(numbers_of(body) == numbers_of(on_host));
      broken += body.internal.broken_bonds();
      ++cases;
    }
  }
  CHECK(cases > 60);
  CHECK(broken > 1000);
}

TEST_CASE("device: ice that yields, loses its cohesion and breaks has bitwise the state and energies of the scalar kernel, for every correction") {
  std::size_t broken = 0, yielded = 0, crushed = 0;
  for (const fixtures::NamedIce& one : fixtures::every_ice({1.1, 0.6, 0.5})) {
    if (one.options.points != fixtures::Points::lattice) continue;
    for (const bool has_friction : {false, true}) {
      CAPTURE(one.name);
      CAPTURE(has_friction);
      fixtures::IceOptions options = one.options;
      options.critical_stretch = 2e-3;
      if (has_friction) options.friction_angle = 0.5, options.failure_strain = 1e-4, options.failure_width = 30;
      Body on_host = fixtures::ice(options), body = fixtures::ice(options);
      for (Body* each : {&on_host, &body}) fixtures::draw_strains(*each, 3e-4);
      on_host.internal.use_scalar_kernel();
      EmulatedDevice device;
      BodyOnDevice on_device(device, body);
      for (int step = 1; step <= 6; ++step) {
        const double e = (step < 5 ? 1 : -2) * step * 1e-3;  // at last in tension
        on_device.to_host();
        for (Body* each : {&on_host, &body}) {
          fixtures::strain_uniformly(*each, {-e, 0.5 * e, -0.2 * e, 0.1 * e, 0, 0.3 * e});
          fixtures::shake(*each, 2e-4 * fixtures::spacing, static_cast<unsigned>(step));
          for (const std::uint32_t slot : each->particles.slot_of()) each->particles.velocity.set(slot, 10 * each->particles.displacement(slot));
        }
        on_device.moved_on_host(body.particles.slot_of());
        const bool with_energy = step % 2 == 0;
        if (with_energy)
          on_host.internal.evaluate_with_energy(on_host.particles, on_host.family, 1e-4);
        else
          on_host.internal.evaluate(on_host.particles, on_host.family, 1e-4);
        on_device.evaluate(body, 1e-4, with_energy);
        on_device.to_host();
        CHECK(body.internal.elastic_energy() == on_host.internal.elastic_energy());
        CHECK(numbers_of(body) == numbers_of(on_host));
      }
      broken += body.internal.broken_bonds();
      for (const std::uint32_t slot : body.particles.slot_of()) {
        yielded += body.internal.plastic()->equivalent_strain(slot) > 0 ? 1 : 0;
        crushed += body.internal.plastic()->has_lost_cohesion(slot) ? 1 : 0;
      }
    }
  }
  CHECK(broken > 1000);
  CHECK(yielded > 1000);
  CHECK(crushed > 0);
}

TEST_CASE("device: what travels in a step is what traffic_of_step says, of elastic bodies and of ice that yields, where bonds may break") {
  Body bodies[] = {fixtures::body({.critical_stretch = 1.0}), fixtures::ice({.critical_stretch = 1.0}),
                   fixtures::ice({.poissons_ratio = 0.33, .critical_stretch = 1.0})};
  for (Body& body : bodies) {
    const std::size_t all = body.particles.slots();
    for (const SlotsOnHost& on_host : {SlotsOnHost{}, SlotsOnHost{.due = 30, .displaced = 5}, SlotsOnHost{.due = 30, .displaced = 5, .loaded = 20},
                                       SlotsOnHost{.due = 30, .displaced = 5, .loaded = all}, SlotsOnHost{.due = 30, .loaded = all}}) {
      CAPTURE(on_host.loaded);
      EmulatedDevice device;
      BodyOnDevice on_device(device, body);
      std::vector<double> travel(travel_blocks(body.particles));
      std::vector<std::uint32_t> loaded(on_host.loaded), due;
      for (std::uint32_t n = 0; n < loaded.size(); ++n) loaded[n] = n;
      for (std::uint32_t n = 0; n < on_host.due; ++n) due.push_back(100 + n);
      const auto step = [&] {  // as Simulation::perform_step()
        on_device.advance(body.particles, dt, travel);
        on_device.to_host(due);
        on_device.moved_on_host(std::span<const std::uint32_t>(due).first(on_host.displaced));
        on_device.evaluate(body, dt, false);
        on_device.to_host(loaded);
        on_device.loaded_on_host(loaded);
      };
      on_device.evaluate(body, 0, false);
      step();
      const EmulatedDevice::Copied before = device.copied();
      step();
      const DeviceTraffic copied{device.copied().uploaded - before.uploaded, device.copied().downloaded - before.downloaded};
      CHECK(copied == BodyOnDevice::traffic_of_step(body, on_host));
    }
  }
}

TEST_CASE("device: where bonds break, those of the slots that lose some travel, and no others") {
  for (const double nu : {0.25, 0.4}) {  // bonds break in the only pass, and in the first of two
    CAPTURE(nu);
    Body body = moving({.poissons_ratio = nu, .critical_stretch = 6e-3});
    EmulatedDevice device;
    BodyOnDevice on_device(device, body);
    std::vector<double> travel(travel_blocks(body.particles));
    on_device.evaluate(body, 0, false);
    std::size_t fewest = body.particles.size(), most = 0;
    for (const double amount : {2e-6, 3e-6, 6e-6}) {
      on_device.to_host();
      fixtures::shake(body, amount, 3);
      on_device.moved_on_host(body.particles.slot_of());
      const Family before = body.family;
      const std::size_t copied = device.copied().downloaded;
      on_device.advance(body.particles, dt, travel);
      on_device.evaluate(body, dt, false);
      SlotsOnHost on_host;
      for (const std::uint32_t slot : body.particles.slot_of()) on_host.broken += body.family.damage(slot) != before.damage(slot) ? 1 : 0;
      CHECK(device.copied().downloaded - copied == BodyOnDevice::traffic_of_step(body, on_host).downloaded);
      fewest = std::min(fewest, on_host.broken), most = fixtures::larger(most, on_host.broken);
    }
    CHECK(fewest < body.particles.size() / 4);
    CHECK(most > 100);
  }
}

TEST_CASE("device: where energies are sampled, a number of each eight travels in addition") {
  for (const double nu : {0.25, 0.4}) {
    CAPTURE(nu);
    Body body = moving({.poissons_ratio = nu, .critical_stretch = 1.0});
    EmulatedDevice device;
    BodyOnDevice on_device(device, body);
    on_device.evaluate(body, dt, false);
    std::size_t downloaded[2];
    for (const bool with_energy : {false, true}) {
      const std::size_t before = device.copied().downloaded;
      on_device.evaluate(body, dt, with_energy);
      downloaded[with_energy ? 1 : 0] = device.copied().downloaded - before;
    }
    CHECK(downloaded[1] - downloaded[0] == body.particles.slots() / 8 * sizeof(double));
    CHECK(body.internal.elastic_energy() > 0);
  }
}

TEST_CASE("device: after renew() it continues from a state that the host has changed") {
  EmulatedDevice device;
  const fixtures::BodyOptions options{.critical_stretch = 6e-3};
  Body body = moving(options), other = moving(options);
  other.internal.use_scalar_kernel();
  BodyOnDevice on_device(device, body);
  on_device.evaluate(body, dt, false);
  std::vector<double> travel(travel_blocks(body.particles));
  on_device.to_host();
  for (Body* one : {&body, &other}) {
    std::fill_n(one->family.bytes(one->particles.slot_of().front() / 8), one->family.offsets().size(), std::uint8_t{0});
    fixtures::shake(*one, 1e-6, 9);
  }
  other.internal.evaluate(other.particles, other.family, dt);
  on_device.renew();
  on_device.evaluate(body, dt, false);
  on_device.to_host();
  CHECK(body.particles.force_density.at(body.particles.slot_of().front()) == other.particles.force_density.at(other.particles.slot_of().front()));
  on_device.renew();
  for (Body* one : {&body, &other}) fixtures::shake(*one, 1e-6, 10);
  on_device.advance(body.particles, dt, travel);
  advance(other.particles, dt, travel);
  on_device.to_host();
  for (const std::uint32_t slot : body.particles.slot_of()) CHECK(body.particles.position.at(slot) == other.particles.position.at(slot));
}
