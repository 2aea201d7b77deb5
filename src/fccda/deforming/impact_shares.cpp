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

/// One impact, prepared for the sweeps.
struct Row {
  std::array<std::size_t, 3> places;
  double along;     // [m/s] d
  double diagonal;  // 1 + m W
};

}  // namespace

std::vector<double> impact_shares(std::span<const PanelImpact> impacts) {
  Vertices vertices(impacts);
  std::vector<Row> rows;
  double largest = 0;
  for (const PanelImpact& impact : impacts) {
    double yield = 0;
    for (std::size_t k = 0; k < 3; ++k) yield += impact.weights[k] * impact.weights[k] * impact.inverse_masses[k];
    rows.push_back({vertices.places_of(impact), dot(impact.change, impact.normal), 1 + impact.mass * yield});
    largest = std::max(largest, norm(impact.change));
  }
  std::vector<double> shares(impacts.size(), 0.0);
  const auto add = [&](std::size_t c, double share) {
    shares[c] += share;
    for (std::size_t k = 0; k < 3; ++k)
      vertices.velocity(rows[c].places[k]) -= (impacts[c].weights[k] * impacts[c].mass * share * impacts[c].inverse_masses[k]) * impacts[c].change;
  };
  // A point that is relocated without a push is by itself: what others do to the panel does not concern it.
  for (std::size_t c = 0; c < impacts.size(); ++c)
    if (!(rows[c].along > 0)) add(c, 1 / rows[c].diagonal);
  for (int sweep = 0; sweep < max_sweeps; ++sweep) {
    double change = 0;
    for (std::size_t c = 0; c < impacts.size(); ++c) {
      const Row& row = rows[c];
      if (!(row.along > 0)) continue;
      Vec3d panel{};
      for (std::size_t k = 0; k < 3; ++k) panel += impacts[c].weights[k] * vertices.velocity(row.places[k]);
      const double missing = (row.along * (1 - shares[c]) + dot(panel, impacts[c].normal)) / (row.along * row.diagonal);
      const double share = std::max(missing, -shares[c]);
      add(c, share);
      change = std::max(change, std::fabs(share) * norm(impacts[c].change));
    }
    if (change <= tolerance * largest) break;
  }
  return shares;
}

}  // namespace fccda
