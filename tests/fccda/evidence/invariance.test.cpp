// Invariance to the position and rotation of the scene, to the division of a surface into panels and to their order.
// Convergence of panels of round shapes.
#include <doctest/doctest.h>

#include "fccda/detect/analytic.hpp"
#include "fccda/evidence/score.hpp"
#include "fccda/evidence/shapes.hpp"
#include "fixtures/larger.hpp"
#include "fixtures/tolerance.hpp"

using namespace evidence;

namespace {

/// The outcome of each passage in the body frame; none without contact.
using Outcome = std::vector<std::optional<Vec3d>>;

Outcome outcome(const Panels& panels, double radius, const std::vector<Flight>& flights) {
  Swept detector(fixtures::surface_of(panels), Unbounded{}, radius);
  Outcome all;
  for (const Flight& flight : flights) {
    detector.forget();
    const std::size_t first = all.size();
    all.resize(first + flight.passages.size());
    for (const Contact& contact : fixtures::detect(detector, flight.points(Way::points_move), flight.motion, travel_bound(flight.motion, {}, 1)))
      all[first + contact.point] = flight.motion.t1.to_body(contact.relocation);
  }
  return all;
}

/// Largest distance between the relocations; infinite if the contacts differ.
double difference(const Outcome& a, const Outcome& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i].has_value() != b[i].has_value()) return std::numeric_limits<double>::infinity();
    if (a[i]) most = fixtures::larger(most, norm(*a[i] - *b[i]));
  }
  return most;
}

/// Every panel divided into four triangles, or a quad into eight, along the diagonal that the surface would choose.
Panels refined(const Panels& panels) {
  const Surface surface(panels);
  Panels fine;
  const auto add = [&](const Vec3d& p) { return fine.vertices.push_back(p), static_cast<int>(fine.vertices.size()) - 1; };
  for (std::size_t t = 0; t < surface.triangles().size(); ++t) {
    const Vec3d a = surface.corner(t, 0), b = surface.corner(t, 1), c = surface.corner(t, 2);
    const int va = add(a), vb = add(b), vc = add(c), ab = add(0.5 * (a + b)), bc = add(0.5 * (b + c)), ca = add(0.5 * (c + a));
    fine.add_triangle(va, ab, ca), fine.add_triangle(ab, vb, bc), fine.add_triangle(ca, bc, vc), fine.add_triangle(ab, bc, ca);
  }
  return fine;
}

/// The same triangles in another order, each starting at another corner.
Panels shuffled(const Panels& panels) {
  const Surface surface(panels);
  std::mt19937_64 random(91);
  Panels out;
  for (std::size_t t = 0; t < surface.triangles().size(); ++t) {
    const auto first = static_cast<int>(out.vertices.size()), turn = static_cast<int>(random() % 3);
    for (std::size_t c = 0; c < 3; ++c) out.vertices.push_back(surface.corner(t, c));
    out.add_triangle(first + turn, first + (turn + 1) % 3, first + (turn + 2) % 3);
  }
  std::shuffle(out.panels.begin(), out.panels.end(), random);
  return out;
}

}  // namespace

TEST_CASE("evidence: contacts and relocations of a scene are invariant to rigid motion of the whole and to its division into panels, up to rounding") {
  const std::vector<Pose> here(24);
  std::vector<Pose> afar;
  for (const Pose& pose : fixtures::orientations()) afar.push_back(Pose(pose.position() + Vec3d{-700, 300, 500}, pose.attitude()));
  for (const fixtures::Body& body : fixtures::bodies()) {
    CAPTURE(std::string(body.name));
    const Truth truth{Surface(body.panels)};
    for (const double radius : {0.0, 0.02}) {
      CAPTURE(radius);
      const std::vector<Flight> flown = flights(truth, {.radius = radius, .step = 0.03, .contacts = 480, .past = 120, .seed = 92}, here);
      std::vector<Flight> elsewhere = flown;
      for (std::size_t g = 0; g < afar.size(); ++g) elsewhere[g].motion = {afar[g], afar[g], 1};
      const Outcome as_it_is = outcome(body.panels, radius, flown);
      const auto contacts = static_cast<std::size_t>(std::count_if(as_it_is.begin(), as_it_is.end(), [](const auto& place) { return place.has_value(); }));
      CHECK(contacts == 480);
      CHECK(difference(as_it_is, outcome(body.panels, radius, elsewhere)) < 1e-11);       // the offset follows coordinates of 700: 32 ε 700 = 5e-12
      CHECK(difference(as_it_is, outcome(refined(body.panels), radius, flown)) < 1e-13);  // rounding of an advancement of several steps
      CHECK(difference(as_it_is, outcome(shuffled(body.panels), radius, flown)) < 1e-13);
    }
  }
}

TEST_CASE("evidence: meshed spheres and cylinders converge to the analytic ones with the square of the panel size") {
  struct Twin {
    const char* name;
    AnalyticShape shape;
    Panels (*panels)(double);
  };
  for (const Twin& twin : {Twin{"sphere", Sphere{.radius = 0.5}, [](double panel) { return make_sphere({.diameter = 1, .edge_length = panel}); }},
                           Twin{"cylinder", InfiniteCylinder{.radius = 0.5},
                                [](double panel) { return make_cylinder({.diameter = 1, .height = 1, .axis = Axis::z, .edge_length = panel}); }}}) {
    CAPTURE(std::string(twin.name));
    const auto from_centre = [&](const Vec3d& place) { return std::visit([&](const auto& shape) { return norm(shape.from_centre(place)); }, twin.shape); };
    std::mt19937_64 random(93);
    std::uniform_real_distribution<double> height(-0.2, 0.2), off(0.53, 0.55);
    std::vector<Path> paths;
    while (paths.size() < 2000) {  // into it, far from the ends of the cylinder
      Vec3d start = fixtures::random_direction(random);
      start = off(random) / from_centre(start) * start;
      if (std::fabs(start.z) > 0.2) continue;
      const Vec3d end = start + 0.15 * fixtures::random_direction(random);
      if (from_centre(end) < 0.48) paths.push_back({start, end});
    }
    for (const double radius : {0.0, 0.02}) {
      CAPTURE(radius);
      Analytic exact(twin.shape, Unbounded{}, radius);
      const std::vector<Contact> truth = fixtures::detect(exact, fixtures::points_on(paths));
      REQUIRE(truth.size() == paths.size());
      struct Measured {
        double error, edge;
      };
      const auto measure = [&](double panel) {
        const auto surface = fixtures::surface_of(twin.panels(panel));
        Swept mesh(surface, Unbounded{}, radius);
        const std::vector<Contact> contacts = fixtures::detect(mesh, fixtures::points_on(paths));
        REQUIRE(contacts.size() == paths.size());
        double sum = 0;
        for (std::size_t i = 0; i < contacts.size(); ++i) sum += std::fabs(from_centre(contacts[i].relocation) - from_centre(truth[i].relocation));
        return Measured{sum / static_cast<double>(contacts.size()), surface->report().longest_edge};
      };
      const Measured coarse = measure(0.1), middle = measure(0.05), fine = measure(0.025);
      const auto order = [](const Measured& a, const Measured& b) { return std::log(a.error / b.error) / std::log(a.edge / b.edge); };
      CHECK(coarse.error < 0.1 * 0.1 / 2 / 2);  // two sagittas of a panel's diagonal, panel²/4R each
      // 0.1 allows for the longest edge in place of all of them
      CHECK(order(coarse, middle) == fixtures::relative(2, 0.05));
      CHECK(order(middle, fine) == fixtures::relative(2, 0.05));
    }
  }
}
