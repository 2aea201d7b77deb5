// The kernels of water and of the absorbing layer on packs, against plain loops over particles with the formulas of floating.hpp and absorbing.hpp: bitwise,
// since the operations of a pack are rounded as those of one number.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "perimpact/bodies.hpp"
#include "perimpact/boundary_conditions/absorbing/absorbing.hpp"
#include "perimpact/boundary_conditions/floating/floating.hpp"

using namespace perimpact;

namespace {

constexpr double sea = 1025, gravity = 9.81, dt = 1e-4;

/// A body that lies across the level 0, in motion under forces, with some bonds cut.
struct Scene {
  Body body;
  std::vector<std::uint32_t> broken_ends;

  explicit Scene(const fixtures::BodyOptions& options) : body(fixtures::body(options)), broken_ends(body.particles.slots() / 8, 0) {
    fixtures::shake(body, 2e-4, 3);
    fixtures::set_random_velocities(body, 30, 4);
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> force(-1e6, 1e6);
    for (std::size_t slot = 0; slot < body.particles.slots(); ++slot)
      body.particles.force_density.set(slot, slot % 5 == 0 ? Vec3d{-0.0, -0.0, -0.0} : Vec3d{force(random), force(random), force(random)});
    for (std::size_t eight = 0; eight < broken_ends.size(); eight += 3) cut(eight, random);
  }
  void cut(std::size_t eight, std::mt19937_64& random) {
    const std::size_t rows = body.family.begin(eight + 1) - body.family.begin(eight), row = random() % std::max<std::size_t>(rows, 1);
    if (rows == 0) return;
    std::uint8_t& bits = body.family.bytes(eight)[row];
    const auto kept = static_cast<std::uint8_t>(bits & (random() & 0xff));
    broken_ends[eight] += static_cast<std::uint32_t>(std::popcount(static_cast<unsigned>(bits ^ kept)));
    bits = kept;
  }
  /// All particles, or those of every second eight and of odd slots.
  std::vector<std::uint32_t> slots(bool all) const {
    std::vector<std::uint32_t> some;
    for (const std::uint32_t slot : body.particles.slot_of())
      if (all || slot / 8 % 2 == 0 || slot % 2 == 1) some.push_back(slot);
    return some;
  }
};

/// Bits, which tell zeros of either sign apart.
std::vector<std::uint64_t> bits_of(const VectorArray& vectors) {
  std::vector<std::uint64_t> bits;
  for (const double number : vectors.with_slack()) bits.push_back(std::bit_cast<std::uint64_t>(number));
  return bits;
}

/// What acts on the particles in two instants, particle by particle.
struct PlainWater {
  const Scene& scene;
  const Water water;
  const std::vector<std::uint32_t> slots;
  const std::vector<std::uint32_t> held;  // along x and z
  Exposure exposure{scene.body.particles, scene.body.family, scene.broken_ends};
  std::map<std::uint32_t, Vec3d> latest = {};
  std::vector<std::uint32_t> in_contact = {};  // ascending

  std::array<int, 2> column(std::uint32_t slot) const {
    const auto [i, j, layer] = scene.body.particles.lattice()->cell(slot);
    return {i, j};
  }
  bool has_columns() const { return water.entrained_depth != 0 || water.dry_top != 0; }

  /// The tops that are dry: uppermost of their column and of the body, without lost bonds in the column, and not deeper than dry_top.
  std::vector<bool> dry(const Particles& particles) const {
    std::vector<bool> is_dry(particles.slots(), false);
    if (water.dry_top == 0) return is_dry;
    std::map<std::array<int, 2>, std::uint32_t> top;
    std::map<std::array<int, 2>, bool> lost;
    for (const std::uint32_t slot : slots) top[column(slot)] = slot, lost[column(slot)] |= exposure.has_lost(slot);
    for (const auto& one : top) {
      const std::array<int, 2>& of = one.first;
      const std::uint32_t slot = one.second;
      const bool is_covered = std::ranges::any_of(particles.slot_of(), [&](std::uint32_t other) { return other > slot && column(other) == of; });
      const double depth = water.level - particles.position.at(slot).z - 0.5 * particles.size_of(slot);
      is_dry[slot] = !is_covered && !lost[of] && !(depth > water.dry_top);
    }
    return is_dry;
  }

  Hydrostatics lift(Particles& particles, const std::vector<bool>& is_dry) const {
    const double weight = particles.material_density() * water.gravity, lift = water.density * water.gravity;
    struct Sum {
      double lift, potential;
      Sum& operator+=(const Sum& other) {
        lift += other.lift, potential += other.potential;
        return *this;
      }
    };
    const Sum sum = exact_sum_over_eights(particles.share().ranks(), slots, [&](std::size_t k) {
      const std::size_t slot = slots[k];
      const double z = particles.position.at(slot).z, height = particles.size_of(slot), t = (water.level - z) / height + 0.5;
      const double column = t <= 0 ? 0 : is_dry[slot] || t < 1 ? 0.5 * t * t : t - 0.5;
      const double net = lift * (is_dry[slot] ? std::max(t, 0.0) : std::clamp(t, 0.0, 1.0)) - weight;
      Vec3d force = particles.force_density.at(slot);
      force.z += net;
      particles.force_density.set(slot, force);
      return Sum{particles.volume(slot) * net, particles.volume(slot) * (weight * z + lift * height * column)};
    });
    return {sum.lift, sum.potential};
  }

