#include "fccda/deforming/deforming_surface.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <random>
#include <set>
#include <string>

#include "base/error.hpp"
#include "fccda/deforming/scenes.hpp"
#include "fccda/deforming/step_warnings.hpp"
#include "fixtures/larger.hpp"
#include "fixtures/tolerance.hpp"
#include "mesh/shapes/box.hpp"

using namespace deforming;

namespace {

DeformingSurface moved_surface(const Panels& panels, const Deformation& deformation, double from, double to) {
  DeformingSurface surface{Surface(panels)};
  surface.move(displaced(panels, deformation, from));
  surface.move(displaced(panels, deformation, to));
  return surface;
}

template <class Error = InputError>
std::string refusal(DeformingSurface& surface, const std::vector<Vec3d>& vertices) {
  try {
    surface.move(vertices);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

/// Panels with a vertex m on a straight edge of one of them, which a sliver (a, m, c) fills: as CAD programs and triangulations of hulls write them.
Panels sheet_with_sliver(bool sliver_first, bool has_lower_half) {
  Panels panels;
  panels.vertices = {{0, 0, 0}, {2, 0, 0}, {1, 1, 0}, {1, -1, 0}, {0.7, 0, 0}};
  if (!sliver_first) panels.add_triangle(0, 1, 2);
  panels.add_triangle(0, 4, 1);
  if (has_lower_half) panels.add_triangle(0, 3, 4), panels.add_triangle(4, 3, 1);
  if (sliver_first) panels.add_triangle(0, 1, 2);
  return panels;
}
Panels cube_with_sliver() {
  Panels panels;
  panels.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}, {0.4, 0, 1}};
  panels.add_quad(0, 3, 2, 1), panels.add_quad(4, 5, 6, 7), panels.add_quad(1, 2, 6, 5), panels.add_quad(2, 3, 7, 6), panels.add_quad(3, 0, 4, 7);
  panels.add_triangle(0, 1, 8), panels.add_triangle(1, 5, 8), panels.add_triangle(0, 8, 4), panels.add_triangle(4, 8, 5);
  return panels;
}

/// The same panels with vertices of their own, as in STL files.
Panels unshared(const Panels& panels) {
  Panels out;
  for (const auto& panel : panels.panels) {
    std::array<int, 4> corners{-1, -1, -1, -1};
    for (std::size_t c = 0; c < 4 && panel[c] >= 0; ++c) {
      corners[c] = static_cast<int>(out.vertices.size());
      out.vertices.push_back(panels.vertices[static_cast<std::size_t>(panel[c])]);
    }
    out.panels.push_back(corners);
  }
  return out;
}

/// Bound of how far the point moves relative to any point of the surface [m].
double way(const DeformingSurface& surface, const Path& path) { return surface.spread() + norm(path.end - path.start - surface.mean_displacement()); }

}  // namespace

TEST_CASE("deforming surface: a refitted tree finds the closest point that a loop over all triangles finds") {
  std::mt19937_64 random(21);
  for (const fixtures::Body& body : fixtures::bodies())
    for (const Deformation& deformation : deformations()) {
      const DeformingSurface surface = moved_surface(body.panels, deformation, 0.1, 0.3);
      const Soup soup(surface.at_t1());
      for (int k = 0; k < 8; ++k) {
        const Vec3d point = path_near(surface, 0.5, 0.5, random).end;
        const std::optional<ClosestPoint> closest = surface.bvh_t1().closest(point);
        REQUIRE(closest.has_value());
        CHECK(closest->distance == fixtures::absolute(soup.distance(point), 1e-12, "m"));
      }
    }
}

