#include "perimpact/impactor/rigid_body_of.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "fccda/rigid_body/solid.hpp"
#include "perimpact/deck_model/setup_error.hpp"

namespace perimpact {

using namespace fccda;

namespace {

std::string key_of(const ImpactorSetup& setup) { return "impactors." + setup.name; }

double mass_of(const ImpactorSetup& setup, const Surface& surface) {
  if (setup.mass.has_value() == setup.density.has_value())
    throw SetupError(key_of(setup), fmt::format("impactor {} needs either a mass or a density.", setup.name));
  if (setup.mass) return *setup.mass;
  if (!surface.is_closed())
    throw SetupError(
        key_of(setup) + ".density",
        fmt::format("the surface of {} is open, so that a density defines no mass; give the mass, and the inertia if a rotation is free, or close the surface.",
                    setup.name));
  return *setup.density * surface.report().volume;
}

/// [kg] Added mass in heave: a share of the water displaced at rest, or of the enclosed volume if it sinks.
double added_mass_of(const ImpactorSetup& setup, const Surface& surface, double mass) {
  if (!surface.is_closed())
    throw SetupError(key_of(setup) + ".floating", fmt::format("the surface of {} is open, so that its displacement is undefined; close the surface (`perimpact "
                                                              "mesh` shows where it is open), or remove floating and give the force as a load.",
                                                              setup.name));
  return setup.floating->added_mass * std::min(mass, setup.floating->density * surface.report().volume);
}

/// Σ m (y² + z²) and so on: no moment of inertia exceeds the sum of the other two.
void refuse_impossible_inertia(const ImpactorSetup& setup) {
  const Vec3d& inertia = *setup.inertia;
  constexpr double rounding = 1e-3;  // of numbers in a deck
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double others = inertia[(axis + 1) % 3] + inertia[(axis + 2) % 3];
    if (inertia[axis] <= (1 + rounding) * others) continue;
    throw SetupError(key_of(setup) + ".inertia",
                     fmt::format("the moment of inertia of {} about {} is {:.4g} kg m2, but no body has one above the sum of the other two, here {:.4g} kg m2; "
                                 "correct the numbers or their units.",
                                 setup.name, "xyz"[axis], inertia[axis], others));
  }
}

RigidBodyProperties properties_of(const ImpactorSetup& setup, const Surface& surface) {
  const double mass = mass_of(setup, surface);
  RigidBodyProperties properties =
      surface.is_closed() ? solid_of_mass(surface.report(), mass) : RigidBodyProperties{.mass = mass, .centre_of_mass = surface.report().centroid};
  if (setup.centre_of_mass) properties.centre_of_mass = *setup.centre_of_mass;
  if (setup.inertia) refuse_impossible_inertia(setup), properties.inertia = Mat3::diagonal(*setup.inertia);
  if (setup.floating) properties.added_mass.z = added_mass_of(setup, surface, mass);
  return properties;
}

FreeDegrees degrees_of(const ImpactorSetup& setup) {
  FreeDegrees degrees;
  for (const std::string& word : setup.free_dofs)
    for (std::size_t d = 0; d < std::size(degree_words); ++d)
      if (word == degree_words[d]) degrees.free[d] = true;
  return degrees;
}

/// Calls make() and attaches the key to its errors.
template <class Make>
auto placed(const std::string& key, const Make& make) {
  try {
    return make();
  } catch (const InputError& error) {
    throw SetupError(key, error.what());
  }
}

}  // namespace

RigidBody rigid_body_of(const ImpactorSetup& setup, const Surface& surface, const PrescribedMotion& motion) {
  const RigidBodyProperties properties = properties_of(setup, surface);
  Vec3d velocity = setup.velocity, spin = setup.angular_velocity;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    velocity[axis] = motion.velocity_at(axis, 0, velocity[axis]);
    spin[axis] = motion.velocity_at(3 + axis, 0, spin[axis]);
  }
  if (const FreeDegrees degrees = degrees_of(setup); degrees.any_rotation() && !setup.inertia && !surface.is_closed())
    throw SetupError(
        key_of(setup) + ".free_dofs",
        fmt::format(
            "a rotation of {} is free, but its surface is open and defines no inertia; give the inertia, close the surface, or constrain the rotations.",
            setup.name));
  try {
    return RigidBody(properties, Pose(setup.position), velocity, spin, degrees_of(setup));
  } catch (const InputError& error) {
    throw SetupError(key_of(setup), fmt::format("impactor {}: {}", setup.name, error.what()));
  }
}

PrescribedMotion motion_of(const ImpactorSetup& setup) {
  PrescribedMotion motion;
  for (std::size_t degree = 0; degree < std::size(degree_words); ++degree) {
    const MotionTable* table = setup.motion.of(degree);
    if (!table) continue;
    const std::string key = fmt::format("{}.motion.{}", key_of(setup), degree_words[degree]);
    if (std::find(setup.free_dofs.begin(), setup.free_dofs.end(), degree_words[degree]) != setup.free_dofs.end())
      throw SetupError(key, fmt::format("{} of {} is free, so that its motion cannot be prescribed; remove it from free_dofs, or remove its motion.",
                                        degree_words[degree], setup.name));
    const bool is_velocity = table->displacements.empty();
    motion.prescribe(degree, is_velocity ? PrescribedMotion::Of::velocity : PrescribedMotion::Of::displacement,
                     placed(key, [&] { return PiecewiseLinear(table->times, is_velocity ? table->velocities : table->displacements); }));
  }
  return motion;
}

std::vector<AppliedLoad> loads_of(const ImpactorSetup& setup) {
  std::vector<AppliedLoad> loads;
  for (const LoadSetup& load : setup.loads) {
    AppliedLoad& made = loads.emplace_back(AppliedLoad{.force = load.force, .moment = load.moment, .point = load.point});
    const auto table = [&](const std::vector<double>& arguments, const std::vector<double>& factors) {
      if (arguments.empty() && factors.empty()) return PiecewiseLinear(1);
      return placed(fmt::format("{}.loads.{}", key_of(setup), load.name), [&] { return PiecewiseLinear(arguments, factors); });
    };
    made.factor = table(load.times, load.factors);
    made.speed_factor = table(load.speeds, load.speed_factors);
  }
  return loads;
}

std::optional<StillWater> water_of(const ImpactorSetup& setup) {
  if (!setup.floating) return std::nullopt;
  const FloatingImpactorSetup& floating = *setup.floating;
  return StillWater{.level = floating.level, .density = floating.density, .gravity = floating.gravity, .damping = floating.damping};
}

bool is_weighed_by_volume(const ImpactorSetup& setup) {
  const bool may_turn = std::any_of(setup.free_dofs.begin(), setup.free_dofs.end(), [](const std::string& degree) { return degree.starts_with('r'); });
  return setup.density.has_value() || !setup.centre_of_mass || (may_turn && !setup.inertia);
}

}  // namespace perimpact
