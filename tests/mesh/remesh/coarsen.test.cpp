#include "mesh/remesh/coarsen.hpp"

#include <doctest/doctest.h>

#include "base/parallel.hpp"
#include "fccda/detect/scene.hpp"
#include "fixtures/larger.hpp"
#include "fixtures/threads.hpp"
#include "fixtures/tolerance.hpp"
#include "mesh/remesh/meshes.hpp"

using namespace fccda;
using fixtures::sampled_distance;
using fixtures::surface_from;
using fixtures::Triangle3;
using fixtures::triangles_of;

namespace {

constexpr double any_size = 1e9;  // [m] panels as long as the shape permits
constexpr double flat = 1e-9;     // [m] a distance that only exactly flat surfaces keep

double shape(const Triangle3& t) { return 2 * fixtures::area(t) / std::pow(fixtures::longest_edge(t), 2); }

double worst_shape(const Panels& panels) {
  double worst = 1;
  for (const Triangle3& t : triangles_of(panels)) worst = std::min(worst, shape(t));
  return worst;
}

/// Two parts, by the side of x = at on which the centroid of a panel lies.
Panels in_two_parts(Panels panels, double at) {
  panels.part_names = {"aft", "fore"};
  for (const auto& p : panels.panels) {
    const auto x = [&](std::size_t c) { return panels.vertices[std::size_t(p[c])].x; };
    panels.part.push_back((x(0) + x(1) + x(2)) / 3 > at);
  }
  return panels;
}

/// Panels of one part alone.
Panels part(const Panels& panels, int number) {
  Panels out{panels.vertices, {}, {}, {}};
  for (std::size_t p = 0; p < panels.panels.size(); ++p)
    if (panels.part[p] == number) out.panels.push_back(panels.panels[p]);
  return out;
}

}  // namespace

TEST_CASE("coarsen: a fine cube becomes twelve triangles, with all its corners and its volume") {
  for (const double panel : {0.1, 0.05}) {
    const Coarsened coarse = coarsen(surface_from(make_box({.size = {1, 1, 1}, .edge_length = panel})), {flat, any_size});
    CHECK(coarse.panels.panels.size() == 12);
    CHECK(coarse.panels.vertices.size() == 8);
    CHECK(fixtures::is_watertight(coarse.panels));
    CHECK(coarse.distance < 1e-14);                  // rounding, summed over some twenty collapses
    CHECK(std::fabs(coarse.volume_change) < 1e-12);  // rounding of a sum over some thousand triangles
    CHECK(surface_from(coarse.panels).report().volume == fixtures::relative(1, 1e-15));
  }
}

TEST_CASE("coarsen: no point of either surface lies farther from the other than the distance, by a loop over all triangles") {
  struct Case {
    std::string name;
    Panels panels;
    double distance;
  };
  const std::vector<Case> cases{{"sphere", fixtures::sphere(), 0.03},
                                {"hull", fixtures::hull(), 0.02},
                                {"blade", fixtures::blade(), 0.01},
                                {"torus", fixtures::torus(0.4, 0.15, 24, 12, 1), 0.02},
                                {"cylinder", fixtures::cylinder(), 0.01},
                                {"box", fixtures::box(), 0.05},
                                {"shaken box", fixtures::shaken(make_box({.size = {1, 0.6, 0.4}, .edge_length = 0.1}), 0.005, 3), 0.03}};
  for (const Case& c : cases) {
    CAPTURE(c.name);
    const Surface given = surface_from(c.panels);
    const Coarsened coarse = coarsen(given, {c.distance, any_size});
    const Surface after = surface_from(coarse.panels);
    CHECK(coarse.panels.panels.size() < (c.name == "blade" ? 1.0 : 0.8) * static_cast<double>(given.triangles().size()));
    CHECK(coarse.distance <= c.distance);
    const auto fine = triangles_of(given.panels()), few = triangles_of(coarse.panels);
    // the split of quads matters for warped ones only: the loop uses that of the library
    std::vector<Triangle3> cut;
    for (std::size_t t = 0; t < given.triangles().size(); ++t) cut.push_back({given.corner(t, 0), given.corner(t, 1), given.corner(t, 2)});
    const double there = sampled_distance(cut, few, 3), back = sampled_distance(few, cut, 8);
    constexpr double rounding = 1e-13;
    CHECK(there <= coarse.distance + rounding);
    CHECK(back <= coarse.distance + rounding);
    CHECK(after.is_closed());
    CHECK(fixtures::is_watertight(coarse.panels));
    CHECK(fixtures::euler_characteristic(coarse.panels) == (c.name == "torus" ? 0 : 2));
    CHECK(std::fabs(coarse.volume_change) <= c.distance * given.report().area);
    CHECK(coarse.volume_change == fixtures::absolute(after.report().volume - given.report().volume, 1e-12, "m3"));  // both sums rounded to 1e-14
    CHECK(worst_shape(coarse.panels) >= std::min(0.05, worst_shape(c.panels)) * (1 - 1e-12));
    CHECK(fixtures::self_crossings(few) == 0);
    for (const Vec3d& vertex : coarse.panels.vertices) CHECK(std::count(c.panels.vertices.begin(), c.panels.vertices.end(), vertex) > 0);
  }
}