TEST_CASE("deforming surface: the search visits every triangle that comes within the margin of a moving point") {
  std::mt19937_64 random(22);
  std::size_t near = 0, visited = 0, all = 0;
  for (const fixtures::Body& body : fixtures::bodies())
    for (const Deformation& deformation : deformations()) {
      const DeformingSurface surface = moved_surface(body.panels, deformation, 0.1, 0.3);
      for (int k = 0; k < 2; ++k) {
        const Path path = path_near(surface, 0.1, 0.3, random);
        std::set<int> seen;
        const double until = 1, margin = 0.02;
        surface.bvh_t1().visit_moving(surface.bvh_t0(), {path.start, path.end, margin, way(surface, path)}, {}, until,
                                      [&](int triangle) { seen.insert(triangle); });
        visited += seen.size(), all += surface.at_t1().triangles().size();
        for (std::size_t t = 0; t < surface.at_t1().triangles().size(); ++t) {
          bool is_near = false;
          for (int step = 0; step <= 20 && !is_near; ++step) {
            const Corners c = surface.triangle(t).at(step / 20.0);
            is_near = Soup::distance(path.at(step / 20.0), {c.a, c.b, c.c}) <= margin;
          }
          near += is_near;
          if (is_near) CHECK(seen.count(static_cast<int>(t)) == 1);
        }
      }
    }
  CHECK(near > 200);
  CHECK(visited < all / 10);  // and few others
}

TEST_CASE(
    "deforming surface: with cached surroundings of the end of a path, its start has the same closest point before the motion, and what it meets is the same") {
  std::mt19937_64 random(26);
  const Panels panels = fixtures::hull();
  std::size_t cached = 0, searched = 0, contacts = 0;
  for (const Deformation& deformation : deformations()) {
    const DeformingSurface surface = moved_surface(panels, deformation, 0.1, 0.1002);
    for (int k = 0; k < 2000; ++k) {
      const double radius = k % 3 == 0 ? 0 : 0.02;
      const Path path = path_near(surface, radius + 0.002, k % 2 == 0 ? 0.002 : 0.02, random);
      const double moved = way(surface, path);
      std::size_t tested = 0;
      Bvh::Nearby nearby;
      surface.bvh_t1().closest(path.end, Bvh::no_cap, -1, 2 * moved, nearby, tested);  // fills `nearby`
      const std::optional<ClosestPoint> expected = surface.bvh_t0().closest(path.start),
                                        found = surface.bvh_t0().closest_before(path.start, nearby, moved, -1, tested);
      CHECK(found->triangle == expected->triangle);
      CHECK(found->distance == expected->distance);
      const auto earliest = [&](const Bvh::Nearby& surroundings) {
        std::optional<Crossing> first;
        double until = 1;
        surface.bvh_t1().visit_moving(surface.bvh_t0(), {path.start, path.end, radius + 1e-12, moved}, surroundings, until, [&](int triangle) {
          const MovingTriangle of = surface.triangle(static_cast<std::size_t>(triangle));
          const std::optional<double> fraction = radius == 0 ? front_crossing(path, of) : first_contact(path, of, radius, 1e-12, until);
          if (fraction) take_if_first(surface.at_t1(), {triangle, *fraction}, first, until);
        });
        return first ? std::pair(first->triangle, first->fraction) : std::pair(-1, 2.0);
      };
      CHECK(earliest(nearby) == earliest({}));
      contacts += earliest({}).first >= 0;
      (nearby.covers(radius + moved) ? cached : searched) += 1;
      const auto same = [](const std::optional<Crossing>& a, const std::optional<Crossing>& b) {
        return a.has_value() == b.has_value() && (!a || (a->triangle == b->triangle && a->fraction == b->fraction));
      };
      CHECK(same(surface.bvh_t1().first_hit(path.start, path.end, nearby, tested), surface.bvh_t1().first_hit(path.start, path.end, tested)));
      CHECK(same(surface.bvh_t1().first_contact(path.start, path.end, 0.02, 1e-12, -1, nearby, tested),
                 surface.bvh_t1().first_contact(path.start, path.end, 0.02, 1e-12, -1, tested)));
    }
  }
  CHECK(cached > 1000);  // both ways are taken
  CHECK(searched > 1000);
  CHECK(contacts > 1000);
}

