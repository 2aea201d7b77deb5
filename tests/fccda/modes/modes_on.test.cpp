#include "fccda/modes/modes_on.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "base/error.hpp"
#include "fixtures/tolerance.hpp"
#include "mesh/shapes/box.hpp"

using namespace fccda;

namespace {

Panels panel() { return make_box({.size = {1, 0.5, 0.1}, .edge_length = 0.1}); }

Vec3d bending(const Vec3d& X) { return {0.1 * X.z * X.x, 0, X.x * X.x}; }
Vec3d twist(const Vec3d& X) { return {0, -X.z * X.x, X.y * X.x}; }
SymmetricTensor stress(const Vec3d& X) { return {X.x, X.y, X.z, 1, 2, 3}; }

/// Two modes on these points.
ModesFile file_on(std::vector<Vec3d> points) {
  ModesFile file{"panel.vtu", std::move(points), {{.angular_frequency = 100, .damping_ratio = 0.02}, {.angular_frequency = 200}}};
  for (const Vec3d& X : file.points) {
    file.modes[0].shape.push_back(bending(X));
    file.modes[1].shape.push_back(twist(X));
    for (Mode& mode : file.modes) mode.stress.push_back(stress(X));
  }
  return file;
}

std::string refusal(const Panels& panels, const ModesFile& file) {
  try {
    modes_on(panels, file);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("modes on: each vertex has the values of the point at its place, for points in any order, rounded to single precision, and others beside") {
  const Panels panels = panel();
  std::vector<Vec3d> points = panels.vertices;
  std::mt19937 random(3);
  std::shuffle(points.begin(), points.end(), random);
  points.insert(points.begin() + 5, {0.01, 0.02, 0.03});  // within the solid
  for (Vec3d& point : points)
    for (std::size_t axis = 0; axis < 3; ++axis) point[axis] = static_cast<float>(point[axis]);
  const Modes modes = modes_on(panels, file_on(points));
  REQUIRE(modes.size() == 2);
  CHECK(modes[0].angular_frequency == 100);
  CHECK(modes[0].damping_ratio == 0.02);
  REQUIRE(modes[1].shape.size() == panels.vertices.size());
  constexpr double single = 1e-6;  // coordinates of at most 0.5 in single precision, and products of them
  for (std::size_t v = 0; v < panels.vertices.size(); ++v) {
    const Vec3d& X = panels.vertices[v];
    CHECK(norm(modes[0].shape[v] - bending(X)) == fixtures::absolute(0, single, "1/sqrt(kg)"));
    CHECK(norm(modes[1].shape[v] - twist(X)) == fixtures::absolute(0, single, "1/sqrt(kg)"));
    CHECK(modes[1].stress[v][1] == fixtures::absolute(X.y, single, "Pa/(m sqrt(kg))"));
  }
}

TEST_CASE("modes on: the first vertex without a point is refused, with the nearest point and, where sizes differ, both sizes") {
  Panels panels = panel();
  const ModesFile file = file_on(panels.vertices);
  panels.vertices[7].y += 0.01;
  panels.vertices[9].y += 0.01;
  const std::string sentence = refusal(panels, file);
  CHECK(sentence.starts_with("panel.vtu: vertex 7 of the surface (counted from 0), at ("));
  CHECK(sentence.ends_with("0.01 m away. Make surface and modes from the same mesh, in the same axes."));

  std::vector<Vec3d> millimetres = panel().vertices;
  for (Vec3d& point : millimetres) point = 1000 * point;
  CHECK(refusal(panel(), file_on(millimetres))
            .ends_with("The points extend over 1122.5 m, the surface over 1.1225 m: convert the file to metres, or give the surface its scale."));
}

TEST_CASE("modes on: a vertex that no panel uses needs no point and does not move") {
  Panels panels = panel();
  const ModesFile file = file_on(panels.vertices);
  panels.vertices.push_back({0.2, 0.2, 0.2});
  const Modes modes = modes_on(panels, file);
  CHECK(modes[0].shape.back() == Vec3d{});
  CHECK(modes[0].stress.back() == SymmetricTensor{});
}

TEST_CASE("modes on: points at one place may repeat each other, but not move apart") {
  std::vector<Vec3d> points = panel().vertices;
  points.push_back(points[3]);
  ModesFile file = file_on(points);
  CHECK(refusal(panel(), file) == "");
  file.modes[1].shape.back().x += 0.1;
  const std::string sentence = refusal(panel(), file);
  CHECK(sentence.starts_with("panel.vtu: points 3 and " + std::to_string(points.size() - 1) + " (counted from 0) are both at vertex 3 of the surface, at ("));
  CHECK(sentence.ends_with(" m, but mode_2 moves them differently; connect the parts of the model there, or export one of them."));
}

TEST_CASE("modes on: modes that repeat others, or do not move the surface, are refused") {
  ModesFile file = file_on(panel().vertices);
  file.modes.push_back(file.modes[0]);
  for (std::size_t v = 0; v < file.points.size(); ++v) file.modes[2].shape[v] = 2.0 * file.modes[0].shape[v] - 3.0 * file.modes[1].shape[v];
  CHECK(refusal(panel(), file) == "panel.vtu: on the surface mode_3 is a linear combination of the modes before it; remove the repeated mode.");
  file.modes[2].shape[4].y += 1e-3;
  CHECK(refusal(panel(), file) == "");
  std::fill(file.modes[1].shape.begin(), file.modes[1].shape.end(), Vec3d{});
  CHECK(refusal(panel(), file) == "panel.vtu: mode_2 does not move the surface; remove the mode.");
}
