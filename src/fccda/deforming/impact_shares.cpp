#include "fccda/deforming/impact_shares.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace fccda {

namespace {

constexpr int max_sweeps = 200;
constexpr double tolerance = 1e-6;  // of the largest change of a velocity

/// Velocities of the vertices that any impact acts on, in the order of their numbers.
class Vertices {
 public:
  explicit Vertices(std::span<const PanelImpact> impacts) {
    for (const PanelImpact& impact : impacts) numbers_.insert(numbers_.end(), impact.vertices.begin(), impact.vertices.end());
    std::sort(numbers_.begin(), numbers_.end());
    numbers_.erase(std::unique(numbers_.begin(), numbers_.end()), numbers_.end());
    velocity_.resize(numbers_.size());
  }

  std::array<std::size_t, 3> places_of(const PanelImpact& impact) const {
    std::array<std::size_t, 3> places;
    for (std::size_t k = 0; k < 3; ++k)
      places[k] = static_cast<std::size_t>(std::lower_bound(numbers_.begin(), numbers_.end(), impact.vertices[k]) - numbers_.begin());
    return places;
  }

  Vec3d& velocity(std::size_t place) { return velocity_[place]; }

 private:
  std::vector<int> numbers_;
  std::vector<Vec3d> velocity_;
};

/// One direction of an impact, prepared for the sweeps.
struct Row {
  const PanelImpact* impact;
  const PanelImpact::Part* part;
  std::array<std::size_t, 3> places;
  double diagonal = 1;  // 1 + m W
  double share = 0;

  Row(const PanelImpact& of, const PanelImpact::Part& direction, const std::array<std::size_t, 3>& at) : impact(&of), part(&direction), places(at) {
    for (std::size_t k = 0; k < 3; ++k) diagonal += of.mass * of.inverse_masses[k] * squared_norm(direction.vertex_impulses[k]);
  }

  /// Changes the share; returns by how much that changes the velocity of the point [m/s].
  double set(double value, Vertices& vertices) {
    const double change = (value - share) * part->change;
    share = value;
    for (std::size_t k = 0; k < 3; ++k) vertices.velocity(places[k]) -= (impact->mass * change * impact->inverse_masses[k]) * part->vertex_impulses[k];
    return std::fabs(change);
  }

  /// The share with which point and panel part as at an unyielding panel.
  double wanted(Vertices& vertices) const {
    double panel = 0;  // [m/s] along the direction
    for (std::size_t k = 0; k < 3; ++k) panel += dot(part->vertex_impulses[k], vertices.velocity(places[k]));
    return share + (part->change * (1 - share) + panel) / (part->change * diagonal);
  }
};

}  // namespace

std::vector<ImpactShare> impact_shares(std::span<const PanelImpact> impacts) {
  Vertices vertices(impacts);
  std::vector<Row> push, friction;
  double largest = 0;
  for (const PanelImpact& impact : impacts) {
    const std::array<std::size_t, 3> places = vertices.places_of(impact);
    push.emplace_back(impact, impact.push, places);
    friction.emplace_back(impact, impact.friction, places);
    largest = std::max({largest, impact.push.change, impact.friction.change});
  }
  // A point that is relocated without a push is by itself: what others do to the panel does not concern it.
  for (std::size_t c = 0; c < impacts.size(); ++c)
    if (!impacts[c].is_pushed)
      for (Row* row : {&push[c], &friction[c]}) row->set(1 / row->diagonal, vertices);
  for (int sweep = 0; sweep < max_sweeps; ++sweep) {
    double change = 0;
    for (std::size_t c = 0; c < impacts.size(); ++c) {
      if (!impacts[c].is_pushed) continue;
      change = std::max(change, push[c].set(std::max(push[c].wanted(vertices), 0.0), vertices));
      if (impacts[c].friction.change > 0) change = std::max(change, friction[c].set(std::clamp(friction[c].wanted(vertices), 0.0, push[c].share), vertices));
    }
    if (change <= tolerance * largest) break;
  }
  std::vector<ImpactShare> shares;
  for (std::size_t c = 0; c < impacts.size(); ++c) shares.push_back({push[c].share, friction[c].share});
  return shares;
}

}  // namespace fccda
