#include "fccda/deforming/moving_triangle.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <optional>
#include <random>
#include <vector>

#include "fccda/deforming/exact_crossing.hpp"
#include "fccda/detect/scene.hpp"
#include "fixtures/larger.hpp"
#include "fixtures/tolerance.hpp"

using namespace fccda;

namespace {

struct Scene {
  Path point;
  MovingTriangle triangle;
};

/// Coordinates that are integers from -reach to reach.
Scene integer_scene(std::mt19937_64& random, int reach) {
  std::uniform_int_distribution<int> coordinate(-reach, reach);
  const auto place = [&] { return Vec3d{double(coordinate(random)), double(coordinate(random)), double(coordinate(random))}; };
  return {{place(), place()}, {{place(), place(), place()}, {place(), place(), place()}}};
}

Scene reversed(const Scene& scene) {
  const Corners &s = scene.triangle.t0, &t = scene.triangle.t1;
  return {scene.point, {{s.a, s.c, s.b}, {t.a, t.c, t.b}}};
}

/// A smooth motion of a triangle about a unit in size: stretched, bent, turned and displaced by up to `step`.
Scene smooth_scene(std::mt19937_64& random, double step) {
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto place = [&] { return Vec3d{unit(random), unit(random), unit(random)}; };
  const Corners t0{place(), place(), place()};
  const auto moved = [&](const Vec3d& x) { return x + step * place(); };
  const Corners t1{moved(t0.a), moved(t0.b), moved(t0.c)};
  const Vec3d start = place();
  return {{start, start + 2 * step * place()}, {t0, t1}};
}

/// The distance between point and triangle during the step.
class Clearance {
 public:
  explicit Clearance(const Scene& scene) : scene_(scene) {
    const Corners &s = scene.triangle.t0, &t = scene.triangle.t1;
    const Vec3d way = scene.point.end - scene.point.start;
    speed_ = std::max({norm(way - (t.a - s.a)), norm(way - (t.b - s.b)), norm(way - (t.c - s.c))});
  }

  double distance(double t) const {
    const Corners c = scene_.triangle.at(t);
    return fixtures::Soup::distance(scene_.point.at(t), {c.a, c.b, c.c});
  }

  /// The first time at which the distance is at most `limit`: where it cannot be, a span is skipped, else halved.
  std::optional<double> first_below(double limit) const {
    std::vector<std::pair<double, double>> spans{{0, 1}};
    while (!spans.empty()) {
      const auto [begin, end] = spans.back();
      spans.pop_back();
      const double middle = 0.5 * (begin + end);
      if (distance(middle) - 0.5 * (end - begin) * speed_ > limit) continue;
      if (end - begin < 1e-10) return middle;
      spans.push_back({middle, end}), spans.push_back({begin, middle});
    }
    return std::nullopt;
  }

 private:
  Scene scene_;
  double speed_;
};

}  // namespace

TEST_CASE("moving triangle: crossings on lattices of integers are those of exact arithmetic") {
  // Small integers make degenerate cases frequent: starts on the plane, paths through edges and vertices, double roots, collapsed triangles.
  std::mt19937_64 random(1);
  std::size_t crossings = 0, degenerate = 0, missed = 0, invented = 0;
  for (int k = 0; k < 60000; ++k) {
    const Scene scene = integer_scene(random, k % 3 == 0 ? 1 : k % 3 == 1 ? 3 : 100);
    const exact::Answer answer = exact::front_crossing(scene.point, scene.triangle);
    const bool found = front_crossing(scene.point, scene.triangle).has_value();
    crossings += answer.crosses, degenerate += answer.crosses && answer.margin < 1e-12;
    missed += answer.crosses && !found;
    invented += !answer.crosses && found;
  }
  CHECK(crossings > 2000);
  CHECK(degenerate > 500);
  CHECK(missed == 0);
  CHECK(invented == 0);
}

TEST_CASE("moving triangle: of random motions no crossing is missed, none is invented, and its time is that of exact arithmetic") {
  std::mt19937_64 random(2);
  std::size_t crossings = 0, missed = 0, invented = 0;
  double worst = 0;
  for (int k = 0; k < 100000; ++k) {
    const Scene scene = smooth_scene(random, k % 2 == 0 ? 0.1 : 1);
    const exact::Answer answer = exact::front_crossing(scene.point, scene.triangle);
    if (answer.margin < 1e-12) continue;  // undecided in double precision
    const std::optional<double> found = front_crossing(scene.point, scene.triangle);
    crossings += answer.crosses;
    missed += answer.crosses && !found;
    invented += !answer.crosses && found;
    if (answer.crosses && found) worst = fixtures::larger(worst, std::fabs(*found - answer.time));
  }
  CHECK(crossings > 1000);
  CHECK(missed == 0);
  CHECK(invented == 0);
  // near a double root the time is determined to the square root of rounding
  CHECK(worst < 1e-7);
}

