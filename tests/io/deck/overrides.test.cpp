#include "io/deck/overrides.hpp"

#include "fixtures/tolerance.hpp"
#include "io/deck/fixtures.hpp"

using namespace perimpact;
using fixtures::complaint;
using fixtures::plate;
using fixtures::read;

TEST_CASE("overrides: values replace those of the deck, in order, with units and lists") {
  const Setup setup =
      read(plate, {"contact.impactors.detector=analytic", "impactors.cylinder.surface.cylinder.edge_length=0.5 mm", "bodies.plate.material.poissons_ratio=0.3",
                   "output.frames=7", "output.frames=0", "impactors.cylinder.velocity=[0, -3 kn, 0]", "title=a = b"})
          .setup;
  CHECK(setup.contact.impactors.detector.word() == "analytic");
  CHECK(std::get<CylinderSurface>(setup.impactors[0].surface).edge_length == 0.0005);
  CHECK(std::get<OrdinaryStateSetup>(setup.bodies[0].material).poissons_ratio == 0.3);
  CHECK(setup.output.frames == 0);
  CHECK(setup.impactors[0].velocity.y == fixtures::relative(-1.5433333, 1e-7));  // 3 · 1852/3600, to the digits written
  CHECK(setup.title == "a = b");
}

TEST_CASE("overrides: absent keys are created, a whole map is replaced") {
  const Setup setup = read(plate, {"bodies.plate.position=[1, 0, 0]", "output.probes.edge.body=plate", "output.probes.edge.at=[0, 0.05, 0]",
                                   "impactors.cylinder.surface={sphere: {diameter: 1 m, edge_length: 1 cm}}"})
                          .setup;
  CHECK(setup.bodies[0].position.x == 1);
  REQUIRE(setup.output.probes.size() == 2);
  CHECK(setup.output.probes[1].name == "edge");
  CHECK(std::get<SphereSurface>(setup.impactors[0].surface).diameter == 1);
}

TEST_CASE("overrides: errors are reported at their --set") {
  CHECK(complaint(plate, {"bodies.plate.materail.density=3"}) ==
        "--set bodies.plate.materail.density: materail is not a key of bodies.plate; did you mean material?");
  CHECK(complaint(plate, {"output.frame=3"}) == "--set output.frame: frame is not a key of output; did you mean frames?");
  CHECK(complaint(plate, {"bodies.plat.spacing=1"}) == "--set bodies.plat.spacing: the deck has no bodies.plat; did you mean plate?");
  CHECK(complaint(plate, {"time.step=3 m"}) == "--set time.step: step is \"3 m\", but that is a length; write a time, for example 0.1 us.");
  CHECK(complaint(plate, {"time.step="}) ==
        "--set time.step: step has no value; write one, or leave the key out. Time step. Where absent, 0.9 times the stable time step estimated after Silling "
        "and Askari, the smallest over all bodies.");
  CHECK(complaint(plate, {"time.step.x=3"}) == "--set time.step.x: time.step is \"0.1 us\", not a map, and has no keys to set; set time.step itself.");
  CHECK(complaint(plate, {"time"}) == "--set time: expected key.path=value, for example --set output.frames=0.");
  CHECK(complaint(plate, {"=3"}) == "--set =3: expected key.path=value, for example --set output.frames=0.");
  CHECK(complaint(plate, {"time..end=3"}) == "--set time..end=3: expected key.path=value, for example --set output.frames=0.");
  CHECK(complaint(plate, {"time={end: 1"}) ==
        "--set time: a list or map is given where a key is expected; keys are single words, and every bracket must be closed.");
  CHECK(complaint(plate, {"title='a"}) == "--set title: an opening quote before this position is not closed; close it.");
  CHECK(complaint(plate, {"time={end: 1, end: 2}"}) == "--set time: end is given twice in the same map, first at --set time; keep one of the two.");
}

TEST_CASE("overrides: positions name the --set for the values it sets only") {
  const Places places = read(plate, {"time.step=1 us"}).places;
  CHECK(places.of("time.step") == "--set time.step");
  CHECK(places.of("time.end") == fixtures::place_of(plate, "200 us"));
  CHECK(places.of("time") == fixtures::place_of(plate, "time:"));
  CHECK(read(plate, {"impactors.cylinder.surface={sphere: {diameter: 1, edge_length: 1}}"}).places.of("impactors.cylinder.surface") ==
        "--set impactors.cylinder.surface");
}