TEST_CASE("deforming surface: its normals are those of a surface made where the vertices are") {
  for (const Panels& panels : {fixtures::tetrahedron(), fixtures::sphere(), fixtures::hull()})
    for (const Deformation& deformation : deformations()) {
      const DeformingSurface surface = moved_surface(panels, deformation, 0.1, 0.2);
      const Surface made(fixtures::moved(panels, [&](const Vec3d& x) { return deformation.at(x, 0.2); }));
      REQUIRE(made.triangles().size() == surface.at_t1().triangles().size());
      for (std::size_t t = 0; t < made.triangles().size(); ++t)
        for (const Feature feature :
             {Feature::face, Feature::edge_0, Feature::edge_1, Feature::edge_2, Feature::vertex_0, Feature::vertex_1, Feature::vertex_2})
          CHECK(norm(made.pseudonormal(t, feature) - surface.at_t1().pseudonormal(t, feature)) == fixtures::absolute(0, 1e-14, "1"));
    }
}

TEST_CASE("deforming surface: a tree that has become slow is rebuilt, and both ends of the step keep one shape") {
  // The vertices of a sheet change places, so that triangles that were near each other are far apart.
  const Panels flat = sheet(24);
  DeformingSurface surface{Surface(flat, {.orientation = Orientation::normals})};
  std::vector<Vec3d> rolled = flat.vertices;
  for (Vec3d& x : rolled) x = {0.1 * std::cos(18 * x.x), 0.1 * std::sin(18 * x.x), x.y};  // rolled up three times, onto itself
  surface.move(rolled);
  CHECK(surface.rebuilds() == 1);
  const Soup soup(surface.at_t1()), before(surface.at_t0());
  std::mt19937_64 random(23);
  for (int k = 0; k < 30; ++k) {
    const Path path = path_near(surface, 0.05, 0.05, random);
    CHECK(surface.bvh_t1().closest(path.end)->distance == fixtures::absolute(soup.distance(path.end), 1e-12, "m"));
    CHECK(surface.bvh_t0().closest(path.start)->distance == fixtures::absolute(before.distance(path.start), 1e-12, "m"));
    const exact::Answer answer = Near(surface, path, 0).crossing(path);
    std::size_t found = 0;
    const double until = 1;
    surface.bvh_t1().visit_moving(surface.bvh_t0(), {path.start, path.end, 0, way(surface, path)}, {}, until,
                                  [&](int t) { found += front_crossing(path, surface.triangle(static_cast<std::size_t>(t))).has_value(); });
    CHECK((found > 0) == answer.crosses);
  }
}

TEST_CASE("deforming surface: vertices are numbered as those of the panels, shared or not") {
  const Panels cube = fixtures::unit_cube();
  Panels separate;  // as of an STL file
  for (const auto& panel : cube.panels) {
    for (const int vertex : panel) separate.vertices.push_back(cube.vertices[static_cast<std::size_t>(vertex)]);
    const int last = static_cast<int>(separate.vertices.size());
    separate.add_quad(last - 4, last - 3, last - 2, last - 1);
  }
  for (const Panels& panels : {cube, separate}) {
    DeformingSurface surface{Surface(panels)};
    std::vector<Vec3d> to = panels.vertices;
    for (Vec3d& x : to) x = {x.x + 0.1 * x.y, 1.2 * x.y, x.z - 0.3 * x.x};
    surface.move(to);
    for (std::size_t t = 0; t < surface.at_t1().triangles().size(); ++t) {
      const std::array<int, 3> vertices = surface.panel_vertices(t);
      for (std::size_t c = 0; c < 3; ++c) {
        CHECK(surface.at_t0().corner(t, c) == panels.vertices[static_cast<std::size_t>(vertices[c])]);
        CHECK(surface.at_t1().corner(t, c) == to[static_cast<std::size_t>(vertices[c])]);
      }
    }
    CHECK(surface.at_t1().report().bounds.high == Vec3d{1.1, 1.2, 1});
  }
  DeformingSurface surface{Surface(separate)};
  std::vector<Vec3d> parted = separate.vertices;
  parted[5] += Vec3d{0.01, 0, 0};
  CHECK(refusal(surface, parted).find("were merged at construction, but part from each other; move them together.") != std::string::npos);
}

