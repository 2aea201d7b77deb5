/// Cost of one crossing with its relocation: CSV rows on standard output.
///
///   crossing_cost --panels 2e5
///
/// Points and balls outside of a hull whose path in one step leads through its surface: all of them are in contact and relocated. They come in
/// random order, so hardly any panel is in a processor cache. `radius`, `path`: in panel sizes. The guess is the triangle closest to the start of the
/// path, as after the step before. With --in-order they come in the order of the triangles, as the blocks of a body do. ns per crossing; one thread, the best
/// of several rounds. `triangles`: evaluated per crossing. `hash`: of all bits of all contacts, to compare two builds on one machine.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <bit>
#include <cstdint>
#include <ctime>
#include <initializer_list>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "base/parallel.hpp"
#include "fccda/deforming/deforming.hpp"
#include "fccda/detect/swept.hpp"
#include "scene.hpp"

namespace {

using namespace fccda;

constexpr int crossings = 20000;

/// Of the processor, so that other programs on the machine count less.
double seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// Paths from just outside a ball's contact radius to inside, `length` [m] each, at up to 60° from the normal.
std::vector<Path> paths_into(const PathTest& test, double length, bool in_order) {
  const Surface& surface = test.surface();
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> unit(0, 1);
  std::normal_distribution<double> normal;
  std::vector<std::pair<std::size_t, Path>> found;
  while (found.size() < crossings) {
    const std::size_t t = random() % surface.triangles().size();
    const double v = unit(random), w = unit(random) * (1 - v);
    const Vec3d place = (1 - v - w) * surface.corner(t, 0) + v * surface.corner(t, 1) + w * surface.corner(t, 2);
    const Vec3d start = place + (test.radius() + 0.5 * length * unit(random)) * surface.normal(t);
    const Vec3d way = normalised(Vec3d{normal(random), normal(random), normal(random)});
    if (dot(way, surface.normal(t)) < -0.5 && !test.is_inside(start, 0)) found.push_back({t, {start, start + length * way}});
  }
  if (in_order) std::ranges::stable_sort(found, {}, [](const auto& one) { return one.first; });
  std::vector<Path> paths;
  for (const auto& [triangle, path] : found) paths.push_back(path);
  return paths;
}

/// The hull of scene.hpp as it is; with each vertex displaced by up to a third of a panel, as in a poor scan; without its stern; or two of them.
std::shared_ptr<const Surface> surface_of(const std::string& kind, double count) {
  const auto smooth = benchmark::hull(count);
  if (kind == "smooth") return smooth;
  Panels panels = smooth->panels();
  if (kind == "rough") {
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> unit(-1, 1);
    const double panel = std::sqrt(smooth->report().area / static_cast<double>(smooth->triangles().size()));
    for (Vec3d& vertex : panels.vertices) vertex += panel / 3 * Vec3d{unit(random), unit(random), unit(random)};
    return std::make_shared<const Surface>(panels);
  }
  if (kind == "open") {
    std::erase_if(panels.panels, [&](const auto& panel) { return panels.vertices[static_cast<std::size_t>(panel[0])].x < -0.3; });
    return std::make_shared<const Surface>(panels, Surface::Options{.orientation = Orientation::normals});
  }
  const std::size_t vertices = panels.vertices.size(), faces = panels.panels.size();
  for (std::size_t v = 0; v < vertices; ++v) panels.vertices.push_back(panels.vertices[v] + Vec3d{0.21, 0.17, 0.13});
  for (std::size_t p = 0; p < faces; ++p) {
    auto panel = panels.panels[p];
    for (int& corner : panel)
      if (corner >= 0) corner += static_cast<int>(vertices);
    panels.panels.push_back(panel);
  }
  return std::make_shared<const Surface>(panels);
}

/// FNV-1a over the bits of numbers.
class Hash {
 public:
  void add(double number) { add(std::bit_cast<std::uint64_t>(number)); }
  void add(const Vec3d& a) { add(a.x), add(a.y), add(a.z); }
  void add(int number) { add(static_cast<std::uint64_t>(number)); }
  void add(const PathResult& result, int guess) {
    add(result.clearance), add(guess);
    add(result.enters + 2 * result.leaves + 4 * result.is_first_entry + 8 * result.in_contact_as_ball);
    if (!result.contact) return;
    const BodyFrameContact& c = *result.contact;
    add(c.time_fraction), add(c.hit), add(c.normal), add(c.relocation), add(c.triangle), add(c.normal_t0), add(int{c.front});
  }
  std::uint64_t value() const { return value_; }

