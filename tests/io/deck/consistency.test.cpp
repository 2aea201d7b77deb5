#include "io/deck/consistency.hpp"

#include <filesystem>
#include <fstream>

#include "fixtures/temporary_folder.hpp"
#include "io/deck/fixtures.hpp"

using namespace perimpact;
using fixtures::check_complaint;
using fixtures::complaint;
using fixtures::place_of;
using fixtures::plate_with;
using fixtures::read;

TEST_CASE("consistency: published sets the discretisation of the FCCDA paper, and contradictions are refused") {
  const BodySetup body = read(plate_with("    spacing:", "    published: true\n    spacing:")).setup.bodies[0];
  CHECK(body.family.word() == "madenci-oterkus");
  CHECK(body.normalisation.word() == "continuum");
  CHECK(body.surface_correction.word() == "none");
  check_complaint({"    spacing:", "    published: true\n    family: hu-ha-bobaru\n    spacing:", "hu-ha-bobaru",
                   "family is given together with published: true, which sets it; remove one of the two."});
  check_complaint({"    spacing:", "    published: true\n    surface_correction: none\n    spacing:", "none",
                   "surface_correction is given together with published: true, which sets it; remove one of the two."});
  CHECK(complaint(plate_with("    spacing:", "    published: false\n    normalisation: continuum\n    spacing:")) == "");
}

TEST_CASE("consistency: a box is a whole number of spacings, and the nearest valid sizes are named") {
  check_complaint(
      {"0.1, 0.009", "0.1, 0.0095", "[0.2, 0.1, 0.0095]",
       "z of size is 0.0095 m, that is 9.5 spacings of 0.001 m, but it must be a whole number of spacings; use 0.009 m or 0.01 m, or another spacing."});
  check_complaint({"0.1, 0.009", "0.1, 0.0004", "[0.2, 0.1, 0.0004]",
                   "z of size is 0.0004 m, that is 0.4 spacings of 0.001 m, but it must be a whole number of spacings; use 0.001 m, or another spacing."});
  CHECK(complaint(plate_with("0.1, 0.009", "0.1, 0.009000008")) == "");  // 0.9e-6 of it
  CHECK(complaint(plate_with("0.1, 0.009", "0.1, 0.00900001")) != "");   // 1.1e-6 of it
}

TEST_CASE("consistency: one failure criterion at most, and failure requires one") {
  const char* const stretch = "critical_stretch: 0.01, density";
  const auto with_failure = [&](const std::string& keys) { return plate_with("    spacing:", "    failure: {" + keys + "}\n    spacing:"); };
  check_complaint({"density", "critical_stretch: 0.01, fracture_energy: 12, density", "12,",
                   "fracture_energy is given together with critical_stretch, but each alone determines when bonds fail; remove one of the two (perimpact check "
                   "reports what each implies)."});
  check_complaint({"density", "critical_stretch: 0.01, layers: 6, density", "6,",
                   "layers applies to flexural_strength only, which is not given; remove it, or give flexural_strength."});
  CHECK(complaint(with_failure("compression: symmetric"))
            .find("failure is given, but the material never fails; give it a critical_stretch, fracture_energy or flexural_strength, or remove failure.") !=
        std::string::npos);
  const auto breaking = [&](const std::string& keys) {
    std::string text = with_failure(keys);
    return complaint(text.replace(text.find("density"), 7, stretch));
  };
  CHECK(breaking("compression: symmetric") == "");
  CHECK(breaking("compression: limit").ends_with("compression is limit, but critical_compression is missing; give it, such as 0.01."));
  CHECK(breaking("critical_compression: 0.1").ends_with("critical_compression is given, but compression is none; set compression: limit, or remove it."));
  CHECK(breaking("seed: 3").ends_with("seed is given without weibull_modulus, so there is no scatter; give both or none."));
  CHECK(breaking("weibull_modulus: 8, seed: 3") == "");
}

