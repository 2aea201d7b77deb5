#include <doctest/doctest.h>

#include <numbers>
#include <random>

#include "fixtures/surfaces.hpp"
#include "fixtures/tolerance.hpp"
#include "mesh/shapes/box.hpp"
#include "mesh/surface.hpp"

using namespace fccda;

namespace {

struct Closest {
  Vec3d point{};
  std::size_t triangle = 0;
  Feature feature = Feature::face;
  double distance = 1e300;
};

/// By evaluating all faces, edges and vertices of all triangles: the nearest point of a face counts only if the foot of the perpendicular
/// lies inside it, that of an edge only between its ends.
Closest closest(const Surface& surface, const Vec3d& p) {
  Closest best;
  const auto consider = [&](const Vec3d& point, std::size_t t, Feature feature) {
    if (norm(p - point) < best.distance) best = {point, t, feature, norm(p - point)};
  };
  for (std::size_t t = 0; t < surface.triangles().size(); ++t) {
    const Vec3d normal = surface.normal(t);
    const Vec3d foot = p - dot(p - surface.corner(t, 0), normal) * normal;
    bool inside = true;
    for (std::size_t e = 0; e < 3; ++e) {
      const Vec3d &a = surface.corner(t, e), &b = surface.corner(t, (e + 1) % 3);
      inside = inside && dot(cross(b - a, foot - a), normal) > 0;
      const double along = dot(p - a, b - a) / squared_norm(b - a);
      if (along > 0 && along < 1) consider(a + along * (b - a), t, static_cast<Feature>(1 + e));
      consider(a, t, static_cast<Feature>(4 + e));
    }
    if (inside) consider(foot, t, Feature::face);
  }
  return best;
}

/// A blade of the given thickness with sharp edges, as a lens of triangles between two fans.
Panels blade(double thickness, int sides) {
  Panels out;
  for (int k = 0; k < sides; ++k) {
    const double u = 2 * std::numbers::pi * k / sides;
    out.vertices.push_back({std::cos(u), 0.3 * std::sin(u), 0.05 * std::cos(3 * u)});
  }
  out.vertices.push_back({0.1, 0, 0.5 * thickness});
  out.vertices.push_back({0.1, 0, -0.5 * thickness});
  for (int k = 0; k < sides; ++k) {
    out.add_triangle(k, (k + 1) % sides, sides);
    out.add_triangle((k + 1) % sides, k, sides + 1);
  }
  return out;
}

/// A box with a notch down to its middle, so that it has re-entrant edges and saddle-like vertices.
Panels notched_box() {
  return {{{0, 0, 0},
           {2, 0, 0},
           {2, 0, 1},
           {1.1, 0, 1},
           {1, 0, 0.2},
           {0.9, 0, 1},
           {0, 0, 1},
           {0, 1, 0},
           {2, 1, 0},
           {2, 1, 1},
           {1.1, 1, 1},
           {1, 1, 0.2},
           {0.9, 1, 1},
           {0, 1, 1}},
          {{0, 1, 4, -1},
           {1, 2, 3, -1},
           {1, 3, 4, -1},
           {0, 4, 5, -1},
           {0, 5, 6, -1},
           {7, 11, 8, -1},
           {8, 10, 9, -1},
           {8, 11, 10, -1},
           {7, 12, 11, -1},
           {7, 13, 12, -1},
           {0, 7, 8, 1},
           {1, 8, 9, 2},
           {2, 9, 10, 3},
           {3, 10, 11, 4},
           {4, 11, 12, 5},
           {5, 12, 13, 6},
           {6, 13, 7, 0}}};
}

/// Counts the points at which the sign by the pseudonormal differs from that by the winding number.
int wrong_sides(const Surface& surface, int points, double reach, std::mt19937_64& random) {
  Panels triangles{{surface.vertices().begin(), surface.vertices().end()}, {}};
  for (const Triangle& t : surface.triangles()) triangles.add_triangle(t.vertex[0], t.vertex[1], t.vertex[2]);
  std::uniform_real_distribution<double> unit(0, 1);
  int wrong = 0;
  for (int k = 0; k < points; ++k) {
    // beside a vertex, a point of an edge, or a point of a face
    const std::size_t t = random() % surface.triangles().size(), c = random() % 3;
    Vec3d p = surface.corner(t, c);
    if (k % 3 > 0) p += unit(random) * (surface.corner(t, (c + 1) % 3) - p);
    if (k % 3 > 1) p += unit(random) * (surface.corner(t, (c + 2) % 3) - p);
    p += std::pow(10.0, -4 * unit(random)) * reach * fixtures::random_direction(random);
    const Closest found = closest(surface, p);
    if (found.distance < 1e-7 * reach) continue;  // the winding number is rounding there
    const bool is_inside = dot(p - found.point, surface.pseudonormal(found.triangle, found.feature)) < 0;
    wrong += is_inside != (fixtures::winding_number(triangles, p) > 0.5) ? 1 : 0;
  }
  return wrong;
}

}  // namespace

