#include "perimpact/body/sample.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace perimpact {

Sample::Sample(const Body& body, const Vec3d& point) : at(point) {
  const Particles& particles = body.particles;
  double nearest = std::numeric_limits<double>::infinity();
  for (const std::uint32_t slot : particles.slot_of()) nearest = std::min(nearest, norm(particles.reference(slot) - point));
  Ranks& ranks = particles.share().ranks();
  nearest = ranks.min(nearest);
  const double limit = nearest + 1e-6 * particles.spacing();
  std::vector<Near> own;
  for (const std::uint32_t slot : particles.slot_of())
    if (const double distance = norm(particles.reference(slot) - point); own.size() < most && distance <= limit)
      own.push_back({particles.share().whole_slot(slot), slot, ranks.rank(), distance});
  near_ = ranks.join_all(std::span<const Near>(own));
  std::ranges::sort(near_, {}, &Near::whole_slot);
  near_.resize(std::min(near_.size(), most));
}

Vec3d Sample::displacement(const Body& body) const {
  Ranks& ranks = body.particles.share().ranks();
  std::vector<double> all(3 * near_.size());  // each is that of one rank: sums with zeros are exact
  for (std::size_t k = 0; k < near_.size(); ++k) {
    const Vec3d u = near_[k].rank == ranks.rank() ? body.particles.displacement(near_[k].slot) : Vec3d{};
    for (std::size_t c = 0; c < 3; ++c) all[3 * k + c] = u[c];
  }
  const std::vector<double> of_ranks = ranks.join_all(std::span<const double>(all));
  Vec3d sum{};
  for (std::size_t k = 0; k < near_.size(); ++k) {
    const double* u = of_ranks.data() + static_cast<std::size_t>(near_[k].rank) * all.size() + 3 * k;
    sum += Vec3d{u[0], u[1], u[2]};
  }
  return sum / static_cast<double>(near_.size());
}

std::vector<Sample> samples_along(const Body& body, const Vec3d& from, const Vec3d& to) {
  const int segments = std::max(1, static_cast<int>(std::lround(norm(to - from) / body.particles.spacing())));
  std::vector<Sample> samples;
  for (int segment = 0; segment < segments; ++segment) samples.emplace_back(body, from + ((segment + 0.5) / segments) * (to - from));
  return samples;
}

}  // namespace perimpact