TEST_CASE("deforming surface: the motion of all vertices is bounded, about its mean and from zero") {
  const Panels panels = fixtures::hull();
  const DeformingSurface surface = moved_surface(panels, deformations()[4], 0.1, 0.2);
  double travel = 0, spread = 0;
  for (const Vec3d& x : panels.vertices) {
    const Vec3d displacement = deformations()[4].at(x, 0.2) - deformations()[4].at(x, 0.1);
    travel = fixtures::larger(travel, norm(displacement));
    spread = fixtures::larger(spread, norm(displacement - surface.mean_displacement()));
  }
  CHECK(surface.travel() == fixtures::relative(travel, 1e-12));
  CHECK(surface.spread() == fixtures::relative(spread, 1e-12));
  CHECK(surface.spread() < 0.8 * surface.travel());
}

TEST_CASE("deforming surface: unusable vertices are refused in a sentence, and nothing changes") {
  const Panels cube = fixtures::unit_cube();
  DeformingSurface surface{Surface(cube)};
  std::vector<Vec3d> to = cube.vertices;
  for (Vec3d& x : to) x *= 1.1;
  surface.move(to);
  const auto refuse = [&](const std::vector<Vec3d>& vertices, const std::string& sentence) {
    const bool is_unstable = sentence.ends_with("the solver has become unstable, use a shorter step.");
    CHECK((is_unstable ? refusal<RunError>(surface, vertices) : refusal(surface, vertices)) == sentence);
    CHECK(surface.steps() == 1);
    CHECK(surface.at_t0().corner(0, 0) == cube.vertices[static_cast<std::size_t>(surface.panel_vertices(0)[0])]);
    CHECK(surface.at_t1().corner(0, 0) == to[static_cast<std::size_t>(surface.panel_vertices(0)[0])]);
  };
  refuse({{0, 0, 0}}, "deforming surface: there are positions of 1 vertices, but its panels have 8; give one for each.");
  std::vector<Vec3d> bad = to;
  bad[7].y = std::numeric_limits<double>::quiet_NaN();
  refuse(bad,
         "deforming surface: vertex 7 goes from (1.1, 1.1, 1.1) to (1.1, nan, 1.1) in one step, which is not finite; the solver has become unstable, use a "
         "shorter step.");
  bad[7].y = std::numeric_limits<double>::infinity();
  refuse(bad,
         "deforming surface: vertex 7 goes from (1.1, 1.1, 1.1) to (1.1, inf, 1.1) in one step, which is not finite; the solver has become unstable, use a "
         "shorter step.");
  bad[7].y = 2e6;
  refuse(bad,
         "deforming surface: vertex 7 goes from (1.1, 1.1, 1.1) to (1.1, 2e+06, 1.1) in one step, farther than 1e+06 m, beyond which rounding hides "
         "contact; the solver has become unstable, use a shorter step.");
  std::vector<Vec3d> inverted = cube.vertices;
  for (Vec3d& x : inverted) x.z = -x.z;
  refuse(inverted, "deforming surface: it is closed, but encloses a volume of -1 m³ at the end of the step: it is turned inside out; use a shorter step.");
  std::vector<Vec3d> flat = cube.vertices;
  flat[1] = flat[0];
  CHECK(refusal(surface, flat).find(" has no area at the end of the step, so it has no side; use a shorter step, or a finer mesh where it is compressed.") !=
        std::string::npos);
  CHECK(surface.steps() == 1);
}