TEST_CASE("pseudonormals: the sign at faces, edges and vertices agrees with the winding number, for cube, torus, notch and blades") {
  std::mt19937_64 random(1);
  CHECK(wrong_sides(Surface(fixtures::unit_cube()), 6000, 0.5, random) == 0);
  CHECK(wrong_sides(Surface(notched_box()), 6000, 0.3, random) == 0);
  CHECK(wrong_sides(Surface(fixtures::torus(2, 0.7, 12, 8, 1)), 3000, 0.5, random) == 0);
  for (const double thickness : {0.1, 0.01, 1e-4}) CHECK(wrong_sides(Surface(blade(thickness, 24)), 6000, 0.3, random) == 0);
}

TEST_CASE("pseudonormals: the inside of a hollow body is between its walls") {
  std::mt19937_64 random(2);
  const Panels outer = make_box({.size = {2, 2, 2}, .edge_length = 1}), inner = make_box({.size = {1.5, 1.5, 1.5}, .edge_length = 0.75});
  CHECK(wrong_sides(Surface(fixtures::joined(outer, inner)), 6000, 0.4, random) == 0);
}

TEST_CASE("pseudonormals: a cube's vertex has the diagonal, although three faces give it one triangle and three give it two") {
  const Surface cube(fixtures::unit_cube());
  for (std::size_t t = 0; t < 12; ++t) {
    for (std::size_t c = 0; c < 3; ++c) {
      const Vec3d diagonal = (2.0 * cube.corner(t, c) - Vec3d{1, 1, 1}) / std::sqrt(3.0);
      CHECK(norm(cube.pseudonormal(t, static_cast<Feature>(4 + c)) - diagonal) < 1e-15);  // rounding
    }
  }
}

TEST_CASE("pseudonormals: all are unit vectors, for tiny and huge bodies too") {
  for (const double size : {1e-40, 1.0, 1e40}) {
    const Surface surface(fixtures::moved(blade(0.01, 24), [&](const Vec3d& v) { return size * v; }));
    for (std::size_t t = 0; t < surface.triangles().size(); ++t) {
      for (int f = 0; f < 7; ++f) CHECK(norm(surface.pseudonormal(t, static_cast<Feature>(f))) == fixtures::relative(1, 1e-15));
    }
  }
}

TEST_CASE("pseudonormals: on the edge of an open sheet folded onto itself they point away from it") {
  const Panels folded{{{0, 0, 0}, {1, 0, 0}, {0.4, 1, 0}, {0.6, 1, 0}}, {{0, 1, 2, -1}, {1, 0, 3, -1}}};
  const Surface surface(folded, {.orientation = Orientation::normals, .name = "fold"});
  CHECK(surface.pseudonormal(0, Feature::edge_0) == Vec3d{0, -1, 0});
}

TEST_CASE("pseudonormals: an edge has bitwise identical normals from both of its triangles") {
  const Surface surface(fixtures::torus(2, 0.7, 12, 8, 1));
  for (std::size_t t = 0; t < surface.triangles().size(); ++t) {
    for (std::size_t e = 0; e < 3; ++e) {
      const auto u = static_cast<std::size_t>(surface.neighbour(t, e));
      for (std::size_t f = 0; f < 3; ++f) {
        if (surface.neighbour(u, f) == int(t))
          CHECK(surface.pseudonormal(u, static_cast<Feature>(1 + f)) == surface.pseudonormal(t, static_cast<Feature>(1 + e)));
      }
    }
  }
}