TEST_CASE("coarsen: no edge becomes longer than requested") {
  for (const double panel : {0.25, 0.4}) {
    const Coarsened coarse = coarsen(surface_from(make_box({.size = {1, 1, 1}, .edge_length = 0.05})), {flat, panel});
    double longest = 0;
    for (const Triangle3& t : triangles_of(coarse.panels)) longest = fixtures::larger(longest, fixtures::longest_edge(t));
    CHECK(longest <= panel);
    CHECK(longest > 0.9 * panel);  // and the limit is nearly reached
    CHECK(coarse.panels.panels.size() < 4800 / 4);
  }
}

TEST_CASE("coarsen: a smaller distance leaves more panels, and one far below the sagitta all of them") {
  const Surface sphere = surface_from(make_sphere({.diameter = 1, .edge_length = 0.05}));
  std::size_t last = 0;
  for (const double distance : {0.1, 0.02, 0.005, 0.001}) {
    const std::size_t count = coarsen(sphere, {distance, any_size}).panels.panels.size();
    CHECK(count > last);
    last = count;
  }
  CHECK(coarsen(sphere, {1e-5, any_size}).panels.panels.size() == sphere.triangles().size());
}

TEST_CASE("coarsen: parts keep their names, and each moves by no more than the distance") {
  const Panels fine = in_two_parts(fixtures::hull(), 0.1);
  const double distance = 0.03;
  const Coarsened coarse = coarsen(surface_from(fine), {distance, any_size});
  CHECK(coarse.panels.part_names == fine.part_names);
  for (const int number : {0, 1}) {
    const auto before = triangles_of(part(fine, number)), after = triangles_of(part(coarse.panels, number));
    CHECK(after.size() < before.size());
    CHECK(sampled_distance(before, after, 3) <= distance);
    CHECK(sampled_distance(after, before, 8) <= distance);
  }
}

TEST_CASE("coarsen: on flat faces parts with straight borders keep their areas") {
  const Panels fine = in_two_parts(make_box({.size = {1, 1, 1}, .edge_length = 0.1}), 0.2);
  const Surface given = surface_from(fine), after = surface_from(coarsen(given, {flat, any_size}).panels);
  CHECK(after.triangles().size() == 20);  // of each half an end of two and four sides of two
  for (const std::size_t k : {0u, 1u}) CHECK(after.report().parts[k].area == fixtures::relative(given.report().parts[k].area, 1e-13));  // rounding
}

TEST_CASE("coarsen: a boundary moves along itself only, and by no more than the distance") {
  const Panels plate = fixtures::askew_plate(20, 1, 2);
  const Coarsened square = coarsen(surface_from(plate), {flat, any_size});
  CHECK(square.panels.panels.size() == 2);
  double area = 0;
  for (const Triangle3& t : triangles_of(square.panels)) area += fixtures::area(t);
  CHECK(area == fixtures::relative(1, 1e-15));

  // the boundary of a round hole, by its own points: the upper half of a sphere
  Panels bowl{make_sphere({.diameter = 1, .edge_length = 0.06}).vertices, {}, {}, {}};
  for (const auto& p : make_sphere({.diameter = 1, .edge_length = 0.06}).panels)
    if (bowl.vertices[std::size_t(p[0])].z + bowl.vertices[std::size_t(p[1])].z + bowl.vertices[std::size_t(p[2])].z > 0) bowl.panels.push_back(p);
  const Surface given = surface_from(bowl);
  const double distance = 0.02;
  const Surface after = surface_from(coarsen(given, {distance, any_size}).panels);
  CHECK(after.report().components == 1);
  CHECK(after.report().boundary_edges < given.report().boundary_edges);
  const auto rim = [](const Surface& surface) {
    std::vector<Triangle3> edges;  // as triangles without area
    for (std::size_t t = 0; t < surface.triangles().size(); ++t)
      for (std::size_t e = 0; e < 3; ++e)
        if (surface.neighbour(t, e) < 0) edges.push_back({surface.corner(t, e), surface.corner(t, (e + 1) % 3), surface.corner(t, e)});
    return edges;
  };
  CHECK(sampled_distance(rim(given), rim(after), 6) <= distance);
  CHECK(sampled_distance(rim(after), rim(given), 12) <= distance);
}