TEST_CASE("consistency: the linear peridynamic solid takes no surface correction") {
  std::string text = plate_with("    spacing:", "    surface_correction: energy\n    spacing:");
  text.replace(text.find("ordinary-state"), 14, "linear-peridynamic-solid");
  CHECK(
      complaint(text).ends_with("surface_correction is energy, but the model linear-peridynamic-solid needs none, since it normalises each particle by its own "
                                "family; remove surface_correction."));
}

TEST_CASE("consistency: correspondence takes no surface correction and no normalisation") {
  const auto with = [](const std::string& line) {
    std::string text = plate_with("    spacing:", "    " + line + "\n    spacing:");
    text.replace(text.find("ordinary-state"), 14, "correspondence");
    return complaint(text);
  };
  CHECK(with("surface_correction: volume")
            .ends_with("surface_correction is volume, but the model correspondence needs none, since it normalises each particle by its own family; remove "
                       "surface_correction."));
  CHECK(with("normalisation: continuum")
            .ends_with("normalisation is continuum, but the model correspondence has the exact energy of uniform strain on every lattice and needs no "
                       "normalisation; remove normalisation."));
  CHECK(with("surface_correction: none") == "");
  CHECK(with("normalisation: lattice") == "");
  CHECK(with("published: true") == "");
}

TEST_CASE("consistency: bodies, impactors and probes share the columns of history.csv") {
  check_complaint({"  cylinder:\n", "  plate:\n", "plate:\n    surface",
                   "the name plate is already in use; bodies, impactors, probes and total share the columns of history.csv, so choose another."});
  check_complaint({"centre:", "cylinder:", "cylinder: {body",
                   "the name cylinder is already in use; bodies, impactors, probes and total share the columns of history.csv, so choose another."});
  check_complaint({"  cylinder:\n", "  total:\n",
                   "total:", "the name total is already in use; bodies, impactors, probes and total share the columns of history.csv, so choose another."});
}

TEST_CASE("consistency: the second table of one body or impactor is not the first of another") {
  check_complaint({"impactors:\n",
                   "  plate_end: {shape: {box: {size: [1, 1, 1]}}, position: [9, 0, 0], spacing: 0.2, material: {model: bond-based, youngs_modulus: 1, "
                   "density: 1}}\nimpactors:\n",
                   "plate_end:", "fragments/plate_end.csv is already a table of plate; choose a name that does not end in _end."});
}

TEST_CASE("consistency: probes and lines are on bodies that exist, at times within the run") {
  check_complaint({"body: plate", "body: plates", "plates", "body is \"plates\", but there is no such body; did you mean plate?"});
  check_complaint({"probes:", "lines: {edge: {body: floe, from: [0, 0, 0], to: [1, 0, 0]}}, probes:", "floe",
                   "body is \"floe\", but there is no such body; known here: plate."});
  check_complaint({"probes:", "lines: {edge: {body: plate, from: [0, 0, 0], to: [0, 0, 0]}}, probes:", "[0, 0, 0]}}",
                   "to equals from, so edge has zero length; move one of the two points."});
  check_complaint({"probes:", "lines: {edge: {body: plate, from: [0, 0, 0], to: [1, 0, 0], times: [1 us, 3 ms]}}, probes:", "[1 us, 3 ms]",
                   "times contains 0.003 s, but the run ends at 0.0002 s; use earlier times or a later end."});
}

TEST_CASE("consistency: the step is not longer than the run") {
  check_complaint({"0.1 us", "1 ms", "1 ms", "step is 0.001 s, longer than the whole run of 0.0002 s; use a smaller step or a later end."});
}

TEST_CASE("consistency: free_dofs contains degrees of freedom, each once") {
  check_complaint({"free_dofs: [y]", "free_dofs: [y, rotation]", "[y, rotation]",
                   "free_dofs contains \"rotation\", which is not a degree of freedom; known are x, y, z, rx, ry, rz."});
  check_complaint({"free_dofs: [y]", "free_dofs: [y, y]", "[y, y]", "free_dofs contains y twice; keep one."});
  CHECK(read(plate_with("free_dofs: [y]", "free_dofs: [x, y, z, rx, ry, rz]")).setup.impactors[0].free_dofs.size() == 6);
  CHECK(read(plate_with("free_dofs: [y]", "free_dofs: []")).setup.impactors[0].free_dofs.empty());
}

