/// Cost of a deforming surface beside a rigid one: CSV rows on standard output.
///
///   contact_deforming --panels 2e5
///
///   move        ms per step: the surface takes its new vertices (checks, refitted search tree, bounds)
///   query       ns per point that is evaluated: balls about a panel's size from the surface, a tenth of them in contact; rigid, the same motion
///               of vertices, and vertices that move individually
///
/// One thread, the best of several rounds.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <ctime>
#include <memory>
#include <random>
#include <vector>

#include "base/parallel.hpp"
#include "fccda/deforming/deforming.hpp"
#include "fccda/detect/swept.hpp"
#include "scene.hpp"

namespace {

using namespace fccda;

/// Of the processor, so that other programs on the machine count less.
double seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// The least time of `rounds` calls [s].
template <class Call>
double best(int rounds, const Call& call) {
  double least = 1e300;
  for (int round = 0; round < rounds; ++round) {
    const double begin = seconds();
    call();
    least = std::min(least, seconds() - begin);
  }
  return least;
}

/// Points near the surface, and their paths in a step.
struct Balls {
  std::vector<Vec3d> x0, x1;
  std::size_t size() const { return x0.size(); }
};

Balls near(const Surface& surface, double panel, const Vec3d& drift) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> unit(0, 1);
  std::normal_distribution<double> normal;
  Balls balls;
  for (int k = 0; k < 100000; ++k) {
    const std::size_t t = random() % surface.triangles().size();
    const double v = unit(random), w = unit(random) * (1 - v);
    const Vec3d place = (1 - v - w) * surface.corner(t, 0) + v * surface.corner(t, 1) + w * surface.corner(t, 2);
    balls.x0.push_back(place + panel * (0.5 + 2 * unit(random)) * surface.normal(t));
    balls.x1.push_back(balls.x0.back() + drift + 0.3 * panel * Vec3d{normal(random), normal(random), normal(random)});
  }
  return balls;
}

}  // namespace

int main(int argc, char** argv) {
  double panels = 2e5;
  int rounds = 20;
  CLI::App app("Times contact detection with a deforming surface; prints CSV rows.");
  app.add_option("--panels", panels)->check(CLI::PositiveNumber);
  app.add_option("--rounds", rounds)->check(CLI::PositiveNumber);
  CLI11_PARSE(app, argc, argv);
  use_threads(1);

  const auto rigid = benchmark::hull(panels);
  const double panel = std::sqrt(rigid->report().area / static_cast<double>(rigid->triangles().size()));
  const auto surface = std::make_shared<DeformingSurface>(*rigid);
  const std::vector<Vec3d>& start = rigid->panels().vertices;
  std::vector<Vec3d> vertices = start;
  const auto bend = [&](double amount) {
    for (std::size_t v = 0; v < start.size(); ++v) vertices[v] = start[v] + amount * start[v].x * start[v].x * Vec3d{0, 0, 1};
  };

  fmt::print("what,surface,panels,value,unit,contacts,rebuilds\n");
  const auto row = [&](const char* what, const char* kind, double value, const char* unit, std::size_t contacts) {
    fmt::print("{},{},{},{:.4g},{},{},{}\n", what, kind, rigid->triangles().size(), value, unit, contacts, surface->rebuilds());
  };
  double amount = 0;
  row("move", "bending", 1e3 * best(rounds, [&] { bend(amount += 0.1 * panel), surface->move(vertices); }) - 1e3 * best(rounds, [&] { bend(amount); }), "ms",
      0);

  const Vec3d drift = panel * Vec3d{0.1, -0.2, 0.15};
  const Balls balls = near(*rigid, panel, drift);
  const double radius = 0.5 * panel;
  const auto query = [&](const char* kind, const auto& evaluate) {
    std::size_t contacts = 0;
    std::vector<int> guess(balls.size(), -1);
    Effort effort;
    const double took = best(rounds, [&] {
      contacts = 0;
      for (std::size_t i = 0; i < balls.size(); ++i) contacts += evaluate(Path{balls.x0[i], balls.x1[i]}, guess[i], effort).contact.has_value();
    });
    row("query", kind, 1e9 * took / static_cast<double>(balls.size()), "ns", contacts);
  };
  for (const double ball : {radius, 0.0}) {
    const auto deforming = [&](const char* kind) {
      const MovingPathTest test(*surface);
      query(kind, [&](const Path& path, int& guess, Effort& effort) { return test.evaluate({.path = path, .radius = ball, .offset = 1e-12}, guess, effort); });
    };
    const PathTest test(rigid, Unbounded(), ball);
    const Motion motion{Pose(), Pose(drift), 1};
    const BodyView view(motion, test.size());
    query(ball > 0 ? "rigid balls" : "rigid points", [&](const Path& path, int& guess, Effort& effort) {
      return test.evaluate({.path = view.path(path.start, path.end), .radius = ball, .offset = 1e-12}, guess, effort);
    });
    surface->move(start);
    for (std::size_t v = 0; v < start.size(); ++v) vertices[v] = start[v] + drift;
    surface->move(vertices);
    deforming(ball > 0 ? "balls at vertices moved rigidly" : "points at vertices moved rigidly");
    std::mt19937_64 random(2);
    std::uniform_real_distribution<double> unit(-1, 1);
    for (Vec3d& vertex : vertices) vertex += 0.1 * panel * Vec3d{unit(random), unit(random), unit(random)};
    surface->move(start);
    surface->move(vertices);
    deforming(ball > 0 ? "balls at vertices moved individually" : "points at vertices moved individually");
  }
  return 0;
}
