#include "io/deck/deck.hpp"

#include "io/deck/fixtures.hpp"

using namespace perimpact;
using fixtures::complaint;
using fixtures::read;

TEST_CASE("deck: the plate example is read into the expected Setup") {
  const Setup setup = read(fixtures::plate).setup;
  CHECK(setup.title == "Rigid cylinder impacts the edge of a plate (Zhang et al., section 5)");
  CHECK(setup.time.end == 200e-6);
  CHECK(setup.time.step == 1e-7);

  REQUIRE(setup.bodies.size() == 1);
  const BodySetup& plate = setup.bodies[0];
  CHECK(plate.name == "plate");
  CHECK(std::get<BoxSolid>(plate.shape).size == Vec3d{0.2, 0.1, 0.009});
  CHECK(plate.spacing == 0.001);
  CHECK(plate.horizon_ratio == 3.015);
  const auto& material = std::get<OrdinaryStateSetup>(plate.material);
  CHECK(material.youngs_modulus == 191e9);
  CHECK(material.poissons_ratio == 0.25);
  CHECK(material.density == 8000);
  CHECK_FALSE(material.critical_stretch.has_value());

  REQUIRE(setup.impactors.size() == 1);
  const ImpactorSetup& cylinder = setup.impactors[0];
  CHECK(cylinder.name == "cylinder");
  const auto& surface = std::get<CylinderSurface>(cylinder.surface);
  CHECK(surface.diameter == 0.05);
  CHECK(surface.height == 0.025);
  CHECK(surface.axis.word() == "z");
  CHECK(surface.edge_length == 0.001);
  CHECK(cylinder.mass == 1.57);
  CHECK(cylinder.position == Vec3d{0, 0.075, 0});
  CHECK(cylinder.velocity == Vec3d{0, -32, 0});
  CHECK(cylinder.free_dofs == std::vector<std::string>{"y"});
  CHECK(std::get<BoxRegionSetup>(cylinder.contact_bounds.shape).size == Vec3d{0.05, 0.05, 0.01});
  CHECK(cylinder.contact_bounds.on_exceed.word() == "clip");

  CHECK(setup.contact.impactors.detector.as<DetectorKind>() == DetectorKind::swept);
  CHECK(setup.contact.impactors.radius_ratio == 0.5);
  CHECK(setup.output.folder == "results");
  CHECK(setup.output.frames == 40);
  CHECK(setup.output.history_interval == 1e-6);
  REQUIRE(setup.output.probes.size() == 1);
  CHECK(setup.output.probes[0].name == "centre");
  CHECK(setup.output.probes[0].body == "plate");
}

TEST_CASE("deck: bodies and impactors keep their order") {
  const Setup setup = read(fixtures::plate_with("bodies:\n",
                                                "bodies:\n  zebra: {shape: {box: {size: [1, 1, 1]}}, spacing: 0.5, material: {model: ordinary-state, "
                                                "youngs_modulus: 1 GPa, density: 900}}\n"))
                          .setup;
  REQUIRE(setup.bodies.size() == 2);
  CHECK(setup.bodies[0].name == "zebra");
  CHECK(setup.bodies[1].name == "plate");
}

TEST_CASE("deck: messages name the file, and folders and missing files are refused") {
  const std::filesystem::path folder = std::filesystem::path(PROJECT_FOLDER) / "tests/io/deck";
  const auto complaint_of_file = [](const std::filesystem::path& file) {
    try {
      deck::read_deck(file);
    } catch (const fccda::InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  CHECK(complaint_of_file(folder / "no.yaml") == (folder / "no.yaml").string() + ": there is no such file; check the path of the deck.");
  CHECK(complaint_of_file(folder) == folder.string() + ": this is a folder; give the deck in it, for example " + (folder / "deck.yaml").string() + ".");
  // any text file that is no deck
  CHECK(complaint_of_file(folder / "fixtures.hpp").starts_with((folder / "fixtures.hpp").string() + ":"));
}

TEST_CASE("places: a value has its position, an absent one that of its map") {
  const Places places = read(fixtures::plate).places;
  CHECK(places.of("time.step") == fixtures::place_of(fixtures::plate, "0.1 us"));
  CHECK(places.of("bodies.plate.material.density") == fixtures::place_of(fixtures::plate, "8000"));
  CHECK(places.of("bodies.plate") == fixtures::place_of(fixtures::plate, "plate:"));
  CHECK(places.of("bodies.plate.position") == places.of("bodies.plate"));
  CHECK(places.of("impactors.cylinder.surface.cylinder.panel_shape") == fixtures::place_of(fixtures::plate, "cylinder: {diameter"));
  CHECK(places.of("impactors.cylinder.contact_bounds") == fixtures::place_of(fixtures::plate, "contact_bounds:"));
  CHECK(places.of("output.probes.centre.at") == fixtures::place_of(fixtures::plate, "[0,0,0]"));
  CHECK(places.of("nowhere") == "deck.yaml");
  CHECK(places.has("time.step"));
  CHECK_FALSE(places.has("bodies.plate.position"));
}

TEST_CASE("places: columns count characters, not bytes") {
  CHECK(complaint("{title: Stoß ∛ gegen Eis, tiem: 3}") == "deck.yaml:1:27: tiem is not a key of the deck; did you mean time?");
}