TEST_CASE("deforming surface: a step in which panels overtake their size, turn over or pass through others is accepted, with a sentence about each") {
  const Panels cube = fixtures::unit_cube();
  DeformingSurface moved{Surface(cube)};
  std::vector<Vec3d> to = cube.vertices;
  for (Vec3d& x : to) x += Vec3d{1.4, 0, 0};  // the longest edges of its triangles are diagonals, 1.414
  moved.move(to);
  CHECK(step_warnings(moved).empty());
  for (Vec3d& x : to) x.z -= 2;
  moved.move(to);
  CHECK(step_warnings(moved) ==
        std::vector<std::string>{
            "deforming surface: 6 panels move farther than their longest edge in this step, panel 0 by 1.41421 of it. No contact is missed, but "
            "all that a panel passes in the step is relocated to where it ends; use a shorter step for the forces."});

  DeformingSurface spun{Surface(cube)};
  to = cube.vertices;
  for (Vec3d& x : to) x = Vec3d{1 - x.x, 1 - x.y, x.z};  // half a turn about the axis z: the top and the bottom keep their normals
  spun.move(to);
  CHECK(step_warnings(spun) == std::vector<std::string>{"deforming surface: the normal of 4 panels turns by more than 90° in this step, the first is panel 2. "
                                                        "Vertices move straight within a step, which shrinks what rotates; use a shorter step."});

  // The middle of one side of a box is pushed out through the opposite side, in small steps.
  const Panels box = make_box({.size = {1, 1, 1}, .edge_length = 0.25});
  DeformingSurface pushed{Surface(box)};
  std::vector<Vec3d> vertices = box.vertices;
  for (int step = 0; step < 12; ++step) {
    for (std::size_t v = 0; v < vertices.size(); ++v)
      if (box.vertices[v] == Vec3d{0, 0, 0.5}) vertices[v].z -= 0.12;
    pushed.move(vertices);
    CHECK(step_warnings(pushed).size() == (step < 8 ? 0 : 1));
  }
  CHECK(step_warnings(pushed)[0].find("pass through others at the end of this step, the first is panel ") != std::string::npos);
  CHECK(step_warnings(pushed)[0].ends_with("; stop the structure from passing through itself."));
}

TEST_CASE("deforming surface: closed parts that may overlap are refused") {
  const Panels two = fixtures::joined(fixtures::unit_cube(), fixtures::moved(fixtures::unit_cube(), [](const Vec3d& x) { return x + Vec3d{0.5, 0.3, 0.4}; }));
  CHECK_THROWS_WITH_AS(DeformingSurface{Surface(two)},
                       "deforming surface: 2 of its closed parts may overlap, and the union of parts is evaluated for rigid surfaces only; give each part a "
                       "surface of its own.",
                       InputError);
}

TEST_CASE("deforming surface: a corner on a straight edge of a panel, where a sliver was absorbed, moves with its own vertex") {
  const auto bent = [](const Vec3d& at_rest) { return at_rest + Vec3d{0, 0, 0.1 * at_rest.x * at_rest.x + 0.05 * at_rest.y}; };
  std::vector<Panels> meshes{cube_with_sliver()};
  for (const bool sliver_first : {false, true})
    for (const bool has_lower_half : {false, true}) meshes.push_back(sheet_with_sliver(sliver_first, has_lower_half));
  for (std::size_t k = 0, shared = meshes.size(); k < shared; ++k) meshes.push_back(unshared(meshes[k]));
  for (const Panels& panels : meshes) {
    const Surface at_rest(panels, {.orientation = Orientation::normals});
    REQUIRE(at_rest.report().degenerate == 1);
    DeformingSurface surface(at_rest);
    // The vertices of the panels that are named are those that lie at the corners.
    for (std::size_t t = 0; t < at_rest.triangles().size(); ++t)
      for (std::size_t c = 0; c < 3; ++c) CHECK(panels.vertices[static_cast<std::size_t>(surface.panel_vertices(t)[c])] == at_rest.corner(t, c));
    CHECK(refusal(surface, panels.vertices).empty());
    std::vector<Vec3d> moved;
    for (const Vec3d& vertex : panels.vertices) moved.push_back(bent(vertex));
    CHECK(refusal(surface, moved).empty());
    // exact: the same operations on the same numbers
    for (std::size_t v = 0; v < at_rest.vertices().size(); ++v) CHECK(surface.at_t1().vertices()[v] == bent(at_rest.vertices()[v]));
  }
}
