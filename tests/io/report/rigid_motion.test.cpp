#include "io/report/rigid_motion.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>
#include <vector>

using namespace perimpact::report;
using fccda::Mat3;
using fccda::Vec3d;

namespace {

std::vector<Vec3d> cloud(std::size_t count) {
  std::mt19937 chance(21);
  std::uniform_real_distribution<double> any(-1, 1);
  std::vector<Vec3d> points;
  for (std::size_t i = 0; i < count; ++i) points.push_back({40 + any(chance), 3 * any(chance), 0.2 * any(chance)});
  return points;
}

Mat3 turn(double about_x, double about_z) {
  const Mat3 x{{{1, 0, 0}, {0, std::cos(about_x), -std::sin(about_x)}, {0, std::sin(about_x), std::cos(about_x)}}};
  const Mat3 z{{{std::cos(about_z), -std::sin(about_z), 0}, {std::sin(about_z), std::cos(about_z), 0}, {0, 0, 1}}};
  return x * z;
}

}  // namespace

TEST_CASE("rigid motion: rotations and translations are found, including half a turn") {
  const std::vector<Vec3d> from = cloud(50);
  for (const double angle : {0.0, 1e-7, 0.3, 3.141592653589793, -2.5}) {
    const Mat3 wanted = turn(angle, 2 * angle);
    std::vector<Vec3d> to;
    for (const Vec3d& point : from) to.push_back(wanted * point + Vec3d{5, -80, 0.1});
    const auto found = rigid_motion(from, to, 1e-11);  // coordinates of up to 120, a few roundings of 1e-14 each, and levers of 20
    REQUIRE(found);
    for (std::size_t axis = 0; axis < 3; ++axis) CHECK(fccda::norm(found->turn.row[axis] - wanted.row[axis]) < 1e-13 * 40);  // axes from points that far apart
    CHECK(fccda::norm(found->shift - Vec3d{5, -80, 0.1}) < 1e-11);
  }
}

TEST_CASE("rigid motion: deformed and mirrored points and another number of points give no motion") {
  const std::vector<Vec3d> from = cloud(50);
  std::vector<Vec3d> bent = from, mirrored = from;
  bent[17].z += 1e-6;
  for (Vec3d& point : mirrored) point.z = -point.z;
  CHECK(rigid_motion(from, from, 1e-9));
  CHECK_FALSE(rigid_motion(from, bent, 1e-9));
  CHECK(rigid_motion(from, bent, 1e-5));
  CHECK_FALSE(rigid_motion(from, mirrored, 1e-9));
  CHECK_FALSE(rigid_motion(from, std::vector<Vec3d>(from.begin(), from.end() - 1), 1e-9));
  CHECK_FALSE(rigid_motion({}, {}, 1e-9));
}