TEST_CASE("consistency: the published detector treats particles as points without friction") {
  CHECK(read(plate_with("detector: swept, friction: 0, radius_ratio: 0.5", "detector: published")).setup.contact.impactors.radius_ratio == 0);
  CHECK(read(plate_with("detector: swept, friction: 0, radius_ratio: 0.5", "detector: swept")).setup.contact.impactors.radius_ratio == 0.5);
  CHECK(read(plate_with("detector: swept, friction: 0, radius_ratio: 0.5", "detector: published, variant: literal")).setup.contact.impactors.variant.word() ==
        "literal");
  check_complaint({"detector: swept", "detector: published", "0.5}      #",
                   "radius_ratio is 0.5, but the published detector treats particles as points; set radius_ratio: 0, or detector: swept."});
  check_complaint({"detector: swept, friction: 0, radius_ratio: 0.5", "detector: published, friction: 0.3", "0.3",
                   "friction is 0.3, but the published detector is frictionless, as in the FCCDA paper; set friction: 0, or detector: swept."});
  check_complaint({"detector: swept", "detector: swept, variant: literal", "literal",
                   "variant is literal, but only the published detector has variants, and detector is swept; remove variant, or set detector: published."});
}

TEST_CASE("consistency: crushing in contact requires the swept detector and a contact radius") {
  CHECK(read(plate_with("radius_ratio: 0.5", "crushing_pressure: 2 MPa")).setup.contact.impactors.crushing_pressure == 2e6);
  CHECK(!read(plate_with("radius_ratio: 0.5", "radius_ratio: 0.5")).setup.contact.impactors.crushing_pressure);
  check_complaint({"radius_ratio: 0.5", "radius_ratio: 0, crushing_pressure: 2 MPa", "2 MPa",
                   "crushing_pressure acts on the material within the contact radius of a particle, but radius_ratio is 0; remove one of the two."});
  check_complaint({"detector: swept", "detector: analytic, crushing_pressure: 2 MPa", "2 MPa",
                   "crushing_pressure changes the contact radius of particles, which detector analytic keeps; remove it, or set detector: swept."});
}

TEST_CASE("consistency: parameters of short-range contact require a law") {
  check_complaint({"{law: none}", "{law: none, friction: 0.1}", "0.1}\noutput",
                   "friction is 0.1, but law is none, so there is no short-range contact; set law: repulsive, or remove friction."});
  check_complaint({"{law: none}", "{restitution: 0.5}", "0.5}\noutput",
                   "restitution is 0.5, but law is none, so there is no short-range contact; set law: repulsive, or remove restitution."});
  const auto fragments = read(plate_with("{law: none}", "{law: repulsive, friction: 0.1, stiffness_factor: 3}")).setup.contact.fragments;
  CHECK(fragments.friction == 0.1);
  CHECK(fragments.stiffness_factor == 3);
  CHECK(complaint(plate_with("{law: none}", "{law: none, friction: 0, distance_ratio: 1}")) == "");  // as run.json writes it
}

TEST_CASE("consistency: the analytic detector supports cylinders and spheres only") {
  CHECK(complaint(plate_with("swept", "analytic")) == "");
  std::string text = plate_with("swept", "analytic");
  const std::string cylinder = "{cylinder: {diameter: 0.05, height: 0.025, axis: z, edge_length: 0.001}}";
  text.replace(text.find(cylinder), cylinder.size(), "{box: {size: [1, 1, 1], edge_length: 0.1}}");
  CHECK(complaint(text) ==
        place_of(text, "analytic") +
            ": detector is analytic, which supports cylinders and spheres only, but the surface of cylinder is of another kind; set detector: swept.");
}

