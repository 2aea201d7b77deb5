/// Crossings of deforming surfaces, against arithmetic of 113 digits: CSV rows on standard output.
///
///   deforming_crossings --crossings 1e6
///
/// Random points near six bodies that are stretched, bent, folded, spun and twisted, by up to a panel's size a step. Which of them cross the surface from
/// its front, and when, is decided by a loop over all triangles (tests/fccda/deforming/exact_crossing.hpp). Paths that pass an edge within 1e-12 of
/// a triangle's size are counted as undecided; of those only a miss counts. Exit code 1: one is missed or invented.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <map>
#include <memory>
#include <random>
#include <vector>

#include "base/parallel.hpp"
#include "fccda/deforming/scenes.hpp"
#include "fccda/evidence/truth.hpp"

namespace {

using namespace deforming;

/// What was found for one way to deform.
struct Score {
  std::size_t paths = 0, crossings = 0, undecided = 0, missed = 0, invented = 0;
  double worst_time = 0;
};

/// The moving triangles with their boxes.
struct Boxes {
  std::vector<Box> of;

  explicit Boxes(const DeformingSurface& surface) : of(surface.at_t1().triangles().size()) {
    for (std::size_t t = 0; t < of.size(); ++t) {
      const MovingTriangle moving = surface.triangle(t);
      for (const Corners& c : {moving.t0, moving.t1}) of[t].include(c.a), of[t].include(c.b), of[t].include(c.c);
    }
  }

  /// The first crossing from the front of any triangle.
  exact::Answer crossing(const DeformingSurface& surface, const Path& path) const {
    const Vec3d low = min(path.start, path.end), high = max(path.start, path.end);
    exact::Answer first;
    for (std::size_t t = 0; t < of.size(); ++t) {
      if (of[t].low.x > high.x || of[t].low.y > high.y || of[t].low.z > high.z || of[t].high.x < low.x || of[t].high.y < low.y || of[t].high.z < low.z)
        continue;
      const exact::Answer one = exact::front_crossing(path, surface.triangle(t));
      first.margin = std::min(first.margin, one.margin);
      if (one.crosses && (!first.crosses || one.time < first.time)) first.crosses = true, first.time = one.time;
    }
    return first;
  }
};

void add_batch(const Panels& panels, const Deformation& deformation, std::size_t paths, std::mt19937_64& random, Score& score) {
  std::uniform_real_distribution<double> unit(0, 1);
  const double from = 0.1 * unit(random);
  const auto surface = std::make_shared<DeformingSurface>(Surface(panels));
  surface->move(displaced(panels, deformation, from));
  const Surface at_start = surface->at_t1();
  surface->move(displaced(panels, deformation, from + 0.04 * unit(random)));
  const evidence::Truth truth(at_start);
  const Boxes boxes(*surface);
  TestPoints points;
  std::vector<exact::Answer> crossing;
  while (points.size() < paths) {
    const Path path = path_near(*surface, 0.03, 0.2, random);
    if (truth.inside(path.start)) continue;
    points.x0.push_back(path.start), points.x1.push_back(path.end);
    crossing.push_back(boxes.crossing(*surface, path));
  }
  Deforming detector(surface, 0);
  std::map<std::size_t, double> found;
  for (const DeformingContact& contact : deforming::detect(detector, points)) found[contact.contact.point] = contact.contact.time_fraction;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool decided = crossing[i].margin >= 1e-12, is_found = found.count(i) > 0;
    ++score.paths, score.crossings += crossing[i].crosses, score.undecided += !decided;
    score.missed += crossing[i].crosses && !is_found;
    score.invented += !crossing[i].crosses && is_found && decided;
    if (crossing[i].crosses && is_found && decided) score.worst_time = std::max(score.worst_time, std::fabs(found[i] - crossing[i].time));
  }
}

}  // namespace

int main(int argc, char** argv) {
  double crossings = 1e6;
  CLI::App app("Compares crossings of deforming surfaces with exact ones; prints CSV rows.");
  app.add_option("--crossings", crossings, "at least as many in all")->check(CLI::PositiveNumber);
  CLI11_PARSE(app, argc, argv);
  use_threads(1);
  fmt::print("deformation,paths,crossings,undecided,missed,invented,largest_time_error\n");
  std::size_t wrong = 0;
  const std::vector<Deformation> ways = deformations();
  for (std::size_t w = 0; w < ways.size(); ++w) {
    std::mt19937_64 random(100 + w);
    Score score;
    while (static_cast<double>(score.crossings) < crossings / static_cast<double>(ways.size()))
      for (const fixtures::Body& body : fixtures::bodies()) add_batch(body.panels, ways[w], 2000, random, score);
    fmt::print("{},{},{},{},{},{},{:.2g}\n", ways[w].name, score.paths, score.crossings, score.undecided, score.missed, score.invented, score.worst_time);
    std::fflush(stdout);
    wrong += score.missed + score.invented;
  }
  return wrong > 0;
}
