#include "perimpact/fragments/fragments.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <deque>
#include <map>

#include "fixtures/tolerance.hpp"
#include "perimpact/bodies.hpp"

using namespace perimpact;

namespace {

/// The slot with which the search from each particle began: breadth first over the bonds that Family names, one particle after the other.
std::map<std::size_t, std::size_t> found_by_search(const Body& body) {
  std::map<std::size_t, std::size_t> beginning;
  for (const std::uint32_t start : body.particles.slot_of()) {
    if (beginning.count(start)) continue;
    std::deque<std::size_t> reached = {start};
    beginning[start] = start;
    for (; !reached.empty(); reached.pop_front())
      body.family.for_each_bond(reached.front(), [&](const FamilyBond& bond) {
        if (beginning.emplace(bond.j, start).second) reached.push_back(bond.j);
      });
  }
  return beginning;
}

std::vector<fixtures::BodyOptions> kinds_of_bodies() {
  std::vector<fixtures::BodyOptions> all;
  for (const Plane plane : {Plane::none, Plane::stress})
    for (const fixtures::Points points : {fixtures::Points::lattice, fixtures::Points::listed, fixtures::Points::shaken})
      all.push_back({.size = {0.019, 0.014, plane == Plane::none ? 0.006 : 0.001}, .critical_stretch = 0.01, .plane = plane, .points = points});
  return all;
}

void cut_at_random(Body& body, double share) {
  body.family.cut([&](std::size_t i, std::size_t j) { return fixtures::drawn(i, j) < share; });
}

/// Cuts all bonds between the two sides of the plane x = `at` [m].
void cut_across(Body& body, double at) {
  body.family.cut([&](std::size_t i, std::size_t j) { return (body.particles.reference(i).x < at) != (body.particles.reference(j).x < at); });
}

}  // namespace

TEST_CASE("fragments: they equal the result of a search along bonds, on lattices and lists, in 3-D and 2-D") {
  for (const fixtures::BodyOptions& options : kinds_of_bodies())
    for (const double share : {0.0, 0.8, 0.93, 0.97, 0.99}) {
      Body body = fixtures::body(options);
      cut_at_random(body, share);
      const Fragments fragments(body.particles, body.family);
      const auto beginning = found_by_search(body);
      REQUIRE(fragments.of_particles().size() == body.particles.size());
      std::map<std::size_t, std::size_t> particles_of;
      for (std::size_t p = 0; p < body.particles.size(); ++p) {
        const std::size_t slot = body.particles.slot_of()[p];
        // a search begins with the smallest slot of a fragment, which is that fragment's name
        CHECK(fragments.all()[static_cast<std::size_t>(fragments.of_particles()[p])].first_slot == beginning.at(slot));
        ++particles_of[beginning.at(slot)];
      }
      CHECK(fragments.all().size() == particles_of.size());
      for (const Fragment& fragment : fragments.all()) CHECK(fragment.particles == particles_of.at(fragment.first_slot));
      if (share == 0.0) CHECK(fragments.all().size() == 1);
      if (share == 0.97) CHECK(particles_of.size() > 10);  // else the cuts would show nothing
    }
}

TEST_CASE("fragments: they are in descending order of mass, ties in order of the smallest slot") {
  for (const fixtures::BodyOptions& options : kinds_of_bodies()) {
    Body body = fixtures::body(options);
    cut_at_random(body, 0.97);
    const Fragments fragments(body.particles, body.family);
    bool has_equal = false;
    for (std::size_t n = 1; n < fragments.all().size(); ++n) {
      const Fragment &heavier = fragments.all()[n - 1], &lighter = fragments.all()[n];
      CHECK(heavier.mass >= lighter.mass);
      if (heavier.mass == lighter.mass) CHECK(heavier.first_slot < lighter.first_slot);
      has_equal = has_equal || heavier.mass == lighter.mass;
    }
    CHECK((has_equal || options.points == fixtures::Points::shaken));
  }
}

TEST_CASE("fragments: a body cut twice has three, with masses, positions, extents and velocities of the slabs") {
  Body body = fixtures::body({.size = {0.020, 0.008, 0.006}});  // x from -10 to 10 mm
  cut_across(body, -0.006);
  cut_across(body, 0.002);
  const Vec3d shift{0.1, 0.2, 0.3}, speed{3, -2, 1};
  for (const std::uint32_t slot : body.particles.slot_of()) {
    body.particles.position.set(slot, body.particles.position.at(slot) + shift);
    const double x = body.particles.reference(slot).x;
    body.particles.velocity.set(slot, x < -0.006 ? speed : x > 0.002 ? -1.0 * speed : Vec3d{});
  }
  const Fragments fragments(body.particles, body.family);
  REQUIRE(fragments.all().size() == 3);
  // slabs of 4, 8 and 8 mm; that in the middle has the smaller slot of the two equal ones
  const double lengths[] = {0.008, 0.008, 0.004}, centres[] = {-0.002, 0.006, -0.008}, speeds[] = {0, -1, 1};
  const std::vector<FragmentState> states = states_of(fragments, body.particles, 3);
  const double rounding = 1e-12;  // sums of some hundred numbers, relative
  for (std::size_t n = 0; n < 3; ++n) {
    CHECK(fragments.all()[n].particles == static_cast<std::size_t>(lengths[n] * 1000 * 8 * 6 + 0.5));
    CHECK(fragments.all()[n].mass == fixtures::relative(fixtures::density * lengths[n] * 0.008 * 0.006, rounding));
    CHECK(norm(states[n].centre - (shift + Vec3d{centres[n], 0, 0})) < rounding);
    CHECK(norm(states[n].extent - Vec3d{lengths[n], 0.008, 0.006}) < rounding);
    CHECK(norm(states[n].velocity - speeds[n] * speed) < rounding);
  }
  const FragmentCount count = fragments.count();
  CHECK(count.fragments == 3);
  CHECK(count.single_particles == 0);
  CHECK(count.above_one_percent == 3);
  CHECK(count.largest == fragments.all()[0].mass);
  CHECK(count.second_largest == fragments.all()[1].mass);
  CHECK(count.outside_largest == fixtures::relative(0.6 * body.particles.total_mass(), rounding));
}

TEST_CASE("fragments: particles without a bond are counted apart from fragments") {
  Body body = fixtures::body({.size = {0.020, 0.010, 0.001}, .plane = Plane::stress});
  const std::size_t lost[] = {body.particles.slot_of()[0], body.particles.slot_of()[77], body.particles.slot_of()[150]};
  body.family.cut(
      [&](std::size_t i, std::size_t j) { return std::any_of(std::begin(lost), std::end(lost), [&](std::size_t slot) { return slot == i || slot == j; }); });
  const Fragments fragments(body.particles, body.family);
  const FragmentCount count = fragments.count();
  CHECK(count.fragments == 1);
  CHECK(count.single_particles == 3);
  CHECK(count.above_one_percent == 1);  // one particle of 200 is 0.5 %
  CHECK(fragments.all()[0].particles == 197);
  for (std::size_t k = 0; k < 3; ++k) CHECK(fragments.all()[k + 1].first_slot == lost[k]);
  const std::vector<FragmentState> states = states_of(fragments, body.particles, 2);
  CHECK(norm(states[1].extent - Vec3d{0.001, 0.001, 0.001}) < 1e-15);  // rounding of coordinates of 10 mm

  cut_at_random(body, 1.1);
  const Fragments dust(body.particles, body.family);
  CHECK(dust.count().fragments == 0);
  CHECK(dust.count().single_particles == 200);
  CHECK(std::is_sorted(dust.of_particles().begin(), dust.of_particles().end()));
}
