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

// fast enough to strike within six steps, and so hard that bonds break, which the shipped plate's do not
const std::vector<std::string> small_plate = {"bodies.plate.spacing=10 mm",
                                              "bodies.plate.shape.box.size=[100 mm, 100 mm, 20 mm]",
                                              "time={end: 3 us, step: 0.5 us}",
                                              "output.history=1.5 us",
                                              "impactors.cylinder.surface.cylinder.panel=5 mm",
                                              "impactors.cylinder.velocity=[0, -500, 0]",
                                              "output.lines={}",
                                              "bodies.plate.material.critical_stretch=1e-3"};

// radius 0: particles start half a spacing behind the edge
const std::string nearer = "impactors.cylinder.position=[0, 70.2 mm, 0]";
// finds no contact with a cylinder along z (fccda/detect/published.hpp)
const std::vector<std::string> by_the_letter = {"contact.impactors.detector=published", "contact.impactors.radius_ratio=0", "contact.impactors.reading=letter",
                                                nearer};

/// The variants of cases/plate_impact/variants.sh with those of the body and its material, and the paddle.
const std::vector<Variant> variants = {
    {"plate_impact"},
    {"plate_impact", {"contact.impactors.detector=analytic"}},
    {"plate_impact", {"impactors.cylinder.region={}"}},
    {"plate_impact", {"contact.impactors.radius_ratio=0", nearer}},
    {"plate_impact", {"bodies.plate.surface_correction=volume"}},
    {"plate_impact", {"bodies.plate.surface_correction=none", "bodies.plate.material.poissons_ratio=0.3"}},
    {"plate_impact", {"bodies.plate.published=true"}},
    {"plate_impact", {"bodies.plate.plane=stress"}},
    {"plate_impact", {"bodies.plate.material.model=linear-peridynamic-solid", "bodies.plate.material.influence=gaussian"}},
    {"plate_impact", {"bodies.plate.material={model: bond-based, youngs_modulus: 191 GPa, density: 8000, critical_stretch: 1e-3}"}},
    {"plate_impact", {"bodies.plate.material.model=correspondence"}},
    {"plate_impact",
     {"bodies.plate.material={model: correspondence, youngs_modulus: 191 GPa, density: 8000, critical_stretch: 1e-3}", "bodies.plate.plane=stress"}},
    {"plate_impact", {"contact.impactors.detector=published", "contact.impactors.radius_ratio=0", "impactors.cylinder.surface.cylinder.panels=quads", nearer}},
    {"plate_impact", by_the_letter},
    // a blade turned to just above the ice; the feeder touches it from the start
    {"ice_paddle",
     {"bodies.ice.spacing=20 mm", "time.end=0.22 ms", "time.step=0.02 ms", "output.history=0.07 ms", "impactors.paddle.surface.rotate=[0, 0, -26 deg]",
      "impactors.paddle.motion.rz={times: [0, 1 ms], velocities: [-400 rad/s, -300 rad/s]}"}},
};

}  // namespace

TEST_CASE("resume: each shipped deck, made small and left off at every step, is the same to the last bit") {
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
    CHECK(whole.impactors()[0].record().touched() == (variant.changes != by_the_letter));
    CHECK(resumed->closing_warnings() == whole.closing_warnings());
  }
}
