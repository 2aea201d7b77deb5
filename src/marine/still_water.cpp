#include "marine/still_water.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "base/error.hpp"
#include "base/finite.hpp"
#include "mesh/submerged.hpp"

namespace fccda {

namespace {

void expect_usable(const StillWater& water, const Surface& surface) {
  expect_finite(water.level, "still water: the level");
  const auto expect = [](double value, const std::string& what) {
    if (!(value >= 0 && std::isfinite(value)))
      throw InputError("still water: the " + what + " is " + in_words(value) + ", but it must be a finite number of at least 0.");
  };
  expect(water.density, "density"), expect(water.gravity, "gravity"), expect(water.damping, "damping");
  if (!surface.is_closed()) throw InputError("still water: the surface of the body is open, so it displaces no volume; close its holes.");
}

SubmergedVolume under(double level, const RigidBody& body, const Surface& surface) {
  const Pose& pose = body.pose();
  return submerged(surface, {.up = pose.turn_to_body({0, 0, 1}), .height = level - pose.position().z});
}

struct Heights {
  double low = std::numeric_limits<double>::infinity(), high = -std::numeric_limits<double>::infinity();  // [m]
};

Heights heights(const RigidBody& body, const Surface& surface) {
  const Vec3d up = body.pose().turn_to_body({0, 0, 1});
  Heights found;
  for (const Vec3d& vertex : surface.vertices()) found.low = std::min(found.low, dot(up, vertex)), found.high = std::max(found.high, dot(up, vertex));
  const double z = body.pose().position().z;
  return {z + found.low, z + found.high};
}

}  // namespace

Hydrostatics hydrostatics(const RigidBody& body, const Surface& surface, const StillWater& water) {
  expect_usable(water, surface);
  const SubmergedVolume wet = under(water.level, body, surface);
  const Vec3d centre = body.pose().to_world(wet.centre), com = body.position_of_com();
  const double buoyancy = water.density * water.gravity * wet.volume, weight = body.mass() * water.gravity;
  return {.volume = wet.volume,
          .centre = centre,
          .waterplane = wet.waterplane,
          .force = buoyancy - weight,
          .moment = cross(centre - com, Vec3d{0, 0, buoyancy}),
          .potential = weight * (com.z - water.level) + (wet.volume > 0 ? buoyancy * (water.level - centre.z) : 0)};
}

WaterSum apply(const StillWater& water, const Surface& surface, RigidBody& body, const Step& step) {
  const Hydrostatics now = hydrostatics(body, surface, water);
  const Vec3d velocity = body.velocity(), spin = body.angular_velocity();
  double impulse = step.dt * now.force;
  Vec3d angular_impulse = step.dt * now.moment;
  if (water.damping > 0 && now.volume > 0) {
    const double share = -std::expm1(-water.damping * step.dt);
    impulse -= share * (body.mass() + body.properties().added_mass.z) * velocity.z;
    angular_impulse -= share * (body.inertia() * Vec3d{spin.x, spin.y, 0});
  }
  body.add_impulse({0, 0, impulse}, angular_impulse);
  const double work = 0.5 * ((velocity.z + body.velocity().z) * impulse + dot(spin + body.angular_velocity(), angular_impulse));
  return {impulse, angular_impulse, work};
}

std::optional<double> level_at_rest(const RigidBody& body, const Surface& surface, const StillWater& water) {
  expect_usable(water, surface);
  const double wanted = body.mass() / water.density;  // [m³]
  if (wanted > surface.report().volume) return std::nullopt;
  auto [low, high] = heights(body, surface);
  double level = 0.5 * (low + high);
  // Newton's method inside a shrinking bracket: the volume is monotonic in the level
  constexpr int enough = 200;
  for (int step = 0; step < enough && high - low > 1e-15 * (std::fabs(high) + std::fabs(low)); ++step) {
    const SubmergedVolume wet = under(level, body, surface);
    const double missing = wanted - wet.volume;
    if (missing == 0) break;
    (missing > 0 ? low : high) = level;
    const double next = wet.waterplane > 0 ? level + missing / wet.waterplane : low;
    const double before = level;
    level = next > low && next < high ? next : 0.5 * (low + high);
    if (level == before) break;
  }
  return level;
}

double keel(const RigidBody& body, const Surface& surface) { return heights(body, surface).low; }

}  // namespace fccda