TEST_CASE("consistency: the path of a surface file is relative to the deck's folder, and the file must exist") {
  const std::string cylinder = "{cylinder: {diameter: 0.05, height: 0.025, axis: z, edge_length: 0.001}}";
  const std::string text = plate_with(cylinder, "{file: hull.stl, scale: 0.001, orientation: normals}");
  const fixtures::TemporaryFolder folder;
  const std::filesystem::path hull = folder / "hull.stl";
  const auto read_there = [&] { return deck::read_deck_text(text, "deck.yaml", folder.path()); };
  const auto refused = [&](const std::string& sentence) {
    try {
      read_there();
      FAIL("what is no file was accepted");
    } catch (const fccda::InputError& error) {
      CHECK(error.what() == place_of(text, "hull.stl") + ": " + sentence);
    }
  };
  refused("there is no file " + hull.string() + "; relative names start at the deck's folder.");
  std::filesystem::create_directory(hull);
  refused(hull.string() + " is a folder, but a file is needed.");
  std::filesystem::remove(hull);
  std::ofstream(hull) << "solid\n";
  const auto surface = std::get<FileSurface>(read_there().setup.impactors[0].surface);
  CHECK(surface.file == hull.string());
  CHECK(surface.scale == 0.001);
  CHECK(surface.orientation.word() == "normals");
}

TEST_CASE("consistency: boxes of contact bounds are given or fitted, sectors are valid, and the analytic detector takes no fitted bounds") {
  const auto region = [](std::string_view text) { return plate_with("{box: {size: [0.05, 0.05, 0.01]}, on_exceed: clip}", text); };
  const std::string boxes = "boxes: {low: {size: [0.05, 0.05, 0.01], centre: [0, 0, -0.005]}, high: {size: [0.05, 0.05, 0.01]}}";
  for (const std::string& fine :
       {"{box_union: {" + boxes + "}}", std::string("{box_union: {count: 8}}"), std::string("{box_union: {gain: 2 %}}"),
        std::string("{box_union: {count: 8, gain: 0.02}, on_exceed: clip}"), std::string("{box_union: {}}"), std::string("{cylinder_sectors: {}}"),
        std::string("{cylinder_sectors: {sector_angle: 30 deg, start_angle: -15 deg, blades: 4}}"), std::string("{auto: {}}"),
        std::string("{auto: {}, on_exceed: clip}")}) {
    CAPTURE(fine);
    CHECK(complaint(region(fine)) == "");
  }
  const Setup setup = read(region("{box_union: {" + boxes + "}}")).setup;
  const auto& given = std::get<BoxUnionBoundsSetup>(setup.impactors[0].contact_bounds.shape).boxes;
  REQUIRE(given.size() == 2);
  CHECK(given[0].name == "low");
  CHECK(given[0].centre == Vec3d{0, 0, -0.005});

  const auto check = [&](const std::string& text, std::string_view at, const std::string& sentence) {
    CHECK(complaint(region(text)) == place_of(region(text), at) + ": " + sentence);
  };
  check("{box_union: {count: 7, " + boxes + "}}", "7,", "count is given together with boxes, but applies to fitted boxes only; remove one of the two.");
  check("{box_union: {gain: 0.5, " + boxes + "}}", "0.5,", "gain is given together with boxes, but applies to fitted boxes only; remove one of the two.");
  check("{cylinder_sectors: {axis: [0, 0, 0]}}", "[0, 0, 0]}}",
        "axis is [0, 0, 0], which has no direction; give one, such as [0, 0, 1], or omit it to have it fitted.");
  check("{cylinder_sectors: {start_angle: 20 deg}}", "20 deg", "start_angle is given without sector_angle; give both, or omit both to have them fitted.");
  check("{cylinder_sectors: {radius: 0.2, hub_radius: 0.3}}", "0.3}}", "hub_radius is 0.3 m, but the radius of the cylinder is 0.2 m; reduce hub_radius.");

  for (const std::string fitted : {"{auto: {}}", "{box_union: {count: 8}}", "{cylinder_sectors: {}}"}) {
    std::string text = region(fitted);
    text.replace(text.find("detector: swept"), 15, "detector: analytic");
    CHECK(complaint(text) ==
          place_of(text, "contact_bounds:") +
              ": contact_bounds are fitted to the panels of the surface, but the analytic detector uses the exact shape; give a box, or set detector: swept.");
  }
}
