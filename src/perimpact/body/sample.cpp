#include "perimpact/body/sample.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "perimpact/particles/cell_box.hpp"

namespace perimpact {

namespace {

/// Distances from a point to the particles of this rank. On a lattice only cells around the point are searched.
class Distances {
 public:
  Distances(const Particles& particles, const Vec3d& point) : particles_(particles), point_(point) {
    const Lattice* const lattice = particles.lattice();
    for (int reach = 2;; reach *= 2) {
      if (lattice) cells_ = around(*lattice, reach);
      for_each([&](std::size_t, double distance) { nearest_ = std::min(nearest_, distance); });
      // beyond these cells every particle is farther away than reach + 1/2 spacings
      if (!lattice || *cells_ == CellBox{{0, 0, 0}, lattice->cells} || nearest_ <= reach * lattice->spacing) return;
    }
  }

  double nearest() const { return nearest_; }  ///< [m]; infinite without particles

  /// Calls visit(slot, distance), slots ascending, for the nearest particle and all that are at most half a spacing farther away, and some others.
  template <class Visit>
  void for_each(const Visit& visit) const {
    const auto with_distance = [&](std::size_t slot) { visit(slot, norm(particles_.reference(slot) - point_)); };
    if (!cells_) {
      for (const std::uint32_t slot : particles_.slot_of()) with_distance(slot);
      return;
    }
    const Lattice& lattice = *particles_.lattice();
    for (int k = cells_->low[2]; k < cells_->high[2]; ++k)
      for (int j = cells_->low[1]; j < cells_->high[1]; ++j)
        for (int i = cells_->low[0]; i < cells_->high[0]; ++i)
          if (const std::size_t slot = lattice.slot(i, j, k); particles_.owns(slot)) with_distance(slot);
  }

 private:
  /// Cells at most `reach` cells from that of the point along each axis, within the lattice.
  CellBox around(const Lattice& lattice, int reach) const {
    CellBox box;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double cell = std::round((point_[axis] - lattice.origin[axis]) / lattice.spacing) - lattice.first[axis];
      box.low[axis] = static_cast<int>(std::clamp(cell - reach, 0.0, static_cast<double>(lattice.cells[axis])));
      box.high[axis] = static_cast<int>(std::clamp(cell + reach + 1, 0.0, static_cast<double>(lattice.cells[axis])));
    }
    return box;
  }

  const Particles& particles_;
  Vec3d point_;
  std::optional<CellBox> cells_;
  double nearest_ = std::numeric_limits<double>::infinity();
};

}  // namespace

Sample::Sample(const Body& body, const Vec3d& point) : at(point) {
  const Particles& particles = body.particles;
  const Distances distances(particles, point);
  Ranks& ranks = particles.share().ranks();
  const double limit = ranks.min(distances.nearest()) + 1e-6 * particles.spacing();
  std::vector<Near> own;
  distances.for_each([&](std::size_t slot, double distance) {
    if (own.size() < most && distance <= limit) own.push_back({particles.share().whole_slot(slot), slot, ranks.rank(), distance});
  });
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

std::vector<std::uint32_t> Sample::slots() const {
  std::vector<std::uint32_t> slots;
  for (const Near& near : near_) slots.push_back(static_cast<std::uint32_t>(near.slot));
  return slots;
}

std::vector<Sample> samples_along(const Body& body, const Vec3d& from, const Vec3d& to) {
  const int segments = std::max(1, static_cast<int>(std::lround(norm(to - from) / body.particles.spacing())));
  std::vector<Sample> samples;
  for (int segment = 0; segment < segments; ++segment) samples.emplace_back(body, from + ((segment + 0.5) / segments) * (to - from));
  return samples;
}

}  // namespace perimpact