TEST_CASE("moving triangle: a path from the front is a path from behind of the reversed triangle") {
  std::mt19937_64 random(3);
  std::size_t both = 0, once = 0;
  for (int k = 0; k < 60000; ++k) {
    const Scene scene = smooth_scene(random, 0.1);
    const bool front = front_crossing(scene.point, scene.triangle).has_value();
    const Scene other = reversed(scene);
    const bool back = front_crossing(other.point, other.triangle).has_value();
    both += front && back, once += front != back;
  }
  CHECK(once > 300);
  CHECK(both < once / 20);  // only a surface that overtakes the point and is overtaken
}

TEST_CASE("moving triangle: a path through an edge or vertex of a moving cap crosses one of its triangles") {
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> unit(0, 1);
  constexpr int sides = 6;
  std::size_t missed = 0;
  for (int k = 0; k < 20000; ++k) {
    // A cone with its tip up, that is moved, turned over and stretched. Six triangles face outward.
    std::array<Vec3d, sides + 1> from, to;
    const double scale = std::pow(10, 6 * unit(random) - 3), turn = unit(random);
    const Vec3d shift = scale * Vec3d{unit(random), unit(random), unit(random)};
    for (int v = 0; v <= sides; ++v) {
      const double angle = 2 * 3.14159265358979 * v / sides;
      const Vec3d x = v == sides ? Vec3d{0, 0, 0.3} : Vec3d{std::cos(angle), std::sin(angle), 0.1 * unit(random)};
      from[static_cast<std::size_t>(v)] = scale * x;
      to[static_cast<std::size_t>(v)] = shift + scale * Vec3d{x.x - turn * x.z, 1.3 * x.y, x.z + turn * x.x};
    }
    // The place that is met, at a random time: the tip, or a place of an edge that ends there.
    const std::size_t spoke = static_cast<std::size_t>(random() % sides);
    const double along = k % 3 == 0 ? 0 : unit(random), time = unit(random);
    const auto place = [&](const auto& x) { return x[sides] + along * (x[spoke] - x[sides]); };
    const Vec3d met = (1 - time) * place(from) + time * place(to);
    // Relative to that place the point moves straight down, from a little to as far as the cone is high.
    const Vec3d down = scale * (0.01 + unit(random)) * Vec3d{0.1 * unit(random), 0.1 * unit(random), -0.2};
    const Vec3d drift = place(to) - place(from);
    const Path path{met - time * (drift + down), met + (1 - time) * (drift + down)};
    bool found = false;
    for (std::size_t v = 0; v < sides; ++v) {
      const std::size_t next = (v + 1) % sides;
      found |= front_crossing(path, {{from[sides], from[v], from[next]}, {to[sides], to[v], to[next]}}).has_value();
    }
    missed += !found;
  }
  CHECK(missed == 0);
}

