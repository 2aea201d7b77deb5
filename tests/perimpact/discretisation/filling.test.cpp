// Filling: particles of solids on a lattice, against the volumes of the shapes.
#include "perimpact/discretisation/filling.hpp"

#include <doctest/doctest.h>

#include <numbers>
#include <numeric>

#include "fixtures/tolerance.hpp"
#include "perimpact/deck_model/setup_error.hpp"
#include "perimpact/particles/fill.hpp"

using namespace perimpact;

namespace {

BodySetup body_of(BodyShape shape, double spacing) {
  BodySetup body;
  body.name = "ice";
  body.shape = std::move(shape);
  body.spacing = spacing;
  body.position = {0.1, -3, 20};
  return body;
}

SolidSetup named(SolidShape shape, const Vec3d& position = {}, const Vec3d& rotate = {}) { return {"it", std::move(shape), position, rotate}; }

double filled_volume(const BodySetup& body) {
  const BodySolid solid(body);
  const Lattice lattice = lattice_that_fills(body, solid);
  const auto inside = cells_inside(lattice, solid);
  return std::accumulate(inside.begin(), inside.end(), 0.0) * lattice.cell_volume();
}

}  // namespace

TEST_CASE("filling: the volume of particles converges to that of the shape with the spacing") {
  constexpr double pi = std::numbers::pi;
  BodySetup turned_box = body_of(BoxSolid{{1, 0.6, 0.8}}, 0);
  turned_box.rotate = {0.3, 0.2, 0.1};
  BodySetup ring = body_of(CylinderSolid{1, 0.5, {axis_words, 2}}, 0);
  ring.holes = {named(CylinderSolid{0.5, 1, {axis_words, 2}})};
  BodySetup dumbbell = body_of(BoxSolid{{1, 0.2, 0.2}}, 0);
  dumbbell.add = {named(SphereSolid{0.6}, {0.9, 0, 0})};
  // the bar ends inside the ball: at x = 0.5 m, where the ball's cap begins at 0.6 m, they do not meet
  const std::pair<BodySetup, double> bodies[] = {{body_of(SphereSolid{1}, 0), pi / 6},
                                                 {body_of(CylinderSolid{1, 0.7, {axis_words, 1}}, 0), pi / 4 * 0.7},
                                                 {turned_box, 0.48},
                                                 {ring, pi / 4 * 0.5 * 0.75},
                                                 {dumbbell, 0.04 + pi / 6 * 0.216}};
  for (auto [body, volume] : bodies) {
    for (const double spacing : {0.05, 0.02}) {
      body.spacing = spacing;
      // faces are found to half a spacing and err both ways; a tenth of the cells at the surface, of which there are about 6 volume/(size spacing²)
      CHECK(filled_volume(body) == fixtures::relative(volume, 0.1 * 6 * spacing / 0.5));
    }
  }
}

TEST_CASE("filling: a single box gets exactly the lattice of whole spacings, also with holes") {
  BodySetup box = body_of(BoxSolid{{0.2, 0.1, 0.009}}, 0.001);
  for (const bool has_hole : {false, true}) {
    if (has_hole) box.holes = {named(BoxSolid{{0.01, 0.01, 1}})};
    const Lattice lattice = lattice_that_fills(box, BodySolid(box)), expected = lattice_of_box({0.2, 0.1, 0.009}, box.position, 0.001, false);
    CHECK(lattice.cells == expected.cells);
    CHECK(lattice.origin == expected.origin);  // to the last bit: results of such bodies must not change
    const auto inside = cells_inside(lattice, BodySolid(box));
    CHECK(std::accumulate(inside.begin(), inside.end(), 0) == 200 * 100 * 9 - (has_hole ? 10 * 10 * 9 : 0));
  }
}

TEST_CASE("filling: particles on the face of a hole or added solid belong to it, independent of rounding") {
  BodySetup box = body_of(BoxSolid{{0.7, 0.7, 0.7}}, 0.1);  // seven particles along each axis, the fourth in the middle
  box.holes = {named(BoxSolid{{0.2, 0.2, 0.2}})};           // faces through the particles beside that
  CHECK(filled_volume(box) == fixtures::relative(0.001 * (343 - 27), 1e-12));
  box.holes[0].shape = BoxSolid{{0.2, 0.2, 0.1999}};
  CHECK(filled_volume(box) == fixtures::relative(0.001 * (343 - 9), 1e-12));
}

TEST_CASE("filling: an added solid that fits the lattice of the shape continues it") {
  BodySetup beam = body_of(BoxSolid{{1, 0.2, 0.2}}, 0.05);
  beam.add = {named(BoxSolid{{0.2, 0.2, 0.6}}, {0.4, 0, 0.4})};  // a T's web on its end
  CHECK(filled_volume(beam) == fixtures::relative(0.04 + 0.2 * 0.2 * 0.6, 1e-12));
}

TEST_CASE("filling: translation and rotation of a body apply to its added solids and holes") {
  BodySetup one = body_of(SphereSolid{1}, 0.06), other = one;
  one.holes = {named(BoxSolid{{0.5, 0.2, 0.3}}, {0.3, 0.1, 0})};
  other = one;
  other.position = {7, 7, 7}, other.rotate = {0, 0, std::numbers::pi / 2};
  const BodySolid solid(one), moved(other);
  for (const Vec3d& p : {Vec3d{0.3, 0.1, 0}, Vec3d{0.1, 0.15, 0.1}, Vec3d{-0.3, 0.1, 0}, Vec3d{0.1, 0.3, 0}})
    CHECK(solid.contains(one.position + p) == moved.contains(other.position + Vec3d{-p.y, p.x, p.z}));
  CHECK(!solid.contains(one.position + Vec3d{0.3, 0.1, 0}));
}

TEST_CASE("filling: more cells than can be numbered are refused") {
  const BodySetup ball = body_of(SphereSolid{1000}, 0.1);
  CHECK_THROWS_WITH_AS(lattice_that_fills(ball, BodySolid(ball)),
                       "a spacing of 0.1 m requires 1e+12 cells to fill body ice, more than the maximum of 2.1e+09; increase it.", SetupError);
}

TEST_CASE("filling: the volume is known of one solid, and undefined with holes or added solids") {
  BodySetup ball = body_of(SphereSolid{2}, 0.1);
  CHECK(BodySolid(ball).volume().value() == fixtures::relative(4 * std::numbers::pi / 3, 1e-14));
  ball.holes = {named(SphereSolid{1})};
  CHECK(!BodySolid(ball).volume().has_value());
}
