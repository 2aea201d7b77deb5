#include "io/deck/describe.hpp"

#include <doctest/doctest.h>

#include "base/error.hpp"
#include "io/deck/reference.hpp"

using perimpact::deck::describe;

namespace {
constexpr std::string_view poissons_ratio =
    "bodies.<name>.material.poissons_ratio: number, above -1 and below 0.5, default 0.25, with model: ordinary-state, linear-peridynamic-solid\n"
    "    Poisson's ratio ν: an isotropic solid needs -1 < ν < 0.5. Ice is usually 0.25 to 0.35. 0.25 is the fastest.\n"
    "bodies.<name>.material.poissons_ratio: number, above -1 and below 0.5, default 0.25, with model: correspondence\n"
    "    Poisson's ratio ν: an isotropic solid needs -1 < ν < 0.5. Ice is usually 0.25 to 0.35.\n";

std::string complaint(std::string_view path) {
  try {
    describe(path);
    return "";
  } catch (const fccda::InputError& error) {
    return error.what();
  }
}
}  // namespace

TEST_CASE("describe: a key is found by its whole path, with any name or none, and by its end") {
  for (const char* path : {"bodies.<name>.material.poissons_ratio", "bodies.material.poissons_ratio", "bodies.plate.material.poissons_ratio",
                           "material.poissons_ratio", "poissons_ratio"})
    CHECK_MESSAGE(describe(path) == poissons_ratio, path);
}

TEST_CASE("describe: a map is listed with all its keys") {
  CHECK(
      describe("time") ==
      "time: map, required\n    Duration of the run and time step.\n  end: number [s], above 0, required\n      Time at which the run ends.\n  step: number "
      "[s], above 0, optional\n      Time step. Where absent, 0.9 times the stable time step estimated after Silling and Askari, the smallest over all "
      "bodies.\n  relax: map, optional\n      Quasi-static analysis: adaptive dynamic relaxation from one equilibrium state to the next, instead of "
      "dynamics.\n    increments: whole number, from 1 to 1000000, default 1\n        Number of increments, each an equilibrium state, equally spaced in time "
      "up to the end of the run. Boundary conditions and loads are those of its time.\n    tolerance: number, above 0 and below 1, default 1e-06\n        "
      "Convergence tolerance: an increment has converged when the residual forces are below this share of applied forces and reactions.\n    max_iterations: "
      "whole number, from 1 to 1000000000, default 100000\n        Maximum number of iterations of an increment; beyond it the run ends with an error.\n");
  CHECK(describe("impactors").starts_with("impactors: map, optional\n  <name>: map\n"));  // not contact.impactors
  CHECK(describe("bodies.plate") == describe("bodies.<name>"));
  CHECK(describe("bodies.spacing").starts_with("bodies.<name>.spacing: number [m]"));  // a key, not a body of that name
  CHECK(describe("surface").find("one of cylinder, sphere, box, hull, propeller, file") != std::string::npos);
}

TEST_CASE("describe: a key in several maps is listed for each") {
  const std::string text = describe("diameter");
  CHECK(text.find("impactors.<name>.surface.cylinder.diameter: ") != std::string::npos);
  CHECK(text.find("impactors.<name>.surface.sphere.diameter: ") != std::string::npos);
}

TEST_CASE("describe: a key that is the same with several models is described once, with its own contents once") {
  const auto times = [](std::string_view path, std::string_view words) {
    const std::string text = describe(path);
    int found = 0;
    for (std::size_t at = text.find(words); at != std::string::npos; at = text.find(words, at + 1)) ++found;
    return found;
  };
  CHECK(times("plasticity", "material.plasticity: ") == 1);
  CHECK(times("plasticity", "\n  failure_strain: ") == 1);
  CHECK(times("plasticity", "with model: ordinary-state, linear-peridynamic-solid, bond-based, correspondence\n") == 1);
  CHECK(times("failure_strain", "failure_strain: ") == 1);
}

TEST_CASE("describe: without a path all keys are listed") {
  const std::string all = describe("");
  for (const auto& entry : perimpact::deck::reference()) CHECK_MESSAGE(all.find(std::string(entry.key()) + ": ") != std::string::npos, entry.path);
}

TEST_CASE("describe: an unknown key yields a suggestion") {
  CHECK(complaint("bodies.poisson_ratio") == "bodies.poisson_ratio: a deck has no such key; did you mean poissons_ratio?");
  CHECK(complaint("colour") == "colour: a deck has no such key; perimpact describe lists all.");
  CHECK(complaint("..") != "");
}

TEST_CASE("reference: every key except maps has a sentence") {
  for (const auto& entry : perimpact::deck::reference()) CHECK_MESSAGE((entry.is_map || !entry.sentence.empty()), entry.path);
}