 private:
  void add(std::uint64_t bits) {
    for (int byte = 0; byte < 8; ++byte) value_ = (value_ ^ ((bits >> 8 * byte) & 255)) * 0x100000001b3u;
  }
  std::uint64_t value_ = 0xcbf29ce484222325u;
};

}  // namespace

int main(int argc, char** argv) {
  double panels = 2e5;
  int rounds = 5;
  bool in_order = false;
  std::string kind_of_surface = "smooth", only;
  CLI::App app("Times crossings of a surface with their relocation; prints CSV rows.");
  app.add_option("--panels", panels)->check(CLI::PositiveNumber);
  app.add_option("--rounds", rounds)->check(CLI::PositiveNumber);
  app.add_option("--surface", kind_of_surface)->check(CLI::IsMember({"smooth", "rough", "open", "union"}));
  app.add_flag("--in-order", in_order, "points in the order of the triangles, as blocks of particles are");
  app.add_option("--only", only, "one motion")->check(CLI::IsMember({"moved", "turned", "deforming"}));
  CLI11_PARSE(app, argc, argv);
  use_threads(1);

  const auto hull = surface_of(kind_of_surface, panels);
  const SharedSurface indexed = share(hull);
  const double panel = std::sqrt(hull->report().area / static_cast<double>(hull->triangles().size()));

  fmt::print("motion,radius,path,panels,ns/crossing,triangles,contacts,hash\n");
  const auto row = [&](const char* kind, double radius, double length, const std::vector<Path>& paths, const auto& evaluate) {
    std::vector<int> start;
    for (const Path& path : paths) start.push_back(indexed->bvh().closest(path.start)->triangle);
    double least = 1e300;
    std::size_t contacts = 0;
    Effort effort;
    Hash hash;
    for (int round = 0; round < rounds; ++round) {
      contacts = 0, effort = {}, hash = {};
      std::vector<int> guess = start;
      std::vector<PathResult> results(paths.size());
      const double begin = seconds();
      for (std::size_t i = 0; i < paths.size(); ++i) results[i] = evaluate(paths[i], guess[i], effort);
      least = std::min(least, seconds() - begin);
      for (std::size_t i = 0; i < paths.size(); ++i) hash.add(results[i], guess[i]), contacts += results[i].contact.has_value();
    }
    const auto count = static_cast<double>(paths.size());
    fmt::print("{},{},{},{},{:.0f},{:.1f},{},{:016x}\n", kind, radius, length, hull->triangles().size(), 1e9 * least / count,
               static_cast<double>(effort.panels_tested) / count, contacts, hash.value());
  };

  for (const double length : {0.01, 0.1, 1.0, 10.0})
    for (const double radius : {0.0, 0.5, 2.0}) {
      const double offset = 1e-12;
      const PathTest test(indexed, Unbounded(), radius * panel);
      const std::vector<Path> paths = paths_into(test, length * panel, in_order);
      const auto rigid = [&](const char* kind, const Motion& motion) {
        if (!only.empty() && only != kind) return;
        const BodyView view(motion, test.size());
        row(kind, radius, length, paths, [&](const Path& path, int& guess, Effort& effort) {
          return test.evaluate({.path = view.path(motion.t0.to_world(path.start), motion.t1.to_world(path.end)), .radius = radius * panel, .offset = offset},
                               guess, effort);
        });
      };
      rigid("moved", {Pose(), Pose(panel * Vec3d{0.1, -0.2, 0.15}), 1});
      rigid("turned", {Pose(), Pose({}, Quaternion::from_rotation({0, 0, 0.05})), 1});
      if (hull->report().may_overlap > 0 || (!only.empty() && only != "deforming")) continue;  // deforming surfaces may not overlap
      const auto surface = std::make_shared<DeformingSurface>(*hull);
      std::vector<Vec3d> vertices = hull->panels().vertices;
      std::mt19937_64 random(2);
      std::uniform_real_distribution<double> unit(-1, 1);
      for (Vec3d& vertex : vertices) vertex += 0.1 * std::min(1.0, length) * panel * Vec3d{unit(random), unit(random), unit(random)};
      surface->move(vertices);
      const MovingPathTest moving(*surface);
      row("deforming", radius, length, paths, [&](const Path& path, int& guess, Effort& effort) {
        return moving.evaluate({.path = path, .radius = radius * panel, .offset = offset}, guess, effort);
      });
    }
  return 0;
}