TEST_CASE("moving triangle: a point in its plane within rounding is not in contact, beside it neither") {
  const MovingTriangle still{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
  CHECK_FALSE(front_crossing({{-1, 0.2, 0}, {1, 0.2, 0}}, still).has_value());
  CHECK_FALSE(front_crossing({{-1, 1e-12, 0}, {1, 1e-12, -1e-17}}, still).has_value());
  CHECK_FALSE(front_crossing({{0, -1e-12, 0}, {1, -1e-12, -1e-3}}, still).has_value());
  CHECK(front_crossing({{0.2, 0.2, 0}, {0.2, 0.2, -1e-12}}, still).has_value());  // a start on the plane counts as in front
  CHECK_FALSE(front_crossing({{0.2, 0.2, -1e-12}, {0.2, 0.2, -1}}, still).has_value());
}

TEST_CASE("moving triangle: a ball makes contact when its distance, by subdivision, falls to the radius") {
  std::mt19937_64 random(5);
  constexpr double radius = 0.2, tolerance = 1e-13;
  std::size_t contacts = 0, missed = 0, invented = 0;
  double worst = 0;
  for (int k = 0; k < 4000; ++k) {
    const Scene scene = smooth_scene(random, k % 2 == 0 ? 0.1 : 1);
    const Clearance clearance(scene);
    if (clearance.distance(0) < radius + 1e-9) continue;
    const std::optional<double> surely = clearance.first_below(radius - 1e-9), possibly = clearance.first_below(radius + 1e-9);
    const std::optional<double> found = first_contact(scene.point, scene.triangle, radius, tolerance, 1);
    contacts += surely.has_value();
    missed += surely && !found;
    invented += !possibly && found;
    if (!found || !possibly) continue;
    worst = fixtures::larger(worst, std::fabs(clearance.distance(*found) - radius));
    CHECK(*found >= *possibly - 1e-9);
    if (surely) CHECK(*found <= *surely + 1e-9);
  }
  CHECK(contacts > 200);
  CHECK(missed == 0);
  CHECK(invented == 0);
  CHECK(worst < 1e-12);
}

TEST_CASE("moving triangle: a small ball that comes along with a triangle that turns makes contact only where its distance falls to the radius") {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> unit(0, 1);
  constexpr double radius = 1e-3;
  std::size_t clear = 0, contacts = 0;
  for (int k = 0; k < 400; ++k) {
    Scene scene = smooth_scene(random, 0.2);
    // Beside the face, an edge or a corner, by up to 3 % of the radius at both ends.
    const auto beside = [&](const Corners& t) {
      const Vec3d normal = normalised(cross(t.b - t.a, t.c - t.a)), edge = normalised(t.b - t.a);
      const double share = 0.1 + 0.8 * unit(random), way = radius * (1 + 0.03 * unit(random));
      if (k % 3 == 0) return (t.a + t.b + t.c) / 3 + 0.1 * share * (t.b - t.a) + way * normal;
      if (k % 3 == 1) return t.a + share * (t.b - t.a) + way * normalised(normal + 0.1 * cross(edge, normal));
      return t.a + way * normalised(normal - 0.1 * (t.b - t.a) - 0.1 * (t.c - t.a));
    };
    scene.point = {beside(scene.triangle.t0), beside(scene.triangle.t1)};
    const Clearance clearance(scene);
    if (clearance.distance(0) < radius * (1 + 1e-3)) continue;
    const bool found = first_contact(scene.point, scene.triangle, radius, 1e-15, 1).has_value();
    const bool surely = clearance.first_below(radius * (1 - 1e-3)).has_value(), possibly = clearance.first_below(radius * (1 + 1e-3)).has_value();
    clear += !possibly, contacts += surely;
    CHECK((found || !surely));
    CHECK((!found || possibly));
  }
  CHECK(clear > 30);
  CHECK(contacts > 30);
}

TEST_CASE("moving triangle: a ball in contact at the start counts only if it moves farther in") {
  const MovingTriangle sinking{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 0, -1}, {1, 0, -1}, {0, 1, -1}}};
  const Vec3d above{0.2, 0.2, 0.1};
  CHECK_FALSE(first_contact({above, above}, sinking, 0.1, 1e-13, 1).has_value());
  CHECK_FALSE(first_contact({above, above - Vec3d{0, 0, 0.999}}, sinking, 0.1, 1e-13, 1).has_value());
  CHECK(first_contact({above, above - Vec3d{0, 0, 1.01}}, sinking, 0.1, 1e-13, 1).has_value());
  // One corner comes back up before the end of the step, by a turn of the triangle about its far edge.
  const MovingTriangle turning{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 0, 1}, {1, 0, -1}, {0, 1, -1}}};
  CHECK(first_contact({{0.6, 0.3, 0.1}, {0.1, 0.1, 0.1}}, turning, 0.1, 1e-13, 1).has_value());
}

TEST_CASE("moving triangle: barycentric coordinates give the closest point back") {
  std::mt19937_64 random(6);
  for (int k = 0; k < 2000; ++k) {
    const Scene scene = smooth_scene(random, 0);
    const Corners& t = scene.triangle.t0;
    const std::array<double, 3> w = barycentric(t, scene.point.start);
    CHECK(std::min({w[0], w[1], w[2]}) >= 0);
    CHECK(w[0] + w[1] + w[2] == fixtures::relative(1, 1e-14));
    const Vec3d place = w[0] * t.a + w[1] * t.b + w[2] * t.c;
    CHECK(norm(scene.point.start - place) == fixtures::relative(fixtures::Soup::distance(scene.point.start, {t.a, t.b, t.c}), 1e-9));
  }
}
