// Points that are kept elsewhere: detectors read those that they have fetched (fccda/detect/points.hpp).
#include <doctest/doctest.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <memory>
#include <random>
#include <span>
#include <vector>

#include "fccda/deforming/deforming.hpp"
#include "fccda/detect/analytic.hpp"
#include "fccda/detect/published.hpp"
#include "fccda/detect/scene.hpp"

using namespace fccda;
using fixtures::TestPoints;

namespace {

/// Test points that count what is read without having been fetched in this step.
struct Remote : TestPoints {
  mutable std::vector<std::uint8_t> here;
  mutable std::size_t fetched = 0;            // in this step
  mutable std::atomic<std::size_t> stale{0};  // reads, in all steps

  bool is_remote() const { return true; }
  void fetch(std::span<const std::size_t> which) const {
    CHECK(std::is_sorted(which.begin(), which.end()));
    for (const std::size_t i : which) fetched += here[i] == 0 ? 1 : 0, here[i] = 1;
  }
  Vec3d position_t0(std::size_t i) const { return stale += here[i] == 0 ? 1 : 0, x0[i]; }
  Vec3d position_t1(std::size_t i) const { return stale += here[i] == 0 ? 1 : 0, x1[i]; }

  void step(std::mt19937_64& random) {
    std::uniform_real_distribution<double> way(-0.002, 0.002);
    x0 = x1;
    for (Vec3d& x : x1) x += Vec3d{way(random), way(random), way(random)};
    here.assign(size(), 0);
    fetched = 0;
  }
};

std::unique_ptr<Remote> points_in_box(std::mt19937_64& random) {
  std::uniform_real_distribution<double> place(-1, 1);
  auto points = std::make_unique<Remote>();
  for (int i = 0; i < 3000; ++i) points->x1.push_back({place(random), place(random), place(random)});
  std::sort(points->x1.begin(), points->x1.end(), [](const Vec3d& a, const Vec3d& b) { return a.z < b.z; });  // blocks are layers
  return points;
}

/// What was fetched in a step by detection, and by all of it.
struct Fetched {
  std::size_t first, all;
};

/// Detects contact in some steps in which the surface moves farther than at first assumed; detect() and redetect() move it to that z. Returns what was
/// fetched in the last.
template <class Detect, class Redetect>
Fetched detect_in_steps(const Detect& detect, const Redetect& redetect) {
  std::mt19937_64 random(11);
  const std::unique_ptr<Remote> points = points_in_box(random);
  Fetched fetched{};
  double z = 0;
  for (int step = 0; step < 5; ++step) {
    points->step(random);
    detect(*points, z, z + 0.01);
    fetched.first = points->fetched;
    redetect(*points, z, z + 0.02, 0.01);
    fetched.all = points->fetched;
    CHECK(points->stale.load() == 0);
    z += 0.02;
  }
  return fetched;
}

template <class Detector>
Fetched detect_in_steps(Detector detector) {
  std::vector<Contact> contacts;
  const auto motion = [](double from, double to) { return Motion{Pose({0, 0, from}), Pose({0, 0, to}), 1}; };
  return detect_in_steps(
      [&](const Remote& points, double from, double to) { detector.detect(points, motion(from, to), to - from, contacts); },
      [&](const Remote& points, double from, double to, double correction) { detector.redetect(points, motion(from, to), to - from, correction, contacts); });
}

}  // namespace

TEST_CASE("remote points: every detector reads only points that it has fetched, also when it repeats a step, and those that skip points fetch few") {
  const Panels panels = make_sphere({.diameter = 0.6, .edge_length = 0.1});
  const auto surface = std::make_shared<const Surface>(panels);
  const auto deforming = std::make_shared<DeformingSurface>(Surface(panels));
  const auto moved = [&](double z) {
    std::vector<Vec3d> vertices = panels.vertices;
    for (Vec3d& x : vertices) x.z += z;
    return vertices;
  };
  Deforming detector(deforming, 0.01);
  std::vector<DeformingContact> contacts;
  const Fetched of_deforming = detect_in_steps(
      [&](const Remote& points, double, double to) {
        deforming->move(moved(to));
        detector.detect(points, contacts);
      },
      [&](const Remote& points, double, double to, double) { detector.redetect(points, deforming->move_again(moved(to)), contacts); });
  for (const Fetched& fetched : {detect_in_steps(Swept(surface, Unbounded{}, 0.01)), of_deforming}) {
    CHECK(fetched.first > 0);
    CHECK(fetched.all > fetched.first);
    CHECK(fetched.all < 1500);
  }
  CHECK(detect_in_steps(Analytic(Sphere{.radius = 0.3}, Unbounded{}, 0.01)).first == 3000);
  CHECK(detect_in_steps(Published(surface, Unbounded{}, Published::Variant::corrected)).first == 3000);
}
