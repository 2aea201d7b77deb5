#include "fccda/contact_bounds/box_union.hpp"

#include <doctest/doctest.h>

#include <limits>

#include "base/error.hpp"
#include "fccda/contact_bounds/scenes.hpp"
#include "fixtures/tolerance.hpp"

using namespace fccda;

namespace {

std::string complaint(std::span<const BoxUnion::Shape> shapes, const Surface& surface, Beyond beyond = Beyond::error) {
  try {
    BoxUnion(shapes, surface, beyond);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("box union: far paths are rejected, and the distance is that from the nearest box") {
  const Surface cube(fixtures::unit_cube());
  const BoxUnion box({.size = {1, 1, 1}, .centre = {0.5, 0.5, 0.5}}, cube, Beyond::error);
  CHECK_FALSE(box.may_contact({{1.2, 0, 0}, {1.11, 0, 0}}, 0.1));
  CHECK(box.may_contact({{1.2, 0, 0}, {1.09, 0, 0}}, 0.1));
  CHECK(box.distance_at_least({4, 5, 0.5}) == fixtures::relative(5, 1e-7));  // 3-4-5, the box widened by 1e-8
  CHECK(box.distance_at_least({0.5, 0.5, 0.5}) == 0);

  // between two boxes, inside the bounds of both
  const BoxUnion ends(std::vector<Box>{{{0, 0, 0}, {1, 1, 1}}, {{3, 0, 0}, {4, 1, 1}}});
  CHECK_FALSE(ends.may_contact({{2, 0.5, 0.5}, {2.1, 0.5, 0.5}}, 0.8));
  CHECK(ends.may_contact({{2, 0.5, 0.5}, {2.1, 0.5, 0.5}}, 0.95));
  CHECK(ends.distance_at_least({2.25, 0.5, 0.5}) == 0.75);
  CHECK_FALSE(ends.contains({2, 0.5, 0.5}));
  CHECK(ends.contains({3, 0, 1}));
}

TEST_CASE("box union: a surface that fits exactly is not clipped, one that extends beyond is an error with the panel numbers, unless clipping is requested") {
  const Surface cube(fixtures::unit_cube());
  CHECK_FALSE(BoxUnion({.size = {1, 1, 1}, .centre = {0.5, 0.5, 0.5}}, cube, Beyond::clip).clips());
  const BoxUnion::Shape thin{.size = {1, 1, 0.9}, .centre = {0.5, 0.5, 0.5}};
  CHECK(BoxUnion(thin, cube, Beyond::clip).clips());
  CHECK(complaint(std::span(&thin, 1), cube) ==
        "contact bounds: 6 of 6 panels extend beyond the box by up to 0.05 m (panels 0, 1, 2, 3, 4, ...), and contact there would be missed; enlarge the box, "
        "or pass "
        "Beyond::clip if this is intended.");
}

TEST_CASE("box union: a panel partly in one box and partly in the next is inside, and a gap between them is not") {
  const Surface cube(fixtures::unit_cube());
  const auto halves = [](double gap) {
    return std::vector<BoxUnion::Shape>{{{0.3, 1, 1}, {0.15, 0.5, 0.5}}, {{0.7 - gap, 1, 1}, {0.65 + 0.5 * gap, 0.5, 0.5}}};
  };
  CHECK(complaint(halves(0), cube) == "");
  CHECK_FALSE(BoxUnion(halves(0), cube, Beyond::clip).clips());
  // The four panels that span the gap, with all corners in boxes; its middle is half as far from both.
  CHECK(complaint(halves(0.02), cube) ==
        "contact bounds: 4 of 6 panels extend beyond the boxes by up to 0.01 m (panels 0, 1, 2, 3), and contact there would be missed; enlarge them, or add a "
        "box, or "
        "pass "
        "Beyond::clip if this is intended.");
  CHECK(BoxUnion(halves(0.02), cube, Beyond::clip).clips());
}

TEST_CASE("box union: four boxes that leave a hole in the middle of a panel do not contain it, in any order") {
  const Surface cube(fixtures::unit_cube());
  // around a hole of a tenth in y and z, through the cube along x
  std::vector<BoxUnion::Shape> boxes = {
      {{1, 0.45, 1}, {0.5, 0.225, 0.5}}, {{1, 0.45, 1}, {0.5, 0.775, 0.5}}, {{1, 0.1, 0.45}, {0.5, 0.5, 0.225}}, {{1, 0.1, 0.45}, {0.5, 0.5, 0.775}}};
  for (int turn = 0; turn < 4; ++turn) {
    std::rotate(boxes.begin(), boxes.begin() + 1, boxes.end());
    CHECK(complaint(boxes, cube).starts_with("contact bounds: 2 of 6 panels extend beyond the boxes by up to 0.03333 m (panels 4, 5)"));
  }
  boxes.push_back({{0.2, 0.1, 0.1}, {0.1, 0.5, 0.5}});  // a plug at one end
  CHECK(complaint(boxes, cube).starts_with("contact bounds: 1 of 6 panels extend beyond the boxes by up to 0.03333 m (panels 5)"));
}

TEST_CASE("box union: a box without any of the surface is an error even with clipping") {
  const Surface cube(fixtures::unit_cube());
  const BoxUnion::Shape shapes[] = {{{1, 1, 1}, {0.5, 0.5, 0.5}}, {{1, 1, 1}, {5, 0, 0}}};
  CHECK(complaint(std::span(shapes).subspan(1), cube, Beyond::clip) ==
        "contact bounds: no panel of the surface reaches into the box, so no contact is possible there; check the box's centre and size.");
  CHECK(complaint(shapes, cube, Beyond::clip) ==
        "contact bounds: no panel of the surface reaches into box 2 of 2, so no contact is possible there; check the box's centre and size.");
  // A box within the cube reaches no panel; one that contains only a panel of another box does.
  const BoxUnion::Shape deep[] = {{{0.5, 0.5, 0.5}, {0.5, 0.5, 0.5}}}, inner[] = {{{1, 1, 1}, {0.5, 0.5, 0.5}}, {{0.2, 0.2, 0.2}, {0.5, 0.5, 1}}};
  CHECK(complaint(deep, cube, Beyond::clip) != "");
  CHECK(complaint(inner, cube) == "");
}

TEST_CASE("box union: the shared volume of boxes counts once") {
  CHECK(BoxUnion(std::vector<Box>{{{0, 0, 0}, {2, 1, 1}}}).volume() == 2);
  CHECK(BoxUnion(std::vector<Box>{{{0, 0, 0}, {2, 1, 1}}, {{1, 0, 0}, {3, 1, 1}}}).volume() == 3);
  CHECK(BoxUnion(std::vector<Box>{{{0, 0, 0}, {2, 2, 2}}, {{1, 1, 1}, {3, 3, 3}}, {{1, 1, 1}, {2, 2, 2}}}).volume() == 15);
  // Against counting random points; 0.0055 is four times the spread of 40 000 of them where an eighth is inside.
  std::mt19937_64 random(8);
  std::vector<Box> boxes;
  for (int k = 0; k < 6; ++k) {
    const Vec3d low = fixtures::random_in_box(random, {0, 0, 0}, {0.6, 0.6, 0.6});
    boxes.push_back({low, low + fixtures::random_in_box(random, {0.1, 0.1, 0.1}, {0.4, 0.4, 0.4})});
  }
  const BoxUnion several(boxes);
  int inside = 0;
  for (int k = 0; k < 40'000; ++k) inside += several.contains(fixtures::random_in_box(random, {0, 0, 0}, {1, 1, 1})) ? 1 : 0;
  CHECK(std::fabs(inside / 40'000.0 - several.volume()) < 0.0055);
}

TEST_CASE("box union: a size or a centre that is not finite, an edge length that is not positive, and no box at all are refused in a sentence") {
  const Surface cube(fixtures::unit_cube());
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();
  for (const Beyond beyond : {Beyond::clip, Beyond::error}) {
    for (const Vec3d& size : {Vec3d{nan, 2, 2}, Vec3d{2, infinite, 2}, Vec3d{2, 2, -2}, Vec3d{2, 0, 2}}) {
      const BoxUnion::Shape boxes[] = {{.size = {3, 3, 3}}, {.size = size}};
      CHECK(complaint(boxes, cube, beyond).starts_with("contact bounds: the size of box 2 of 2 is ("));
      CHECK(complaint(boxes, cube, beyond).ends_with(") m, but its three edge lengths must be finite and positive; correct it."));
    }
    for (const Vec3d& centre : {Vec3d{nan, 0, 0}, Vec3d{0, -infinite, 0}}) {
      const BoxUnion::Shape box{.size = {3, 3, 3}, .centre = centre};
      CHECK(complaint(std::span(&box, 1), cube, beyond).starts_with("contact bounds: the centre of the box is ("));
      CHECK(complaint(std::span(&box, 1), cube, beyond).ends_with("), but it must be finite."));
    }
    CHECK(complaint({}, cube, beyond) == "contact bounds: no boxes are given; give one at least.");
  }
}
