/// Projection of a point onto the intersection of a few half-spaces (a convex polyhedron).
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

#include "base/contract.hpp"
#include "base/vec3.hpp"

namespace fccda {

/// Up to `most` half-spaces normal·x >= least.
template <std::size_t most>
class HalfSpaces {
 public:
  /// `normal`: unit.
  void add(const Vec3d& normal, double least) {
    EXPECTS(count_ < half_spaces_.size());
    half_spaces_[count_++] = {normal, least};
  }

  /// The point nearest to `wanted` that is in all of them, within `slack` [m]. In three dimensions it lies on at most three of the planes, so
  /// all combinations of one, two and three are tried. Nothing if the intersection is empty.
  std::optional<Vec3d> nearest(const Vec3d& wanted, double slack) const {
    Search search{*this, wanted, slack, {}, std::numeric_limits<double>::infinity()};
    search.consider(wanted);
    for (std::size_t i = 0; i < count_ && !search.best; ++i)
      if (missing(i, wanted) > 0) search.consider(wanted + missing(i, wanted) * half_spaces_[i].normal);
    if (search.best) return search.best;
    for (std::size_t i = 0; i < count_; ++i)
      for (std::size_t j = 0; j < i; ++j) search.consider_line(i, j);
    if (search.best) return search.best;
    for (std::size_t i = 0; i < count_; ++i)
      for (std::size_t j = 0; j < i; ++j)
        for (std::size_t k = 0; k < j; ++k) search.consider_corner(i, j, k);
    return search.best;
  }

 private:
  struct HalfSpace {
    Vec3d normal;
    double least;  // [m]
  };

  struct Search {
    const HalfSpaces& all;
    Vec3d wanted;
    double slack;
    std::optional<Vec3d> best;
    double least;

    void consider(const Vec3d& place) {
      const double square = squared_norm(place - wanted);
      if (!(square < least)) return;
      for (std::size_t i = 0; i < all.count_; ++i)
        if (!(all.missing(i, place) <= slack)) return;
      best = place, least = square;
    }
    void consider_line(std::size_t i, std::size_t j) {
      const Vec3d &a = all.half_spaces_[i].normal, &b = all.half_spaces_[j].normal;
      const double both = dot(a, b), square = squared_norm(cross(a, b));  // 1 - both², without cancellation
      if (!(square > parallel)) return;
      const double p = all.missing(i, wanted), q = all.missing(j, wanted);
      consider(wanted + ((p - both * q) / square) * a + ((q - both * p) / square) * b);
    }
    void consider_corner(std::size_t i, std::size_t j, std::size_t k) {
      const Vec3d &a = all.half_spaces_[i].normal, &b = all.half_spaces_[j].normal, &c = all.half_spaces_[k].normal;
      const double volume = dot(a, cross(b, c));
      if (!(volume * volume > parallel)) return;
      const double p = all.missing(i, wanted), q = all.missing(j, wanted), r = all.missing(k, wanted);
      consider(wanted + (p * cross(b, c) + q * cross(c, a) + r * cross(a, b)) / volume);
    }
  };

  static constexpr double parallel = 1e-20;  // squared sine of the angle between planes

  /// Signed distance to the i-th half-space [m], positive outside it.
  double missing(std::size_t i, const Vec3d& place) const { return half_spaces_[i].least - dot(half_spaces_[i].normal, place); }

  std::array<HalfSpace, most> half_spaces_;
  std::size_t count_ = 0;
};

}  // namespace fccda
