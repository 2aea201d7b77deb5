#include "perimpact/family/bond_list.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/parallel.hpp"

namespace perimpact {

namespace {

/// Cell list: particles sorted into cubes, so that all within one edge length lie in adjacent cubes.
class Cells {
 public:
  Cells(const Particles& particles, double edge) : edge_(edge) {
    constexpr double far = std::numeric_limits<double>::infinity();
    Vec3d high{-far, -far, -far};
    low_ = -1.0 * high;
    for (const std::uint32_t slot : particles.slot_of()) {
      const Vec3d X = particles.reference(slot);
      for (std::size_t c = 0; c < 3; ++c) low_[c] = std::min(low_[c], X[c]), high[c] = std::max(high[c], X[c]);
    }
    // bounds the number of cells for widely scattered particles
    double cells = 0;
    do {
      cells = 1;
      for (std::size_t c = 0; c < 3; ++c) cells *= std::floor((high[c] - low_[c]) / edge_) + 1;
      if (cells > 8.0 * static_cast<double>(particles.size()) + 64)
        edge_ *= 1.5;
      else
        break;
    } while (true);
    for (std::size_t c = 0; c < 3; ++c) count_[c] = static_cast<std::ptrdiff_t>((high[c] - low_[c]) / edge_) + 1;
    first_.assign(static_cast<std::size_t>(count_[0] * count_[1] * count_[2]) + 1, 0);
    for (const std::uint32_t slot : particles.slot_of()) ++first_[index(cell(particles.reference(slot))) + 1];
    for (std::size_t c = 1; c < first_.size(); ++c) first_[c] += first_[c - 1];
    sorted_.resize(particles.size());
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for (const std::uint32_t slot : particles.slot_of()) {
      const Vec3d X = particles.reference(slot);
      sorted_[next[index(cell(X))]++] = {X, particles.size_of(slot), slot};
    }
  }

  /// Particle data for the bond search. The size needs a cube root and is computed once per particle, not per pair.
  struct Sorted {
    Vec3d reference;  // [m]
    double size;      // [m]
    std::uint32_t slot;
  };

  /// Calls visit(sorted) for all particles in the 27 cells around the point.
  template <class Visit>
  void around(const Vec3d& point, const Visit& visit) const {
    const auto [i, j, k] = cell(point);
    for (std::ptrdiff_t z = std::max<std::ptrdiff_t>(k - 1, 0); z <= std::min(k + 1, count_[2] - 1); ++z)
      for (std::ptrdiff_t y = std::max<std::ptrdiff_t>(j - 1, 0); y <= std::min(j + 1, count_[1] - 1); ++y)
        for (std::ptrdiff_t x = std::max<std::ptrdiff_t>(i - 1, 0); x <= std::min(i + 1, count_[0] - 1); ++x) {
          const std::size_t here = index({x, y, z});
          for (std::size_t n = first_[here]; n < first_[here + 1]; ++n) visit(sorted_[n]);
        }
  }

 private:
  using Cell = std::array<std::ptrdiff_t, 3>;
  Cell cell(const Vec3d& point) const {
    Cell at;
    for (std::size_t c = 0; c < 3; ++c) at[c] = std::clamp<std::ptrdiff_t>(static_cast<std::ptrdiff_t>((point[c] - low_[c]) / edge_), 0, count_[c] - 1);
    return at;
  }
  std::size_t index(const Cell& at) const { return static_cast<std::size_t>((at[2] * count_[1] + at[1]) * count_[0] + at[0]); }

  double edge_;
  Vec3d low_{};
  Cell count_{};
  std::vector<std::size_t> first_;
  std::vector<Sorted> sorted_;
};

struct Neighbour {
  std::uint32_t slot;
  double length, volume;
};

/// The bonds of one particle, sorted by slot.
void neighbours_of(std::size_t slot, const Particles& particles, const Cells& cells, FamilyRule rule, double horizon, std::vector<Neighbour>& found) {
  found.clear();
  const Vec3d X = particles.reference(slot);
  const double size = particles.size_of(slot);
  cells.around(X, [&](const Cells::Sorted& other) {
    if (other.slot == slot) return;
    const double length = norm(other.reference - X), mean = 0.5 * (size + other.size);
    const bool bonded = rule == FamilyRule::hu_ha_bobaru ? length < horizon + 0.5 * mean : length <= horizon;
    if (!bonded) return;
    found.push_back({other.slot, length, std::min(1.0, (horizon + 0.5 * mean - length) / mean) * particles.volume(other.slot)});
  });
  std::sort(found.begin(), found.end(), [](const Neighbour& a, const Neighbour& b) { return a.slot < b.slot; });
}

}  // namespace

BondList find_bonds(FamilyRule rule, double horizon, const Particles& particles) {
  double largest = 0;
  for (const std::uint32_t slot : particles.slot_of()) largest = std::max(largest, particles.size_of(slot));
  const Cells cells(particles, horizon + 0.5 * largest);

  BondList list{.horizon = horizon};
  const std::size_t eights = particles.slots() / fccda::byte_lanes;
  const auto for_each_eight = [&](const auto& f) {
    fccda::parallel_for(static_cast<std::ptrdiff_t>(eights), [&](std::ptrdiff_t eight) {
      std::vector<Neighbour> found;
      for (std::size_t lane = 0; lane < fccda::byte_lanes; ++lane) {
        const std::size_t slot = static_cast<std::size_t>(eight) * fccda::byte_lanes + lane;
        if (!particles.is_occupied(slot)) continue;
        neighbours_of(slot, particles, cells, rule, horizon, found);
        f(static_cast<std::size_t>(eight), lane, found);
      }
    });
  };

  list.begin.assign(eights + 1, 0);
  for_each_eight(
      [&](std::size_t eight, std::size_t, const std::vector<Neighbour>& found) { list.begin[eight + 1] = std::max(list.begin[eight + 1], found.size()); });
  for (std::size_t eight = 0; eight < eights; ++eight) list.begin[eight + 1] += list.begin[eight];

  const std::size_t rows = list.begin.back(), entries = rows * fccda::byte_lanes;
  list.bits.assign(rows, 0);
  list.neighbour.resize(entries);
  list.length.assign(entries, 1.0);
  list.volume.assign(entries, 0.0);
  for (std::size_t eight = 0; eight < eights; ++eight)
    for (std::size_t entry = list.begin[eight] * fccda::byte_lanes; entry < list.begin[eight + 1] * fccda::byte_lanes; ++entry)
      list.neighbour[entry] = static_cast<std::int32_t>(eight * fccda::byte_lanes + entry % fccda::byte_lanes);
  for_each_eight([&](std::size_t eight, std::size_t lane, const std::vector<Neighbour>& found) {
    for (std::size_t r = 0; r < found.size(); ++r) {
      const std::size_t row = list.begin[eight] + r, entry = row * fccda::byte_lanes + lane;
      list.bits[row] = static_cast<std::uint8_t>(list.bits[row] | (1u << lane));
      list.neighbour[entry] = static_cast<std::int32_t>(found[r].slot);
      list.length[entry] = found[r].length;
      list.volume[entry] = found[r].volume;
    }
  });
  return list;
}

}  // namespace perimpact
