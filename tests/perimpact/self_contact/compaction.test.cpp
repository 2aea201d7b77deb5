// Fragments of a body that yields are compacted at its largest pressure: pressure, energy and memory of loose particles that are compressed.
#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "fixtures/snapshot.hpp"
#include "fixtures/tolerance.hpp"
#include "perimpact/force/piles.hpp"

using namespace perimpact;
using fixtures::Pile;

namespace {

constexpr double spacing = 0.1;                               // [m]
constexpr double strength = 2e-3 * fixtures::youngs_modulus;  // [Pa] the ratio of ice

/// A cube of loose particles on a lattice, and its short-range contact.
class Rubble {
 public:
  explicit Rubble(double largest_pressure) : pile_{.law = {}, .bodies = {}, .largest_pressure = largest_pressure} {
    pile_.bodies.push_back(fixtures::body({.size = {edge * spacing, edge * spacing, edge * spacing}, .spacing = spacing}));
    fixtures::shatter(body(), 1);
    contacts_ = pile_.contacts();
    contact_.emplace(pile_.law, contacts_);
  }

  /// All distances become `stretch` times those of the reference lattice, in one step; returns the work done on the particles [J], by the trapezoidal rule.
  double compress(double stretch) {
    double work = 0;
    std::vector<Vec3d> ways;
    for (const std::uint32_t slot : body().particles.slot_of()) {
      const Vec3d way = stretch * body().particles.reference(slot) - body().particles.position.at(slot);
      work -= 0.5 * dot(body().particles.volume(slot) * body().particles.force_density.at(slot), way);
      body().particles.velocity.set(slot, way / dt);
      ways.push_back(way);
    }
    place(stretch);
    pile_.clear_forces();
    contact_->add_forces(contacts_, dt);
    for (std::size_t p = 0; const std::uint32_t slot : body().particles.slot_of())
      work -= 0.5 * dot(body().particles.volume(slot) * body().particles.force_density.at(slot), ways[p++]);
    return work;
  }

  /// [Pa] traction between the two halves, those with x below and above 0, over the area of the middle particles: away from the faces of the cube.
  double pressure(double stretch) {
    // the sum of forces on a column of the upper half that is as wide as one particle, which has the same neighbours on all sides
    double force = 0;
    const Particles& particles = body().particles;
    for (const std::uint32_t slot : particles.slot_of()) {
      const Vec3d X = particles.reference(slot);
      if (X.x > 0 && std::fabs(X.y - 0.5 * spacing) < 0.1 * spacing && std::fabs(X.z - 0.5 * spacing) < 0.1 * spacing)
        force += particles.volume(slot) * particles.force_density.at(slot).x;
    }
    return force / std::pow(stretch * spacing, 2);
  }

  const ShortRange& contact() const { return *contact_; }
  template <class Visitor>
  void visit_state(Visitor&& visit) {
    contact_->visit_state(contacts_, visit);
  }
  template <class Visitor>
  void visit_record(Visitor&& visit) {
    contact_->visit_record(visit);
  }
  double stretch() const { return stretch_; }  // of the last step
  void place(double stretch) {
    for (const std::uint32_t slot : body().particles.slot_of()) body().particles.position.set(slot, stretch * body().particles.reference(slot));
    stretch_ = stretch;
  }
  Body& body() { return pile_.bodies[0]; }

 private:
  static constexpr int edge = 12;
  static constexpr double dt = 1e-6;  // [s] particles move less than their distance, so that none enters the range of another within a step
  Pile pile_;
  std::vector<ContactingBody> contacts_;
  std::optional<ShortRange> contact_;
  double stretch_ = 1;
};

}  // namespace

TEST_CASE("compaction: loose particles pressed together to the density of the solid have the largest pressure") {
  Rubble rubble(strength), elastic(std::numeric_limits<double>::infinity());
  double before = 0;
  for (int percent = 140; percent >= 100; --percent) {
    rubble.compress(0.01 * percent), elastic.compress(0.01 * percent);
    const double pressure = rubble.pressure(0.01 * percent);
    CHECK(pressure >= before);  // looser particles are compacted at less
    before = pressure;
  }
  CHECK(before == fixtures::relative(strength, 0.02));  // that of two faces, in a lattice: 2.197/2.236 (docs/theory/short_range.md)
  CHECK(elastic.pressure(1) > 20 * strength);           // what the springs alone would carry
}

TEST_CASE("compaction: contact energy and dissipation are the work, with an error of second order in the step") {
  double of_longest = 0;
  for (const int steps : {100, 400}) {
    CAPTURE(steps);
    Rubble rubble(strength);
    double work = 0, dissipated = 0;
    for (int step = 0; step <= steps; ++step) {
      work += rubble.compress(1.3 - 0.35 * step / steps);
      REQUIRE(rubble.contact().compaction_dissipation() >= dissipated);
      dissipated = rubble.contact().compaction_dissipation();
    }
    REQUIRE(dissipated > 0.9 * work);  // the springs at yield store the rest
    const double error = std::fabs(rubble.contact().energy() + dissipated - work) / work;
    CHECK(error < 1e-3);
    if (of_longest > 0) CHECK(error < 0.125 * of_longest);  // 1/16; first order would be 1/4
    of_longest = error;
  }
}

TEST_CASE("compaction: compacted particles unload elastically, reload without dissipation, and forget when they have parted") {
  Rubble rubble(strength);
  for (int step = 0; step <= 150; ++step) rubble.compress(1.3 - 0.002 * step);
  const double dissipated = rubble.contact().compaction_dissipation(), pressure = rubble.pressure(1);
  rubble.compress(1.0002);
  CHECK(rubble.pressure(1.0002) < 0.9 * pressure);
  CHECK(rubble.pressure(1.0002) > 0);
  rubble.compress(1);
  CHECK(rubble.pressure(1) == fixtures::relative(pressure, 1e-9));
  CHECK(rubble.contact().compaction_dissipation() == fixtures::relative(dissipated, 1e-9));
  rubble.compress(1.002);
  CHECK(rubble.pressure(1.002) == 0);  // the gap that compaction leaves
  for (int step = 0; step <= 300; ++step) rubble.compress(1 + 0.002 * step);
  for (int step = 0; step <= 300; ++step) rubble.compress(1.6 - 0.002 * step);
  CHECK(rubble.pressure(1) == fixtures::relative(pressure, 1e-3));
  CHECK(rubble.contact().compaction_dissipation() == fixtures::relative(2 * dissipated, 1e-3));
}

TEST_CASE("compaction: a state that is resumed continues bitwise") {
  Rubble whole(strength);
  std::optional<Rubble> resumed(strength);
  for (int step = 0; step < 100; ++step) {
    const double stretch = 1.3 - 0.003 * step + 0.02 * std::sin(0.4 * step);
    if (step % 7 == 3) {
      const fixtures::Snapshot snapshot(*resumed);
      const double place = resumed->stretch();
      resumed.emplace(strength);
      resumed->place(place);
      snapshot.give(*resumed);
    }
    whole.compress(stretch), resumed->compress(stretch);
    REQUIRE(resumed->contact().energy() == whole.contact().energy());
    REQUIRE(resumed->contact().compaction_dissipation() == whole.contact().compaction_dissipation());
  }
}
