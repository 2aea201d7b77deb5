#include "perimpact/simulation/memory.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "fixtures/tolerance.hpp"
#include "perimpact/bodies.hpp"
#include "perimpact/deck_model/setup_error.hpp"

using namespace perimpact;

namespace {

std::vector<Discretisation> discretised(const Setup& setup) {
  std::vector<Discretisation> bodies;
  for (const BodySetup& body : setup.bodies) bodies.push_back(discretise(body));
  return bodies;
}

}  // namespace

TEST_CASE("memory: the estimate exceeds the sum over bodies, and includes distance and guess per slot and impactor") {
  for (const SurfaceCorrection correction : {SurfaceCorrection::energy, SurfaceCorrection::volume, SurfaceCorrection::none}) {
    Setup setup;
    setup.bodies = {fixtures::body_setup({.size = {0.021, 0.015, 0.009}, .correction = correction})};
    const Body body = make_body(setup.bodies[0]);
    const double before = memory_of(setup, discretised(setup)).at_rest;
    CHECK(before > body.memory());  // which leaves out what stencils read beyond the body
    setup.impactors.resize(2);
    CHECK(memory_of(setup, discretised(setup)).at_rest - before == fixtures::relative(2 * 12 * static_cast<double>(body.particles.slots()), 1e-9));
  }
}

TEST_CASE("memory: a set-up larger than the machine is refused at its largest body, with the numbers and a suitable spacing") {
  Setup setup;
  setup.bodies = {fixtures::body_setup({.size = {1, 1, 0.1}}), fixtures::body_setup({.size = {2, 1, 0.1}})};
  setup.bodies[0].name = "small", setup.bodies[1].name = "large";
  CHECK_NOTHROW(expect_to_fit(setup, discretised(setup), 1.01 * memory_of(setup, discretised(setup)).peak()));
  std::string key, sentence;
  try {
    expect_to_fit(setup, discretised(setup), 32e9);
  } catch (const SetupError& error) {
    key = error.key(), sentence = error.what();
  }
  CHECK(key == "bodies.large.spacing");
  CHECK(sentence.find("but this machine has 32 GB") != std::string::npos);
  const double spacing = std::stod(sentence.substr(sentence.find("at least ") + 9));
  for (BodySetup& body : setup.bodies) body.spacing = spacing;
  CHECK(memory_of(setup, discretised(setup)).peak() < 32e9);
}

TEST_CASE("memory: this machine has some") { CHECK(physical_memory() > 1e8); }
