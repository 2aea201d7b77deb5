// Volume and centroid of cells, compared with formulas.
#include "mesh_io/file/cells.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>
#include <vector>

#include "fixtures/tolerance.hpp"

using namespace fccda;

namespace {

/// Corners in the order of elements.hpp.
const std::vector<std::pair<ElementKind, std::vector<Vec3d>>> solids = {
    {ElementKind::tetrahedron, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
    {ElementKind::pyramid, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 1}}},
    {ElementKind::wedge, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}}},
    {ElementKind::hexahedron, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}}};

const double volumes[] = {1.0 / 6, 1.0 / 3, 0.5, 1};
const Vec3d centroids[] = {{0.25, 0.25, 0.25}, {0.5, 0.5, 0.25}, {1.0 / 3, 1.0 / 3, 0.5}, {0.5, 0.5, 0.5}};

constexpr double rounding = 1e-14;  // of unit cells

}  // namespace

TEST_CASE("cells: tetrahedron, pyramid, wedge and hexahedron have the volume and centroid of the formulas, in either orientation") {
  for (std::size_t k = 0; k < solids.size(); ++k) {
    auto [kind, corners] = solids[k];
    for (const double side : {1.0, -1.0}) {
      for (Vec3d& corner : corners) corner.x *= side;
      const auto cell = cell_of(kind, corners);
      REQUIRE(cell.has_value());
      CHECK(cell->measure == fixtures::relative(volumes[k], rounding));
      CHECK(norm(cell->centroid - Vec3d{side * centroids[k].x, centroids[k].y, centroids[k].z}) < rounding);
    }
  }
}

TEST_CASE("cells: a warped hexahedron has the volume of its trilinear map, summed by Gauss points") {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> move(-0.2, 0.2);
  for (int n = 0; n < 20; ++n) {
    std::vector<Vec3d> corners = solids[3].second;
    for (Vec3d& corner : corners) corner += Vec3d{move(random), move(random), move(random)};
    double volume = 0;  // the determinant is quadratic along each axis: two points are exact
    const auto place = [&](double u, double v, double w) {
      Vec3d sum{};
      for (std::size_t k = 0; k < 8; ++k) {
        const Vec3d& at = solids[3].second[k];
        sum += (at.x > 0 ? u : 1 - u) * (at.y > 0 ? v : 1 - v) * (at.z > 0 ? w : 1 - w) * corners[k];
      }
      return sum;
    };
    const double low = 0.5 - 0.5 / std::sqrt(3.0), gauss[] = {low, 1 - low};
    for (const double u : gauss)
      for (const double v : gauss)
        for (const double w : gauss)
          volume += dot(place(1, v, w) - place(0, v, w), cross(place(u, 1, w) - place(u, 0, w), place(u, v, 1) - place(u, v, 0))) / 8;
    CHECK(cell_of(ElementKind::hexahedron, corners)->measure == fixtures::relative(volume, 1e-13));
  }
}

TEST_CASE("cells: a hexahedron with nodes in the wrong order is distinguished from a mirrored one") {
  std::vector<Vec3d> corners = solids[3].second;
  std::swap(corners[2], corners[3]);  // twisted: faces cross
  CHECK(!cell_of(ElementKind::hexahedron, corners).has_value());
}

TEST_CASE("cells: without volume or area there is no cell") {
  auto flat = solids[0].second;
  flat[3] = {0.3, 0.3, 0};
  CHECK(!cell_of(ElementKind::tetrahedron, flat).has_value());
  CHECK(!cell_of(ElementKind::polygon, std::vector<Vec3d>{{0, 0, 0}, {1, 1, 0}, {2, 2, 0}}).has_value());
}

TEST_CASE("cells: triangles, quads and an arrowhead have the area and centroid of the formulas") {
  const auto triangle = cell_of(ElementKind::triangle_6, std::vector<Vec3d>{{0, 0, 1}, {3, 0, 1}, {0, 3, 1}});
  CHECK(triangle->measure == fixtures::relative(4.5, rounding));
  CHECK(norm(triangle->centroid - Vec3d{1, 1, 1}) < rounding);
  const auto quad = cell_of(ElementKind::polygon, std::vector<Vec3d>{{0, 0, 0}, {0, 2, 0}, {4, 2, 0}, {4, 0, 0}});
  CHECK(quad->measure == fixtures::relative(8, rounding));
  CHECK(norm(quad->centroid - Vec3d{2, 1, 0}) < rounding);
  // the triangle (0, 0), (4, 0), (0, 4) of area 8 without (0, 0), (4, 0), (1, 1), of area 2
  const auto arrow = cell_of(ElementKind::polygon, std::vector<Vec3d>{{1, 1, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 0}});
  CHECK(arrow->measure == fixtures::relative(6, rounding));
  CHECK(norm(arrow->centroid - (8 * Vec3d{4.0 / 3, 4.0 / 3, 0} - 2 * Vec3d{5.0 / 3, 1.0 / 3, 0}) / 6.0) < rounding);
}