TEST_CASE("coarsen: thin walls do not intersect themselves, although the distance is larger than their thickness") {
  // an arched sheet, with a thickness of a tenth of the distance
  const auto arch = [](const Vec3d& p) { return Vec3d{p.x, p.y, p.z - 0.4 * p.x * p.x + 0.05 * std::sin(8 * p.y)}; };
  const Panels sheet = fixtures::moved(make_box({.size = {1, 1, 0.01}, .edge_length = 0.08}), arch);
  const Coarsened coarse = coarsen(surface_from(sheet), {0.1, any_size});
  CHECK(coarse.panels.panels.size() < 0.9 * static_cast<double>(sheet.panels.size()));
  CHECK(fixtures::self_crossings(triangles_of(coarse.panels)) == 0);
  // a wedge of the same kind, thick at one end
  const Panels wedge = fixtures::moved(make_box({.size = {1, 1, 0.2}, .edge_length = 0.08}), [&](const Vec3d& p) {
    return arch({p.x, p.y, p.z * (0.53 - p.x)});
  });
  const Coarsened sharp = coarsen(surface_from(wedge), {0.1, any_size});
  CHECK(sharp.panels.panels.size() < 0.9 * static_cast<double>(wedge.panels.size()));
  CHECK(fixtures::self_crossings(triangles_of(sharp.panels)) == 0);
  // two spheres, one in the other, with a narrow gap between
  const Panels shell =
      fixtures::joined(make_sphere({.diameter = 1, .edge_length = 0.1}), fixtures::reversed(make_sphere({.diameter = 0.96, .edge_length = 0.13})));
  const Coarsened thin = coarsen(surface_from(shell), {0.1, any_size});
  CHECK(thin.panels.panels.size() < shell.panels.size());
  CHECK(fixtures::self_crossings(triangles_of(thin.panels)) == 0);
  CHECK(surface_from(thin.panels).report().cavities == 1);
}

TEST_CASE("coarsen: parts in contact at single points do not come to share an edge") {
  // the edge from (0, 1, 1) to (1, 1, 1) of a box, and on it that of a tetrahedron, which has a vertex elsewhere than the box has them
  const Vec3d m{0.4, 1, 1}, p{0, 1, 1}, q{1, 1, 1}, r{0.5, 1.3, 1.5}, s{0.5, 0.7, 1.5};
  const Panels tetrahedron{{p, m, q, r, s}, {{0, 3, 1, -1}, {1, 3, 2, -1}, {0, 1, 4, -1}, {1, 2, 4, -1}, {0, 4, 3, -1}, {2, 3, 4, -1}}, {}, {}};
  const Panels box = fixtures::moved(make_box({.size = {1, 1, 1}, .edge_length = 0.25}), [](const Vec3d& x) { return x + Vec3d{0.5, 0.5, 0.5}; });
  const Panels both = fixtures::joined(box, tetrahedron);
  const Surface given(both), after(coarsen(given, {flat, any_size}).panels);
  CHECK(after.report().components == 2);
  CHECK(after.triangles().size() < 30);
  CHECK(after.report().volume == fixtures::relative(given.report().volume, 1e-13));  // rounding
}

TEST_CASE("coarsen: the result is bitwise identical for any number of threads") {
  const Surface hull = surface_from(fixtures::hull());
  const fixtures::Threads with_one(1);
  const Panels alone = coarsen(hull, {0.02, any_size}).panels;
  const fixtures::Threads with_four(4);
  const Panels together = coarsen(hull, {0.02, any_size}).panels;
  CHECK(alone.vertices == together.vertices);
  CHECK(alone.panels == together.panels);
}

TEST_CASE("coarsen: particles contact a coarsened box at the same positions as the fine one") {
  const Panels fine = make_box({.size = {1, 0.6, 0.4}, .edge_length = 0.05});
  const auto before = std::make_shared<const Surface>(fine);
  const auto after = std::make_shared<const Surface>(coarsen(*before, {flat, any_size}).panels);
  REQUIRE(after->triangles().size() == 12);
  std::mt19937_64 random(4);
  std::vector<Path> paths;
  for (int k = 0; k < 3000; ++k)
    paths.push_back({fixtures::random_in_box(random, {-1, -1, -1}, {1, 1, 1}), fixtures::random_in_box(random, {-0.6, -0.4, -0.3}, {0.6, 0.4, 0.3})});
  std::erase_if(paths, [&](const Path& path) { return fixtures::winding_number(fine, path.start) > 0.5; });
  for (const double radius : {0.0, 0.02}) {
    std::erase_if(paths, [&](const Path& path) { return Box{{-0.53, -0.33, -0.23}, {0.53, 0.33, 0.23}}.distance(path.start) == 0; });
    Swept on_fine(before, Unbounded{}, radius), on_coarse(after, Unbounded{}, radius);
    const auto points = fixtures::points_on(paths);
    const auto expected = fixtures::detect(on_fine, points), found = fixtures::detect(on_coarse, points);
    REQUIRE(found.size() == expected.size());
    CHECK(found.size() > 500);
    for (std::size_t k = 0; k < found.size(); ++k) {
      constexpr double rounding = 1e-12;  // [m] the offset of the swept detector, larger than the difference of the positions
      CHECK(found[k].point == expected[k].point);
      CHECK(norm(found[k].relocation - expected[k].relocation) < rounding);
      CHECK(norm(found[k].hit - expected[k].hit) < rounding);
      CHECK(norm(found[k].normal - expected[k].normal) < 1e-9);  // of edges, which lie on other diagonals
    }
  }
}
