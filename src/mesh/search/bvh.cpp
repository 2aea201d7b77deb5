#include "mesh/search/bvh.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace fccda {

namespace {

// A squared distance from a box in floats has a relative error below 2⁻²² once the box's slack has covered the rounding of positions.
// Reduced by this factor it is a lower bound.
constexpr float lowered = 1 - 0x1p-20F;

/// A float not below the double, and finite, so that absent children are rejected.
float as_bound(double best) { return static_cast<float>(std::min(best * (1 + 0x1p-20), 1e38)); }

struct Waiting {
  float squared_distance;
  std::int32_t child;
};

constexpr auto any = [](int) { return true; };

}  // namespace

// Squared distance to each triangle of a leaf: from the plane if the point is above all three edges, otherwise from the nearest edge.
std::array<double, Bvh::width> Bvh::squared_distances(const Leaf& leaf, const Vec3d& point) {
  std::array<double, width> result;
#pragma omp simd
  for (std::size_t l = 0; l < width; ++l) {
    const double abx = leaf.ab[0][l], aby = leaf.ab[1][l], abz = leaf.ab[2][l];
    const double acx = leaf.ac[0][l], acy = leaf.ac[1][l], acz = leaf.ac[2][l];
    const double bcx = acx - abx, bcy = acy - aby, bcz = acz - abz;
    const double px = point.x - leaf.a[0][l], py = point.y - leaf.a[1][l], pz = point.z - leaf.a[2][l];
    const double nx = aby * acz - abz * acy, ny = abz * acx - abx * acz, nz = abx * acy - aby * acx;

    const double qx = px - abx, qy = py - aby, qz = pz - abz;  // from b
    const double s_ab = px * abx + py * aby + pz * abz, s_ac = px * acx + py * acy + pz * acz, s_bc = qx * bcx + qy * bcy + qz * bcz;
    double t_ab = s_ab * leaf.inverse_ab[l], t_ac = s_ac * leaf.inverse_ca[l], t_bc = s_bc * leaf.inverse_bc[l];
    t_ab = t_ab < 0 ? 0 : t_ab, t_ab = t_ab > 1 ? 1 : t_ab;
    t_ac = t_ac < 0 ? 0 : t_ac, t_ac = t_ac > 1 ? 1 : t_ac;
    t_bc = t_bc < 0 ? 0 : t_bc, t_bc = t_bc > 1 ? 1 : t_bc;
    const double ux = px - t_ab * abx, uy = py - t_ab * aby, uz = pz - t_ab * abz;
    const double vx = px - t_ac * acx, vy = py - t_ac * acy, vz = pz - t_ac * acz;
    const double wx = qx - t_bc * bcx, wy = qy - t_bc * bcy, wz = qz - t_bc * bcz;
    const double d_ab = ux * ux + uy * uy + uz * uz, d_ac = vx * vx + vy * vy + vz * vz, d_bc = wx * wx + wy * wy + wz * wz;
    double edge = d_ab < d_ac ? d_ab : d_ac;
    edge = edge < d_bc ? edge : d_bc;

    const double height = px * nx + py * ny + pz * nz;
    const double in_ab = (aby * pz - abz * py) * nx + (abz * px - abx * pz) * ny + (abx * py - aby * px) * nz;
    const double in_ac = (py * acz - pz * acy) * nx + (pz * acx - px * acz) * ny + (px * acy - py * acx) * nz;
    const double in_bc = (bcy * qz - bcz * qy) * nx + (bcz * qx - bcx * qz) * ny + (bcx * qy - bcy * qx) * nz;
    double inside = in_ab < in_ac ? in_ab : in_ac;
    inside = inside < in_bc ? inside : in_bc;
    const double face = height * height * leaf.inverse_normal[l];
    result[l] = inside > 0 ? face : edge;
  }
  return result;
}

// The closest triangle so far.
class Bvh::Closest {
 public:
  Closest(const Bvh& bvh, const Vec3d& point, double cap) : bvh_(bvh), point_(point), from_origin_(point - bvh.origin_), squared_(cap * cap) {}

  const Vec3d& from_origin() const { return from_origin_; }
  double squared() const { return squared_; }

  template <class Accept>
  void consider(std::int32_t index, std::size_t& tested, const Accept& accept) {
    Leaf room;
    const Leaf& leaf = bvh_.current_leaf(index, room);
    const std::array<double, width> d = squared_distances(leaf, from_origin_);
    tested += static_cast<std::size_t>(leaf.count);
    for (std::size_t l = 0; l < static_cast<std::size_t>(leaf.count); ++l) {
      if (!(d[l] <= squared_)) continue;
      const int triangle = leaf.triangle[l];
      if (d[l] == squared_ && triangle_ >= 0) {
        const auto rank = [&](int t) { return std::pair(bvh_.surface_->triangles()[static_cast<std::size_t>(t)].panel, t); };
        if (rank(triangle) >= rank(triangle_)) continue;
      }
      if (accept(triangle)) squared_ = d[l], triangle_ = triangle;
    }
  }

  std::optional<ClosestPoint> found() const {
    if (triangle_ < 0) return std::nullopt;
    const PointOnTriangle on = closest_on_triangle(point_, bvh_.corners(static_cast<std::size_t>(triangle_)));
    return ClosestPoint{triangle_, on.feature, on.point, norm(point_ - on.point)};
  }

