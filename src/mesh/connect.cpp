#include "mesh/connect.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>

namespace fccda {
namespace {

struct Side {
  std::uint64_t edge;  // lower vertex, higher vertex
  int triangle, e;
  friend bool operator<(const Side& a, const Side& b) { return a.edge != b.edge ? a.edge < b.edge : a.triangle < b.triangle; }
};

std::vector<Side> sorted_sides(const std::vector<Triangle>& triangles) {
  std::vector<Side> sides;
  sides.reserve(3 * triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (std::size_t e = 0; e < 3; ++e) {
      const auto [low, high] = std::minmax(triangles[t].vertex[e], triangles[t].vertex[(e + 1) % 3]);
      sides.push_back({static_cast<std::uint64_t>(low) << 32 | static_cast<std::uint64_t>(high), static_cast<int>(t), static_cast<int>(e)});
    }
  }
  std::sort(sides.begin(), sides.end());
  return sides;
}

int& neighbour(LinkedTriangles& surface, int triangle, int e) { return surface.neighbours[static_cast<std::size_t>(triangle)][static_cast<std::size_t>(e)]; }

/// A triangle at a non-manifold edge, by its dihedral angle about it.
struct WedgeSide {
  double angle;       // [rad] about the edge from its lower vertex to its higher
  bool faces_onward;  // its front faces towards larger angles
  int triangle, e;    // and its side on the edge
};

/// The side of the triangle on the edge, in either direction.
std::size_t side_along(const Triangle& triangle, const std::array<int, 2>& edge) {
  std::size_t e = 0;
  while (std::pair<int, int>(std::minmax(triangle.vertex[e], triangle.vertex[(e + 1) % 3])) != std::pair(edge[0], edge[1])) ++e;
  return e;
}

std::vector<WedgeSide> sides_around(const LinkedTriangles& surface, const NonManifoldEdge& edge, bool fronts_are_backs) {
  const Vec3d& from = surface.vertices[static_cast<std::size_t>(edge.vertices[0])];
  const Vec3d axis = surface.vertices[static_cast<std::size_t>(edge.vertices[1])] - from;
  std::vector<WedgeSide> wedge_sides;
  Vec3d first{}, second{};  // directions at the angles 0 and a quarter turn
  for (const int triangle : edge.triangles) {
    const auto& vertex = surface.triangles[static_cast<std::size_t>(triangle)].vertex;
    const std::size_t e = side_along(surface.triangles[static_cast<std::size_t>(triangle)], edge.vertices);
    const Vec3d apex = surface.vertices[static_cast<std::size_t>(vertex[(e + 2) % 3])] - from;
    const Vec3d outward = apex - dot(apex, axis) / squared_norm(axis) * axis;
    if (wedge_sides.empty()) first = outward / norm(outward), second = cross(axis, first) / norm(axis);
    wedge_sides.push_back(
        {std::atan2(dot(outward, second), dot(outward, first)), (vertex[e] == edge.vertices[0]) != fronts_are_backs, triangle, static_cast<int>(e)});
  }
  std::sort(wedge_sides.begin(), wedge_sides.end(),
            [](const WedgeSide& a, const WedgeSide& b) { return a.angle != b.angle ? a.angle < b.angle : a.triangle < b.triangle; });
  return wedge_sides;
}

}  // namespace

Connection connect(LinkedTriangles& surface) {
  surface.neighbours.assign(surface.triangles.size(), {-1, -1, -1});
  const std::vector<Side> sides = sorted_sides(surface.triangles);
  Connection out;
  for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
    while (end < sides.size() && sides[end].edge == sides[begin].edge) ++end;
    if (end - begin == 1) {
      ++out.boundary_edges;
    } else if (end - begin == 2) {
      const Side &a = sides[begin], &b = sides[begin + 1];
      neighbour(surface, a.triangle, a.e) = b.triangle;
      neighbour(surface, b.triangle, b.e) = a.triangle;
    } else {
      NonManifoldEdge& non_manifold_edges = out.non_manifold_edges.emplace_back();
      non_manifold_edges.vertices = {static_cast<int>(sides[begin].edge >> 32), static_cast<int>(sides[begin].edge & 0xffffffffu)};
      for (std::size_t s = begin; s < end; ++s) non_manifold_edges.triangles.push_back(sides[s].triangle);
    }
  }
  return out;
}

Unjoined join_non_manifold(LinkedTriangles& surface, const std::vector<NonManifoldEdge>& non_manifold_edges, bool fronts_are_backs) {
  // Triangles at nearer angles coincide within the precision of float coordinates, so their order is undetermined.
  constexpr double same_angle = 1e-6;
  Unjoined out;
  for (const NonManifoldEdge& edge : non_manifold_edges) {
    const std::vector<WedgeSide> wedge_sides = sides_around(surface, edge, fronts_are_backs);
    const std::size_t count = wedge_sides.size();
    const auto is_alone = [&](std::size_t k) {
      const double wedge = wedge_sides[(k + 1) % count].angle - wedge_sides[k].angle;
      return std::fabs(std::remainder(wedge, 2 * std::numbers::pi)) > same_angle;
    };
    std::vector<bool> joined(count, false);
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t next = (k + 1) % count;
      if (!wedge_sides[k].faces_onward || wedge_sides[next].faces_onward || !is_alone(k) || !is_alone(next) || !is_alone((k + count - 1) % count)) continue;
      neighbour(surface, wedge_sides[k].triangle, wedge_sides[k].e) = wedge_sides[next].triangle;
      neighbour(surface, wedge_sides[next].triangle, wedge_sides[next].e) = wedge_sides[k].triangle;
      joined[k] = joined[next] = true;
    }
    for (std::size_t k = 0; k < count; ++k)
      if (!joined[k]) out.triangles.push_back(static_cast<std::size_t>(wedge_sides[k].triangle));
    if (std::find(joined.begin(), joined.end(), false) != joined.end()) out.edges.push_back(edge);
  }
  return out;
}

}  // namespace fccda
