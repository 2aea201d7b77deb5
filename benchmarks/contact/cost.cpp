/// Cost of contact detection per particle and step, by method: CSV rows on standard output.
///
///   contact_cost --particles 1e6 --panels 2e5
///
///   all panels            every particle against every panel: the search of Zhang et al. without its bounding box
///   box then all panels   the search of Zhang et al.: the particles in the box against every panel
///   box then bvh          the distance of the particles in the box from the surface, in every step
///   swept                 only particles that may have come near
///
/// One thread; only detection is timed. The first two would take hours: 10 000 of the particles in the box are timed (each several times
/// where there are fewer), and their cost is extrapolated to all. The cost of the box test itself is not included there.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <map>
#include <string>

#include "base/parallel.hpp"
#include "fccda/detect/published.hpp"
#include "fccda/detect/swept.hpp"
#include "scene.hpp"

namespace {

using namespace fccda;
using benchmark::Sheet;

struct Arguments {
  std::string scene = "paper";
  bool swept_alone = false;
  double particles = 1e6, panels = 2e5;
  int warm_up = 100;  // steps until contact is established
  int steps = 200;
};

/// Measured cost, for all particles of the sheet.
struct Cost {
  double seconds_per_step = 0;
  double tested = 0, contacts = 0;  ///< per step
  std::size_t timed = 0;            ///< particles actually timed
};

double seconds() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

ContactBounds bounding_box(const Surface& surface) {
  const Box& bounds = surface.report().bounds;
  return BoxUnion({bounds.size(), bounds.centre()}, surface, Beyond::error);
}

/// Runs the scene with the swept detector from the start, so that contact is established; times the last `steps`.
Cost swept(Sheet& sheet, const std::shared_ptr<const Surface>& surface, long warm_up, long steps) {
  Swept detector(surface, bounding_box(*surface), 0.5 * sheet.spacing());
  std::vector<Contact> contacts;
  Cost cost{.timed = sheet.size()};
  std::size_t tested = 0;
  for (long k = 0; k < warm_up + steps; ++k) {
    sheet.advance();
    contacts.clear();
    if (k == warm_up) tested = detector.effort().points_tested;
    const double begin = seconds();
    detector.detect(sheet, benchmark::motion(sheet, k), sheet.step_length(), contacts);
    const double took = seconds() - begin;
    sheet.relocate(contacts);
    if (k < warm_up) continue;
    cost.seconds_per_step += took / static_cast<double>(steps);
    cost.contacts += static_cast<double>(contacts.size()) / static_cast<double>(steps);
  }
  cost.tested = static_cast<double>(detector.effort().points_tested - tested) / static_cast<double>(steps);
  return cost;
}

/// Distance of every particle from the surface in every step.
Cost box_then_bvh(Sheet& sheet, const std::shared_ptr<const Surface>& surface, long first) {
  const PathTest test(surface, bounding_box(*surface), 0.5 * sheet.spacing());
  constexpr long steps = 3;
  std::vector<int> guess(sheet.size(), -1);
  std::vector<Contact> contacts;
  Cost cost{.timed = sheet.size()};
  Effort effort;
  for (long k = first; k < first + steps; ++k) {
    sheet.advance();
    contacts.clear();
    const Motion motion = benchmark::motion(sheet, k);
    const double begin = seconds();
    const BodyView view(motion, test.size());
    for (std::size_t i = 0; i < sheet.size(); ++i) {
      const CurvedPath path = view.path(sheet.position_t0(i), sheet.position_t1(i));
      const PathResult result = test.evaluate({.path = path, .radius = test.radius(), .offset = 1e-12}, guess[i], effort);
      if (result.contact) contacts.push_back({.point = i, .relocation = motion.t1.to_world(result.contact->relocation)});
    }
    cost.seconds_per_step += (seconds() - begin) / steps;
    cost.contacts += static_cast<double>(contacts.size()) / steps;
    sheet.relocate(contacts);
  }
  cost.tested = static_cast<double>(effort.points_tested) / steps;
  return cost;
}

/// Cost of a particle in the box in the loop over all panels (Zhang et al.).
struct Sample {
  double seconds = 0;                 ///< per particle
  double contacts = 0;                ///< per step, extrapolated to all
  std::size_t inside = 0, timed = 0;  ///< particles in the box, and number of these that were timed
};

Sample all_panels(Sheet& sheet, const std::shared_ptr<const Surface>& surface, long first) {
  sheet.advance();
  const Box& bounds = surface->report().bounds;
  const Motion motion = benchmark::motion(sheet, first);
  const auto in_box = [&](std::size_t i) {
    const Vec3d x = motion.t1.to_body(sheet.position_t1(i));
    return x.x > bounds.low.x && x.x < bounds.high.x && x.y > bounds.low.y && x.y < bounds.high.y && x.z > bounds.low.z && x.z < bounds.high.z;
  };
  Sample sample;
  for (std::size_t i = 0; i < sheet.size(); ++i) sample.inside += in_box(i);
  constexpr std::size_t wanted = 10000;
  const std::size_t every = std::max<std::size_t>(1, sample.inside / wanted);
  std::size_t seen = 0;
  sheet.thin([&](std::size_t i) { return in_box(i) && seen++ % every == 0; });
  const std::size_t chosen = sheet.size();
  sheet.repeat(wanted);  // with fewer particles in the box, each is timed several times
  sample.timed = sheet.size();

  Published detector(surface, Unbounded(), Published::Variant::corrected);
  std::vector<Contact> contacts;
  const double begin = seconds();
  detector.detect(sheet, motion, 0, contacts);
  sample.seconds = (seconds() - begin) / static_cast<double>(sample.timed);
  sample.contacts = static_cast<double>(contacts.size() * every * chosen) / static_cast<double>(sample.timed);
  return sample;
}

Arguments parse(int argc, char** argv) {
  Arguments arguments;
  CLI::App app("Times contact detection; prints one CSV row.");
  app.add_option("--scene", arguments.scene, "paper, or debris with 1 % of fast particles")->check(CLI::IsMember({"paper", "debris"}));
  app.add_option("--particles", arguments.particles)->check(CLI::PositiveNumber);
  app.add_option("--panels", arguments.panels)->check(CLI::PositiveNumber);
  app.add_flag("--swept-alone", arguments.swept_alone, "times the swept method only");
  app.add_option("--warm-up", arguments.warm_up, "untimed steps at the start")->check(CLI::NonNegativeNumber);
  app.add_option("--steps", arguments.steps, "timed steps of the swept method")->check(CLI::PositiveNumber);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    std::exit(app.exit(error));
  }
  return arguments;
}

}  // namespace