 private:
  const Bvh& bvh_;
  Vec3d point_, from_origin_;
  double squared_;
  int triangle_ = -1;
};

template <class Accept>
std::optional<ClosestPoint> Bvh::search_closest(const Vec3d& point, double cap, int guess, std::size_t& tested, Nearby* nearby, const Accept& accept) const {
  if (!(cap >= 0)) return std::nullopt;
  Closest best(*this, point, cap);
  const Vec3d& p = best.from_origin();
  const std::array<float, 3> q{static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};

  double limit = 0;  // squared, of what is worth a visit
  const auto narrow = [&] {
    const double wide = nearby && nearby->reach > 0 ? std::sqrt(best.squared()) + 2 * nearby->reach : 0;
    limit = std::max(best.squared(), wide * wide);
  };
  std::int32_t guessed = -1;  // its leaf will be visited again
  const auto visit_leaf = [&](std::int32_t index) {
    if (index == guessed) return;
    best.consider(index, tested, accept);
    if (nearby) nearby->add(index);
    narrow();
  };
  narrow();
  if (guess >= 0 && !leaf_of_.empty()) {
    const std::int32_t index = leaf_of_[static_cast<std::size_t>(guess)];
    visit_leaf(index);
    guessed = index;
  }

  std::array<Waiting, stack_size> stack;
  std::size_t depth = 0;
  stack[depth++] = {0, 0};
  while (depth > 0) {
    const Waiting next = stack[--depth];
    if (!(next.squared_distance <= limit)) continue;
    if (next.child < 0) {
      visit_leaf(~next.child);
      continue;
    }
    const Node& node = nodes_[static_cast<std::size_t>(next.child)];
    std::array<float, width> d;
    const float bound = as_bound(limit);
    unsigned near = 0;
#pragma omp simd reduction(| : near)
    for (std::size_t c = 0; c < width; ++c) {
      float sum = 0;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const float below = node.low[axis][c] - q[axis], above = q[axis] - node.high[axis][c];
        float gap = below > above ? below : above;
        gap = gap > 0 ? gap : 0;
        sum += gap * gap;
      }
      d[c] = sum * lowered;
      near |= (d[c] <= bound ? 1u : 0u) << c;
    }
    // Push the farthest first, so that the nearest is popped next.
    const std::size_t base = depth;
    for (; near != 0; near &= near - 1) {
      const auto c = static_cast<std::size_t>(std::countr_zero(near));
      std::size_t at = depth++;
      for (; at > base && stack[at - 1].squared_distance < d[c]; --at) stack[at] = stack[at - 1];
      stack[at] = {d[c], node.child[c]};
    }
  }
  return best.found();
}

std::optional<ClosestPoint> Bvh::closest(const Vec3d& point, double cap, int guess, std::size_t& tested) const {
  return search_closest(point, cap, guess, tested, nullptr, any);
}

std::optional<ClosestPoint> Bvh::closest(const Vec3d& point, double cap, int guess, double reach, Nearby& nearby, std::size_t& tested) const {
  nearby = {.centre = point, .reach = reach <= worthwhile_ ? reach : 0};
  const std::optional<ClosestPoint> closest = search_closest(point, cap, guess, tested, &nearby, any);
  if (closest)
    nearby.distance = closest->distance;
  else
    nearby.reach = 0;
  return closest;
}

// With c the centre, T a triangle that was not visited and C the closest to c, all within `reach` of c have
//   d(q, T) >= d(c, T) - |q - c| > d(c, C) + 2 reach - |q - c| >= d(q, C) + 2 (reach - |q - c|),
// so T is not the closest to q. A hundredth of the reach is reserved for rounding.
std::optional<ClosestPoint> Bvh::closest(const Vec3d& point, const Nearby& nearby, int guess, std::size_t& tested) const {
  if (!(norm(point - nearby.centre) < 0.99 * nearby.reach)) return closest(point, no_cap, guess, tested);
  return closest_of(point, nearby, tested);
}

// With d the distances from the centre after the motion, and d' those from the point before it, T and C as above,
//   d'(T) >= d(T) - way > d(C) + 2 reach - way >= d'(C) + 2 (reach - way).
std::optional<ClosestPoint> Bvh::closest_before(const Vec3d& point, const Nearby& nearby, double way, int guess, std::size_t& tested) const {
  if (!(way < 0.99 * nearby.reach)) return closest(point, no_cap, guess, tested);
  return closest_of(point, nearby, tested);
}

std::optional<ClosestPoint> Bvh::closest_of(const Vec3d& point, const Nearby& nearby, std::size_t& tested) const {
  Closest best(*this, point, no_cap);
  for (std::size_t k = 0; k < nearby.count; ++k) best.consider(nearby.leaves[k], tested, any);
  return best.found();
}

std::optional<ClosestPoint> Bvh::closest(const Vec3d& point, double cap) const {
  std::size_t tested = 0;
  return closest(point, cap, -1, tested);
}

std::optional<ClosestPoint> Bvh::closest_facing(const Vec3d& point, const Vec3d& viewer, double cap, std::size_t& tested) const {
  return search_closest(point, cap, -1, tested, nullptr, [&](int triangle) {
    const auto t = static_cast<std::size_t>(triangle);
    return dot(viewer - surface_->corner(t, 0), surface_->normal(t)) > 0;
  });
}

}  // namespace fccda
