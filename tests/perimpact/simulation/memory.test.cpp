#include "perimpact/simulation/memory.hpp"

#include <doctest/doctest.h>

#include <string>
#include <utility>
#include <vector>

#include "fixtures/tolerance.hpp"
#include "perimpact/bodies.hpp"
#include "perimpact/deck_model/setup_error.hpp"
#include "perimpact/impactor/impactor.hpp"

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
  const std::vector<Discretisation> bodies = discretised(setup);
  const Memory memory = memory_of(setup, bodies);
  CHECK_NOTHROW(expect_to_fit(setup, bodies, memory, {.bytes = 1.01 * memory.peak()}));
  std::string key, sentence;
  try {
    expect_to_fit(setup, bodies, memory, {.bytes = 32e9, .reason = "the limit allows only 32 GB", .remedy = "a higher limit"});
  } catch (const SetupError& error) {
    key = error.key(), sentence = error.what();
  }
  CHECK(key == "bodies.large.spacing");
  CHECK(sentence.find("GB of memory, but the limit allows only 32 GB; use a spacing of at least ") != std::string::npos);
  CHECK(sentence.ends_with(" m, a smaller body, or a higher limit."));
  const double spacing = std::stod(sentence.substr(sentence.find("at least ") + 9));
  for (BodySetup& body : setup.bodies) body.spacing = spacing;
  CHECK(memory_of(setup, discretised(setup)).peak() < 32e9);
}

TEST_CASE("memory: a surface that needs more than any body is what a refusal names, with its number of panels") {
  Setup setup;
  setup.bodies = {fixtures::body_setup({.size = {0.02, 0.02, 0.02}})};
  for (const auto& [name, edge_length] : {std::pair("coarse", 0.05), std::pair("fine", 0.004), std::pair("medium", 0.01)}) {
    setup.impactors.emplace_back().name = name;
    setup.impactors.back().surface = SphereSurface{.diameter = 1, .edge_length = edge_length};
  }
  const std::vector<Discretisation> bodies = discretised(setup);
  Memory memory = memory_of(setup, bodies);
  const double without = memory.peak();
  std::vector<std::size_t> panels;
  for (const ImpactorSetup& impactor : setup.impactors) {
    const fccda::Surface surface = surface_of(impactor).remeshed.surface;
    memory.add(surface);
    panels.push_back(surface.report().panels);
  }
  REQUIRE(panels[1] > 100'000);
  CHECK_NOTHROW(expect_to_fit(setup, bodies, memory, {.bytes = 1.01 * memory.peak()}));
  const auto refusal = [&](const Memory& of, double bytes) -> std::string {
    try {
      expect_to_fit(setup, bodies, of, {.bytes = bytes, .reason = "the limit allows less", .remedy = "a higher limit"});
    } catch (const SetupError& error) {
      return error.key() + ": " + error.what();
    }
    return "";
  };
  const std::string sentence = refusal(memory, 0.99 * memory.peak());
  CHECK(sentence.starts_with("impactors.fine.surface: with " + std::to_string(panels[1]) + " panels on the surface of impactor fine the run needs "));
  CHECK(sentence.ends_with(" GB of memory, but the limit allows less; use larger panels, or a higher limit."));
  CHECK(refusal(memory_of(setup, bodies), 0.99 * without).starts_with("bodies.body.spacing: "));
}

TEST_CASE("memory: particles of a solid are counted as they are made, in the body and in its estimate") {
  Setup setup;
  setup.bodies = {fixtures::body_setup({.size = {0.03, 0.03, 0.03}})};
  setup.bodies[0].shape = SphereSolid{.diameter = 0.031};
  setup.bodies[0].holes = {{.name = "hole", .shape = BoxSolid{.size = {0.01, 0.02, 0.03}}, .position = {0.004, 0, 0}}};
  const auto made = static_cast<double>(make_particles(setup.bodies[0]).size());
  REQUIRE(made > 100);
  const Memory memory = memory_of(setup, discretised(setup));
  REQUIRE(memory.particles.size() == 1);
  CHECK(memory.particles[0] == made);
}