  Vec3d resist(Particles& particles, double& work) {
    std::map<std::array<int, 2>, double> wetness, layers;
    const auto wet = [&](std::uint32_t slot) { return std::clamp((water.level - particles.position.at(slot).z) / particles.size_of(slot) + 0.5, 0.0, 1.0); };
    if (water.entrained_depth != 0)
      for (const std::uint32_t slot : slots)
        wetness[column(slot)] = std::max(wetness[column(slot)], wet(slot)),
        layers[column(slot)] += std::ranges::binary_search(in_contact, slot) || std::ranges::binary_search(held, slot) ? 0 : 1;
    struct Sum {
      Vec3d force;
      double work;
      Sum& operator+=(const Sum& other) {
        force += other.force, work += other.work;
        return *this;
      }
    };
    const Sum sum = exact_sum_over_eights(particles.share().ranks(), slots, [&](std::size_t k) {
      const std::uint32_t slot = slots[k];
      const bool is_exposed = exposure.is_exposed(slot) && water.drag != 0, adds_mass = water.added_mass != 0 || water.entrained_depth != 0;
      if (!is_exposed && water.damping == 0 && !adds_mass) return Sum{};
      const Vec3d velocity = particles.velocity.at(slot), before = particles.force_density.at(slot);
      const double height = particles.size_of(slot), density = particles.density();
      double alpha = water.damping;
      if (is_exposed && wet(slot) > 0)
        alpha += 0.5 * water.density * water.drag * height * height * wet(slot) * norm(velocity) / (density * particles.volume(slot));
      double mass = water.added_mass * water.density * wet(slot);
      if (water.entrained_depth != 0)
        mass = water.density * water.entrained_depth * wetness[column(slot)] * (1 - scene.body.family.damage(slot)) / (layers[column(slot)] * height);
      Vec3d after = before;
      for (std::size_t c = 0; c < 3; ++c) {
        if (c != 1 && std::ranges::binary_search(held, slot)) continue;
        after[c] = (before[c] - density * alpha * velocity[c]) / (1 + 0.5 * alpha * dt);
        if (c == 2 && adds_mass && !std::ranges::binary_search(in_contact, slot)) after[c] *= density / (density + mass);
      }
      particles.force_density.set(slot, after);
      const Vec3d force = particles.volume(slot) * (after - before);
      const Sum noted{force, 0.5 * dot(latest[slot] + force, dt * velocity)};
      latest[slot] = force;
      return noted;
    });
    work = sum.work;
    return sum.force;
  }
};

/// Water that acts in one way, and in all.
std::vector<std::pair<std::string, Water>> every_water(bool on_lattice) {
  const Water still{.level = 1e-4, .density = sea, .gravity = gravity, .drag = 0, .added_mass = 0, .damping = 0};
  std::vector<std::pair<std::string, Water>> all{{"still", still}};
  const auto add = [&](const char* name, const auto& change) { change(all.emplace_back(name, still).second); };
  add("drag", [](Water& water) { water.drag = 1.1; });
  add("damping", [](Water& water) { water.damping = 300; });
  add("added mass", [](Water& water) { water.added_mass = 0.7; });
  add("drag, damping and added mass", [](Water& water) { water.drag = 1.1, water.damping = 300, water.added_mass = 0.7; });
  if (!on_lattice) return all;
  add("entrained depth", [](Water& water) { water.entrained_depth = 3e-3; });
  add("dry top", [](Water& water) { water.level = 5.2e-3, water.dry_top = 1e-3; });
  add("all on columns", [](Water& water) { water.level = 5.2e-3, water.drag = 1.1, water.damping = 300, water.entrained_depth = 3e-3, water.dry_top = 1e-3; });
  return all;
}

}  // namespace

