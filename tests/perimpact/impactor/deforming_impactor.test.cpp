// What a surface that deforms excludes; crushing is refused in crushing.test.cpp.
#include <doctest/doctest.h>

#include <functional>
#include <string>

#include "perimpact/bodies.hpp"
#include "perimpact/deck_model/setup_error.hpp"
#include "perimpact/impactor/impactor.hpp"
#include "perimpact/particles/particles.hpp"

using namespace perimpact;

namespace {

/// "key: sentence" of the refusal of a structure that moves the panels of a cylinder beside a block.
std::string refusal(const std::function<void(ImpactorSetup&, ImpactorContactSetup&)>& change) {
  ImpactorSetup setup;
  setup.name = "pipe";
  setup.surface = CylinderSurface{.diameter = 0.1, .height = 0.1, .edge_length = 0.02};
  setup.mass = 1;
  setup.position = {0, 0, 1};
  ImpactorContactSetup contact;
  change(setup, contact);
  Body block = make_body(fixtures::body_setup({.size = {0.02, 0.02, 0.02}}));
  Particles* const bodies[] = {&block.particles};
  Impactor impactor(setup, contact, bodies);
  try {
    impactor.make_external({}, {});
  } catch (const SetupError& error) {
    return error.key() + ": " + error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("deforming impactor: another detector, remeshing, contact bounds, floating, motion and loads are refused with the reason") {
  CHECK(refusal([](ImpactorSetup&, ImpactorContactSetup& contact) { contact.detector.index = static_cast<int>(DetectorKind::analytic); }) ==
        "contact.impactors.detector: impactor pipe deforms, which needs detector: swept.");
  CHECK(refusal([](ImpactorSetup& setup, ImpactorContactSetup&) { setup.coarsen = CoarseningSetup{.max_deviation = 0.001}; }) ==
        "impactors.pipe: impactor pipe deforms, so that its mesh cannot be coarsened or refined; its vertices carry the modes.");
  CHECK(refusal([](ImpactorSetup& setup, ImpactorContactSetup&) {
          setup.contact_bounds = {BoxRegionSetup{.size = {0.2, 0.2, 0.2}}, Choice{on_exceed_words, 0}};
        }) == "impactors.pipe.contact_bounds: impactor pipe deforms, which excludes contact bounds; remove them.");
  CHECK(refusal([](ImpactorSetup& setup, ImpactorContactSetup&) { setup.floating = FloatingImpactorSetup{}; }) ==
        "impactors.pipe.floating: impactor pipe deforms, which excludes floating; remove one of them.");
  const std::string moved = "impactors.pipe: the surface of impactor pipe is moved by a structure, which excludes velocities, motion and loads.";
  CHECK(refusal([](ImpactorSetup& setup, ImpactorContactSetup&) { setup.velocity = {1, 0, 0}; }) == moved);
  CHECK(refusal([](ImpactorSetup& setup, ImpactorContactSetup&) { setup.loads = {{.name = "push", .force = {1, 0, 0}}}; }) == moved);
}
