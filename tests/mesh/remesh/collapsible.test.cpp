#include "mesh/remesh/collapsible.hpp"

#include <doctest/doctest.h>

#include <random>
#include <set>

#include "mesh/remesh/meshes.hpp"
#include "mesh/shapes/sphere.hpp"

using namespace fccda;
using fixtures::surface_from;

namespace {

Panels panels_of(const CollapsibleTriangles& mesh) {
  Panels out;
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) out.vertices.push_back(mesh.place(static_cast<int>(v)));
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t)
    if (mesh.has_triangle(t)) out.add_triangle(mesh.triangle(t).vertex[0], mesh.triangle(t).vertex[1], mesh.triangle(t).vertex[2]);
  return out;
}

/// Performs all admissible collapses, regardless of shape. `check` is called with the mesh from time to time.
template <class Check>
Panels collapsed(const Panels& panels, unsigned seed, const Check& check) {
  CollapsibleTriangles mesh(surface_from(panels));
  std::mt19937_64 random(seed);
  Ring ring;
  bool goes_on = true;
  for (int round = 0; goes_on; ++round) {
    goes_on = false;
    for (int v = 0; v < static_cast<int>(mesh.vertex_count()); ++v) {
      if (!mesh.has_vertex(v)) continue;
      mesh.ring_of(v, ring);
      const std::size_t first = random();
      for (std::size_t k = 0; k < ring.link.size(); ++k) {
        const std::size_t to = (first % ring.link.size() + k) % ring.link.size();
        if (!mesh.may_collapse(v, ring, to)) continue;
        mesh.collapse(v, ring, to);
        goes_on = true;
        if (random() % 20 == 0) check(panels_of(mesh));
        break;
      }
    }
  }
  return panels_of(mesh);
}

/// Edges with one triangle.
std::size_t boundary_edges(const Panels& panels) {
  std::multiset<std::pair<int, int>> edges;
  for (const auto& p : panels.panels)
    for (std::size_t c = 0; c < 3; ++c) edges.insert(std::minmax(p[c], p[(c + 1) % 3]));
  return static_cast<std::size_t>(std::count_if(edges.begin(), edges.end(), [&](const auto& edge) { return edges.count(edge) == 1; }));
}

}  // namespace

TEST_CASE("collapsible: under any collapses a sphere stays a sphere until a tetrahedron is left, and a torus stays a torus") {
  const auto expect = [](int characteristic) {
    return [=](const Panels& panels) {
      CHECK(fixtures::is_watertight(panels));
      CHECK(fixtures::euler_characteristic(panels) == characteristic);
    };
  };
  for (unsigned seed = 1; seed <= 3; ++seed) {
    CHECK(collapsed(make_sphere({.diameter = 1, .edge_length = 0.25}), seed, expect(2)).panels.size() == 4);
    const Panels torus = collapsed(fixtures::torus(1, 0.3, 12, 8), seed, expect(0));
    expect(0)(torus);
    CHECK(torus.panels.size() >= 14);  // fewer than seven vertices make no torus (Heawood 1890)
    CHECK(torus.panels.size() <= 40);
  }
}

TEST_CASE("collapsible: a plate with a hole keeps the hole and its outline, each of three edges at least") {
  Panels plate = fixtures::askew_plate(9, 1, 7);
  plate.panels.erase(plate.panels.begin() + 80);
  for (unsigned seed = 1; seed <= 3; ++seed) {
    const auto expect_ring = [](const Panels& panels) { CHECK(fixtures::euler_characteristic(panels) == 0); };
    const Panels left = collapsed(plate, seed, expect_ring);
    expect_ring(left);
    CHECK(boundary_edges(left) == 6);
    CHECK(left.panels.size() < 20);
  }
}

TEST_CASE("collapsible: a ring lists neighbours counterclockwise, from boundary to boundary if there is one") {
  const Surface plate = surface_from(fixtures::askew_plate(2, 1, 1));
  const CollapsibleTriangles mesh(plate);
  const auto at = [&](const Vec3d& place) {
    return static_cast<int>(std::find(plate.vertices().begin(), plate.vertices().end(), place) - plate.vertices().begin());
  };
  const int middle = at(fixtures::askew_plate(2, 1, 1).vertices[4]), below = at({0.5, 0, 0});
  Ring ring;
  mesh.ring_of(middle, ring);
  CHECK(ring.goes_round);
  CHECK(ring.link.size() == 6);
  for (std::size_t j = 0; j < ring.link.size(); ++j) {
    const Vec3d a = mesh.place(ring.link[j]) - mesh.place(middle), b = mesh.place(ring.link[ring.after(j)]) - mesh.place(middle);
    CHECK(cross(a, b).z > 0);
  }
  mesh.ring_of(below, ring);
  CHECK(!ring.goes_round);
  CHECK(ring.link.front() == at({1, 0, 0}));
  CHECK(ring.link.back() == at({0, 0, 0}));
  CHECK(ring.triangles.size() + 1 == ring.link.size());
}
