#include <doctest/doctest.h>

#include <optional>

#include "fixtures/snapshot.hpp"
#include "io/deck/deck.hpp"
#include "perimpact/simulation/simulation.hpp"

using namespace perimpact;

namespace {

struct Variant {
  const char* deck;
  std::vector<std::string> changes = {};
};

// fast enough for contact within six steps, and for bond failure, which the shipped plate does not show
const std::vector<std::string> small_plate = {"bodies.plate.spacing=10 mm",
                                              "bodies.plate.shape.box.size=[100 mm, 100 mm, 20 mm]",
                                              "time={end: 3 us, step: 0.5 us}",
                                              "output.history_interval=1.5 us",
                                              "impactors.cylinder.surface.cylinder.edge_length=5 mm",
                                              "impactors.cylinder.velocity=[0, -500, 0]",
                                              "output.lines={}",
                                              "bodies.plate.material.critical_stretch=1e-3"};

// radius 0: particles start half a spacing inside the edge
const std::string nearer = "impactors.cylinder.position=[0, 70.2 mm, 0]";
// finds no contact with a cylinder along z (fccda/detect/published.hpp)
const std::vector<std::string> by_the_letter = {"contact.impactors.detector=published", "contact.impactors.radius_ratio=0", "contact.impactors.variant=literal",
                                                nearer};

// coarse, and loaded so that bonds fail at once
const std::vector<std::string> small_glass = {"bodies.glass.spacing=2 mm",
                                              "time={end: 6 us, step: 0.1 us}",
                                              "output.history_interval=0.35 us",
                                              "bodies.glass.boundary_conditions.pull_up.pressure.value=-1 GPa",
                                              "bodies.glass.particle_sets.left={shape: {box: {size: [8 mm, 40 mm, 2 mm]}}, position: [-46 mm, 0, 0]}",
                                              "bodies.glass.boundary_conditions.edge={absorbing: {particle_set: left, face: -x}}"};
// quasi-static: from one equilibrium state to the next
const std::vector<std::string> pulled_glass = {"bodies.glass.spacing=2 mm", "time={end: 1 s, relax: {increments: 4, tolerance: 0.01}}", "output={}",
                                               "bodies.glass.boundary_conditions={hold: {fixed: {particle_set: bottom}}, pull: {prescribed: {particle_set: "
                                               "top, y: {times: [0, 1], displacements: [0, 14 um]}}}}"};

/// The coarse plate is wide: contact with a plane body requires a surface that extends from 1.5 spacings below to 1.5 spacings above it.
const std::string upright = "impactors.cylinder.surface.cylinder.height=80 mm";

/// The variants of cases/plate_impact/variants.sh, those of the body and its material, and the paddle.
const std::vector<Variant> of_impact = {
    {"plate_impact"},
    {"plate_impact", {"contact.impactors.detector=analytic"}},
    {"plate_impact", {"impactors.cylinder.contact_bounds={}"}},
    {"plate_impact", {"contact.impactors.radius_ratio=0", nearer}},
    {"plate_impact", {"bodies.plate.surface_correction=volume"}},
    {"plate_impact", {"bodies.plate.surface_correction=none", "bodies.plate.material.poissons_ratio=0.3"}},
    {"plate_impact", {"bodies.plate.published=true"}},
    {"plate_impact", {"bodies.plate.plane=stress", upright}},
    {"plate_impact", {"bodies.plate.material.model=linear-peridynamic-solid", "bodies.plate.material.influence=gaussian"}},
    {"plate_impact", {"bodies.plate.material={model: bond-based, youngs_modulus: 191 GPa, density: 8000, critical_stretch: 1e-3}"}},
    {"plate_impact", {"bodies.plate.material.model=correspondence"}},
    {"plate_impact",
     {"bodies.plate.material={model: correspondence, youngs_modulus: 191 GPa, density: 8000, critical_stretch: 1e-3}", "bodies.plate.plane=stress", upright}},
    {"plate_impact",
     {"contact.impactors.detector=published", "contact.impactors.radius_ratio=0", "impactors.cylinder.surface.cylinder.panel_shape=quads", nearer}},
    {"plate_impact", by_the_letter},
    {"plate_impact", {"bodies.plate.material.model=correspondence"}},
    // a blade rotated to just above the ice; the feeder is in contact with it from the start
    {"ice_paddle",
     {"bodies.ice.spacing=20 mm", "time.end=0.22 ms", "time.step=0.02 ms", "output.history_interval=0.07 ms", "impactors.paddle.surface.rotate=[0, 0, -26 deg]",
      "impactors.paddle.motion.rz={times: [0, 1 ms], velocities: [-400 rad/s, -300 rad/s]}"}},
};

const std::vector<Variant> of_fracture = {
    {"kalthoff_winkler",
     {"bodies.plate.spacing=10 mm", "bodies.plate.shape.box.size=[200 mm, 100 mm, 20 mm]", "time={end: 3 us, step: 0.5 us}", "output.history_interval=0.7 us",
      "impactors.projectile.surface.cylinder.edge_length=10 mm", "impactors.projectile.velocity=[0, -500, 0]", "bodies.plate.material.critical_stretch=1e-3"}},
    {"crack_branching", small_glass},
    {"crack_branching", pulled_glass},
};

void expect_same_when_resumed_at_every_step(const std::vector<Variant>& variants) {
  for (const Variant& variant : variants) {
    std::vector<std::string> changes = variant.changes;
    if (std::string(variant.deck) == "plate_impact") changes.insert(changes.begin(), small_plate.begin(), small_plate.end());
    const Setup setup = deck::read_deck(std::string(PROJECT_FOLDER "/cases/") + variant.deck + "/deck.yaml", changes).setup;
    CAPTURE(&variant - variants.data());
    Simulation whole(setup);
    std::optional<Simulation> resumed(std::in_place, setup);
    while (!whole.clock().is_finished()) {
      const fixtures::Snapshot snapshot(*resumed);
      resumed.emplace(setup);
      snapshot.give(*resumed);
      whole.step(), resumed->step();
      REQUIRE(fixtures::Snapshot(whole).differences(fixtures::Snapshot(*resumed)) == std::vector<std::string>{});
    }
    const bool resolved = !whole.impactors().empty() && whole.impactors()[0].record().was_in_contact();
    const bool something_happened = resolved || whole.bodies()[0].internal.broken_bonds() > 0;
    CHECK(something_happened == (variant.changes != by_the_letter));
    CHECK(resumed->closing_warnings() == whole.closing_warnings());
  }
}

}  // namespace

TEST_CASE("resume: each shipped deck of impact, reduced and restarted at every step, is bitwise identical") {
  expect_same_when_resumed_at_every_step(of_impact);
}

TEST_CASE("resume: likewise the decks of fracture, with boundary conditions, with an absorbing layer, and relaxed") {
  expect_same_when_resumed_at_every_step(of_fracture);
}