int main(int argc, char** argv) {
  const Arguments arguments = parse(argc, argv);
  use_threads(1);
  const auto surface = benchmark::hull(arguments.panels);
  Sheet sheet(arguments.particles);
  {
    const PathTest test(surface, Unbounded(), 0.5 * sheet.spacing());
    sheet.thin([&](std::size_t i) { return !test.is_inside(sheet.position_t1(i), 0); });
  }
  if (arguments.scene == "debris") sheet.add_debris();

  const std::size_t particles = sheet.size();
  const double spacing = sheet.spacing();
  fmt::print("method,scene,particles,panels,spacing,ns/particle/step,us/step,tested/step,contacts/step,timed_particles\n");
  const auto row = [&](const char* method, const Cost& cost) {
    fmt::print("{},{},{},{},{:.6g},{:.4g},{:.4g},{:.1f},{:.1f},{}\n", method, arguments.scene, particles, surface->report().triangles, spacing,
               1e9 * cost.seconds_per_step / static_cast<double>(particles), 1e6 * cost.seconds_per_step, cost.tested, cost.contacts, cost.timed);
  };
  row("swept", swept(sheet, surface, arguments.warm_up, arguments.steps));
  if (arguments.swept_alone) return 0;
  const long now = arguments.warm_up + arguments.steps;
  row("box then bvh", box_then_bvh(sheet, surface, now));
  const Sample sample = all_panels(sheet, surface, now + 3);
  const auto counted = [&](std::size_t tested) {
    const auto count = static_cast<double>(tested);
    return Cost{.seconds_per_step = sample.seconds * count, .tested = count, .contacts = sample.contacts, .timed = sample.timed};
  };
  row("box then all panels", counted(sample.inside));
  row("all panels", counted(particles));
  return 0;
}
