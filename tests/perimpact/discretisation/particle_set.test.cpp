// Particle sets: the particles of a name.
#include "perimpact/discretisation/particle_set.hpp"

#include <doctest/doctest.h>

#include "fixtures/tolerance.hpp"
#include "perimpact/bodies.hpp"
#include "perimpact/deck_model/setup_error.hpp"

using namespace perimpact;

namespace {

/// Ten by ten by five particles, 1 m apart, about (100, 0, 0).
BodySetup block() {
  BodySetup setup = fixtures::body_setup({.size = {10, 10, 5}, .spacing = 1});
  setup.position = {100, 0, 0};
  setup.particle_sets = {{"left", BoxSolid{{2, 20, 20}}, {-5, 0, 0}, {}},
                         {"rod", CylinderSolid{3.1, 20, {axis_words, 2}}, {-0.5, 0.5, 0}, {}},
                         {"far", SphereSolid{1}, {50, 0, 0}, {}}};
  return setup;
}

std::string complaint(std::string_view region, const BodySetup& body, std::string& key) {
  try {
    slots_in(region, body, make_particles(body), "bodies.body.boundary_conditions.pull.region");
  } catch (const SetupError& error) {
    key = error.key();
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("particle set: its slots are those of the particles in the solid and on its faces, ascending") {
  const BodySetup setup = block();
  const Particles particles = make_particles(setup);
  const std::vector<std::size_t> left = slots_in("left", setup, particles, "key"), rod = slots_in("rod", setup, particles, "key");
  CHECK(std::is_sorted(left.begin(), left.end()));
  CHECK(left.size() == 10 * 5);  // the box ends at x = 96 m, between the first layer and the second
  for (const std::size_t slot : left) CHECK(particles.reference(slot).x == fixtures::relative(95.5, 1e-12));
  CHECK(rod.size() == 9 * 5);  // a particle on the axis, four at 1 m, four at 1.41 m

  BodySetup wider = block();
  wider.particle_sets[0].shape = BoxSolid{{3, 20, 20}};  // ends at 96.5 m, through the second layer
  CHECK(slots_in("left", wider, particles, "key").size() == 2 * 10 * 5);
}

TEST_CASE("particle set: it excludes removed particles") {
  const BodySetup setup = block();
  Particles particles = make_particles(setup);
  const std::vector<std::size_t> left = slots_in("left", setup, particles, "key");
  particles.remove(std::span(left).first(7));
  CHECK(slots_in("left", setup, particles, "key").size() == left.size() - 7);
}

TEST_CASE("particle set: an unknown name and an empty set are reported with their keys") {
  std::string key;
  CHECK(complaint("lft", block(), key) == "body body has no particle set lft; did you mean left?");
  CHECK(key == "bodies.body.boundary_conditions.pull.region");
  CHECK(complaint("everything", block(), key) == "body body has no particle set everything; its particle sets are left, rod, far.");
  CHECK(complaint("far", block(), key) ==
        "particle set far of body body contains no particle; its position is relative to the body's position, in metres: move it, or make it larger than a "
        "spacing of 1 m.");
  CHECK(key == "bodies.body.particle_sets.far");
  BodySetup bare = block();
  bare.particle_sets.clear();
  CHECK(complaint("left", bare, key) == "body body has no particle set left; it has none; add one under bodies.body.particle_sets.");
}
