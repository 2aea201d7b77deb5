#include "perimpact/body/sample.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace perimpact {

Sample::Sample(const Body& body, const Vec3d& point) : at(point) {
  const Particles& particles = body.particles;
  double nearest = std::numeric_limits<double>::infinity();
  for (const std::uint32_t slot : particles.slot_of()) nearest = std::min(nearest, norm(particles.reference(slot) - point));
  const double limit = nearest + 1e-6 * particles.spacing();
  for (const std::uint32_t slot : particles.slot_of())
    if (slots.size() < 8 && norm(particles.reference(slot) - point) <= limit) slots.push_back(slot);
}

double Sample::distance(const Body& body) const { return norm(body.particles.reference(slots.front()) - at); }

Vec3d Sample::displacement(const Body& body) const {
  Vec3d sum{};
  for (const std::uint32_t slot : slots) sum += body.particles.displacement(slot);
  return sum / static_cast<double>(slots.size());
}

std::vector<Sample> samples_along(const Body& body, const Vec3d& from, const Vec3d& to) {
  const int segments = std::max(1, static_cast<int>(std::lround(norm(to - from) / body.particles.spacing())));
  std::vector<Sample> samples;
  for (int segment = 0; segment < segments; ++segment) samples.emplace_back(body, from + ((segment + 0.5) / segments) * (to - from));
  return samples;
}

}  // namespace perimpact
