#include "perimpact/simulation/short_range_of.hpp"

#include <fmt/format.h>

#include "perimpact/deck_model/setup_error.hpp"

namespace perimpact {

namespace {

ShortRangeLaw law_of(const FragmentContactSetup& setup) {
  return {.stiffness_factor = setup.stiffness_factor,
          .distance_ratio = setup.distance_ratio,
          .friction = setup.friction,
          .damping_ratio = damping_ratio_of(setup.restitution)};
}

/// Contact acts along the line between particles, which must stay in the plane of a plane body.
void expect_one_plane(std::span<const Body> bodies) {
  constexpr const char* key = "contact.fragments.law";
  const auto height = [](const Body& body) { return body.particles.reference(0).z; };
  for (const Body& body : bodies) {
    const Body& first = bodies.front();
    if (body.particles.is_plane() != first.particles.is_plane())
      throw SetupError(key, fmt::format("body {} is plane and body {} is not, but contact is supported between bodies of the same dimension only; set law: "
                                        "none, or give both the same plane.",
                                        body.particles.is_plane() ? body.name : first.name, body.particles.is_plane() ? first.name : body.name));
    if (body.particles.is_plane() && height(body) != height(first))
      throw SetupError(
          key,
          fmt::format(
              "the plane bodies {} and {} lie at z = {} m and {} m, but contact is supported within one plane only; give them the same z, or set law: none.",
              first.name, body.name, height(first), height(body)));
  }
}

}  // namespace

std::vector<ContactingBody> contacting_bodies(const Setup& setup, std::span<Body> bodies) {
  const ShortRangeLaw law = law_of(setup.contact.fragments);
  std::vector<ContactingBody> all;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    Body& body = bodies[b];
    const double thickness = body.particles.thickness().value_or(1);
    ContactingBody contacting{body.particles, body.family, body.internal.broken_ends(),
                              law.stiffness(elastic_of(setup.bodies[b]), body.family.horizon(), thickness)};
    if (const PlasticForce* plastic = body.internal.plastic()) contacting.largest_pressure = plastic->plasticity().ellipse.largest_pressure();
    all.push_back(contacting);
  }
  return all;
}

std::optional<ShortRange> short_range_of(const Setup& setup, std::span<Body> bodies) {
  if (setup.contact.fragments.law.as<FragmentLaw>() == FragmentLaw::none) return {};
  expect_one_plane(bodies);
  return ShortRange(law_of(setup.contact.fragments), contacting_bodies(setup, bodies));
}

std::string warning_of_overlap(const ShortRange& fragments) {
  return fmt::format(
      "{} pairs of particles are initially closer than their contact distance, and {:.3g} J of their springs will push them apart. Increase the distance of "
      "the bodies, or use a smaller contact.fragments.distance_ratio.",
      fragments.contacts(), fragments.energy());
}

}  // namespace perimpact