TEST_CASE("water kernels: forces, works and potential are bitwise those of a loop over particles, on lattices and clouds, of all particles and of some") {
  for (const fixtures::Points points : {fixtures::Points::lattice, fixtures::Points::shaken}) {
    const bool on_lattice = points == fixtures::Points::lattice;
    for (const auto& [name, water] : every_water(on_lattice))
      for (const bool all : {true, false}) {
        CAPTURE(on_lattice);
        CAPTURE(name);
        CAPTURE(all);
        Scene scene({.size = {0.021, 0.007, 0.010}, .points = points});
        const std::vector<std::uint32_t> slots = scene.slots(all);
        std::vector<std::uint32_t> held;
        for (const std::uint32_t slot : slots)
          if (slot % 3 == 0) held.push_back(slot);
        Floating floating(scene.body.particles, slots, water, 0);
        for (const std::size_t axis : {0, 2}) floating.leave_out(held, axis);
        Particles &particles = scene.body.particles, expected = scene.body.particles;
        PlainWater plain{scene, water, slots, held};
        double potential = 0, weight_work = 0, drag_work = 0, work = 0;
        std::size_t dry_tops = 0;
        std::vector<bool> was_dry(particles.slots(), true);
        std::mt19937_64 random(12);
        for (int instant = 0; instant < 3; ++instant) {
          if (instant > 0) {
            for (Particles* each : {&particles, &expected})
              for (const std::uint32_t slot : each->slot_of()) each->position.set(slot, each->position.at(slot) + dt * each->velocity.at(slot));
            for (std::size_t eight = static_cast<std::size_t>(instant); eight < scene.broken_ends.size(); eight += 9) scene.cut(eight, random);
            plain.exposure.update(scene.body.family, scene.broken_ends);
          }
          plain.in_contact.clear();
          for (const std::uint32_t slot : particles.slot_of())
            if (instant > 0 && (slot / 5) % 3 == static_cast<std::uint32_t>(instant) % 3) plain.in_contact.push_back(slot);
          floating.exclude_from_added_mass(plain.in_contact);
          floating.update_exposed_surface(particles, scene.body.family, scene.broken_ends);
          std::vector<bool> is_dry = plain.dry(expected);
          for (std::size_t slot = 0; slot < is_dry.size(); ++slot) {
            is_dry[slot] = is_dry[slot] && was_dry[slot];  // flooded for good
            dry_tops += is_dry[slot] ? 1 : 0;
          }
          was_dry = is_dry;
          floating.apply_hydrostatics(particles);
          floating.apply_resistance(particles, dt);
          const Hydrostatics lifted = plain.lift(expected, is_dry);
          const Vec3d resisted = plain.resist(expected, work);
          if (instant > 0) weight_work += potential - lifted.potential;
          potential = lifted.potential;
          drag_work += work;
          CHECK(bits_of(particles.force_density) == bits_of(expected.force_density));
          CHECK(floating.account.force() == Vec3d{0, 0, lifted.lift} + resisted);
          CHECK(floating.drag_work() == drag_work);
          if (water.dry_top == 0) CHECK(floating.weight_buoyancy_work() == weight_work);  // with one, less what the flood takes
        }
        CHECK((dry_tops > 0) == (water.dry_top != 0));
        CHECK((drag_work != 0) == (water.drag != 0 || water.damping != 0 || water.adds_mass()));
      }
  }
}

TEST_CASE("water kernels: the absorbing layer damps bitwise as a loop over particles, on lattices and clouds, and takes their energy") {
  for (const fixtures::Points points : {fixtures::Points::lattice, fixtures::Points::shaken}) {
    Scene scene({.size = {0.021, 0.007, 0.010}, .points = points});
    const std::vector<std::uint32_t> slots = scene.slots(false);
    std::vector<double> damping;
    for (const std::uint32_t slot : slots) damping.push_back(20.0 * (slot % 17));
    Absorbing layer(slots, damping);
    const std::vector<std::uint32_t> held{slots[3], slots[4], slots[40]};
    layer.leave_out(held, 1);
    Particles &particles = scene.body.particles, expected = scene.body.particles;
    std::vector<Vec3d> latest(slots.size());
    double work = 0;
    for (int instant = 0; instant < 2; ++instant) {
      layer.damp(particles, dt);
      Vec3d sum;
      for (std::size_t c = 0; c < 4; ++c) {
        const double of = exact_sum_over_eights(expected.share().ranks(), slots, [&](std::size_t k) {
          const std::size_t slot = slots[k];
          const Vec3d before = expected.force_density.at(slot), velocity = expected.velocity.at(slot);
          Vec3d force;
          for (std::size_t axis = 0; axis < 3; ++axis) {
            const double alpha = axis == 1 && std::ranges::binary_search(held, slots[k]) ? 0 : damping[k];
            const double after = (before[axis] - expected.density() * alpha * velocity[axis]) / (1 + 0.5 * alpha * dt);
            force[axis] = expected.volume(slot) * (after - before[axis]);
            if (c == 3) expected.force_density.component(axis)[slot] = after;
          }
          if (c < 3) return force[c];
          const double one = 0.5 * dot(latest[k] + force, dt * velocity);
          latest[k] = force;
          return one;
        });
        (c < 3 ? sum[c] : work) = c < 3 ? of : work + of;
      }
      CHECK(bits_of(particles.force_density) == bits_of(expected.force_density));
      CHECK(layer.account.force() == sum);
      CHECK(layer.account.work() == work);
    }
    CHECK(work < 0);
  }
}
