// Errors in a deck: the whole message and its position, counted by hand in the changed text.
#include "io/deck/fixtures.hpp"

using fixtures::check_complaint;
using fixtures::complaint;
using fixtures::place_of;
using fixtures::plate_with;

TEST_CASE("mistakes: a message has the position, the value, the range and the meaning") {
  CHECK(complaint(plate_with("poissons_ratio: 0.25", "poissons_ratio: 0.6")) ==
        "deck.yaml:8:80: poissons_ratio is 0.6, but it must be above -1 and below 0.5. Poisson's ratio ν: an isotropic solid needs -1 < ν < 0.5. "
        "Ice is usually 0.25 to 0.35. 0.25 is the fastest.");
}

TEST_CASE("mistakes: unknown keys, with a suggestion or the map to which they belong") {
  check_complaint({"poissons_ratio", "poisson_ratio", "poisson_ratio", "poisson_ratio is not a key of bodies.plate.material; did you mean poissons_ratio?"});
  check_complaint({"    spacing: 0.001", "    spacng: 0.001", "spacng", "spacng is not a key of bodies.plate; did you mean spacing?"});
  check_complaint({"model:", "modle:", "modle:", "modle is not a key of bodies.plate.material; did you mean model?"});
  check_complaint({"title:", "name:", "name:", "name is not a key of the deck; known here: title, time, bodies, impactors, contact, output."});
  check_complaint({"    spacing: 0.001", "    spacing: 0.001\n    density: 900", "density: 900",
                   "density is not a key of bodies.plate; it belongs to bodies.<name>.material."});
  check_complaint(
      {"model: ordinary-state, youngs", "model: bond-based, youngs", "poissons_ratio",
       "poissons_ratio is not a key of bodies.plate.material; it can be given only with model: ordinary-state, linear-peridynamic-solid, correspondence."});
  check_complaint({"axis: z, edge_length", "scale: 2, edge_length", "scale",
                   "scale is not a key of impactors.cylinder.surface.cylinder; it belongs to impactors.<name>.surface."});
}

TEST_CASE("mistakes: a colon without a space joins key and value") {
  check_complaint({"step: 0.1 us}", "step:0.1}", "step:0.1", "step:0.1 is not a key of time; write a space after the colon."});
}

TEST_CASE("mistakes: a key given twice, at any level, with both places") {
  const std::string text = plate_with("    mass: 1.57", "    mass: 1.57\n    mass: 2");
  CHECK(complaint(text) == "deck.yaml:13:5: mass is given twice in the same map, first at deck.yaml:12:5; keep one of the two.");
  CHECK(
      complaint(plate_with("contact:", "title: again\ncontact:")).starts_with("deck.yaml:17:1: title is given twice in the same map, first at deck.yaml:1:1;"));
  CHECK(complaint(plate_with("{end: 200 us,", "{end: 200 us, end: 1,"))
            .starts_with("deck.yaml:2:21: end is given twice in the same map, first at deck.yaml:2:8;"));
}

TEST_CASE("mistakes: missing keys, at their map, with unit and meaning") {
  check_complaint({"    spacing: 0.001\n", "", "plate:",
                   "bodies.plate lacks spacing [m], a length; for example spacing: 9 mm. Particle spacing Δ of the lattice. Required, except for the shapes "
                   "points and cells, which have none."});
  check_complaint(
      {"time: {end: 200 us, step: 0.1 us}", "time: {}", "time:", "time lacks end [s], a time; for example end: 0.1 us. Time at which the run ends."});
  check_complaint({"    shape: {box: {size: [0.2, 0.1, 0.009]}}\n", "",
                   "plate:", "bodies.plate lacks shape. The solid that is filled with particles, or a file of particles."});
  check_complaint({"{box: {size: [0.2, 0.1, 0.009]}}", "{}", "shape:", "bodies.plate.shape needs one of box, cylinder, sphere, file, points, cells."});
  check_complaint({"model: ordinary-state, ", "",
                   "material:", "bodies.plate.material lacks model. It is one of ordinary-state, linear-peridynamic-solid, bond-based, correspondence."});
  check_complaint({"body: plate, ", "", "centre:", "output.probes.centre lacks body. Name of the body."});
  CHECK(complaint("time: {end: 1}\n") == "deck.yaml: the deck lacks bodies. The deformable bodies, each under a name of your choice.");
  CHECK(complaint("time: {end: 1}\nbodies: {}\n") == "deck.yaml:2:1: bodies is empty; it needs at least one name with its keys.");
  CHECK(complaint("time: {end: 1}\nbodies:\n") == "deck.yaml:2:1: bodies is empty; it needs at least one name with its keys.");
}

TEST_CASE("mistakes: a value of another type") {
  check_complaint(
      {"frames: 40", "frames: 40.5", "40.5", "frames is 40.5, but a whole number is needed. Number of output frames after the one at t = 0. 0: none."});
  check_complaint({"0.001\n", "[0.001]\n", "[0.001]", "spacing is a list, but a length is needed, for example 9 mm."});
  check_complaint({"spacing: 0.001", "spacing: thick", "thick", "spacing is thick, but that is not a number; write a length, for example 9 mm."});
  check_complaint({"spacing: 0.001", "spacing:", "spacing:",
                   "spacing has no value; write one, or leave the key out. Particle spacing Δ of the lattice. Required, except for the shapes points and "
                   "cells, which have none."});
  check_complaint(
      {"[0, -32, 0]", "[0, -32]", "[0, -32]",
       "velocity has 2 numbers, but three are needed: [x, y, z]. Velocity of the centre of mass at t = 0; constrained degrees of freedom keep it."});
  check_complaint(
      {"[0, -32, 0]", "-32", "-32",
       "velocity is -32, but three numbers are needed: [x, y, z]. Velocity of the centre of mass at t = 0; constrained degrees of freedom keep it."});
  check_complaint({"[0, -32, 0]", "[0, fast, 0]", "fast", "y of velocity is fast, but that is not a number; write a velocity, for example 32 m/s."});
  check_complaint({"free_dofs: [y]", "free_dofs: y", "y  ",
                   "free_dofs is y, but a list is needed, such as [a, b]. Free degrees of freedom, which contact and loads may change, of x, y, z, rx, ry, rz. "
                   "The others keep their given velocity or follow motion."});
  check_complaint(
      {"time: {end: 200 us, step: 0.1 us}", "time: 200 us", "200 us", "time is \"200 us\", but a map of keys is needed; perimpact describe time lists them."});
  check_complaint({"title: Rigid", "title: [a]\n#", "[a]", "title is a list, but text is needed. One line that describes the simulation."});
  check_complaint({"    spacing: 0.001", "    spacing: 0.001\n    published: yes", "yes",
                   "published is yes, but true or false is needed. true: the discretisation of Zhang et al. (the FCCDA paper), that is family madenci-oterkus, "
                   "normalisation continuum, surface_correction none; these keys must then be absent."});
}

TEST_CASE("mistakes: a value with the wrong unit") {
  check_complaint({"spacing: 0.001", "spacing: 5 kg", "5 kg", "spacing is \"5 kg\", but that is a mass; write a length, for example 9 mm."});
  check_complaint(
      {"191 GPa", "191 GPA", "191 GPA", "youngs_modulus is \"191 GPA\", but GPA is not a unit; write a pressure or stiffness, for example 9.5 GPa."});
  check_complaint({"    free_dofs:", "    angular_velocity: [0, 0, 3 Hz]\n    free_dofs:", "3 Hz",
                   "z of angular_velocity is \"3 Hz\", but Hz counts cycles, not angle, and is not converted; "
                   "write an angular velocity in rad/s, deg/s or rpm, for example 30 rpm."});
}

TEST_CASE("mistakes: a value out of range, with the range in words") {
  check_complaint({"mass: 1.57", "mass: -2 t", "-2 t", "mass is \"-2 t\", but it must be above 0. Mass; alternatively, give the density."});
  check_complaint({"3.015", "1.5", "1.5", "horizon_ratio is 1.5, but it must be from 2 to 6. Horizon δ over the particle spacing, m = δ/Δ."});
  check_complaint(
      {"friction: 0", "friction: -0.1", "-0.1",
       "friction is -0.1, but it must be at least 0. Coulomb friction coefficient between particles and impactors. The published detector requires 0."});
  check_complaint({"0.1, 0.009", "0, 0.009", "0, 0.009",
                   "y of size is 0, but it must be above 0. Edge lengths in x, y and z; whole multiples of the spacing if the body is only this box."});
  check_complaint({"edge_length: 0.001", "edge_length: 0", "0}}   #",
                   "edge_length is 0, but it must be above 0. Longest panel edge around, along and between the rings of the caps; diagonals of triangles reach "
                   "1.41 times it."});
  check_complaint({"[0.05, 0.05, 0.01]", "[0.05, 0.05, -0.01]", "-0.01", "z of size is -0.01, but it must be above 0. Edge lengths along the surface's axes."});
  check_complaint(
      {"frames: 40", "frames: -1", "-1", "frames is -1, but it must be from 0 to 100000. Number of output frames after the one at t = 0. 0: none."});
}

TEST_CASE("mistakes: a range has its unit where the value may be in another one") {
  const auto of_ice = [](const std::string& plasticity) {
    return complaint(plate_with(
        "{model: ordinary-state, youngs_modulus: 191 GPa, poissons_ratio: 0.25, density: 8000}",
        "{model: bond-based, youngs_modulus: 5 GPa, density: 900, flexural_strength: 0.5 MPa, plasticity: {compressive_strength: 3 MPa, " + plasticity + "}}"));
  };
  CHECK(of_ice("friction_angle: 30 deg").empty());
  CHECK(of_ice("friction_angle: 85 deg").find("friction_angle is \"85 deg\", but it must be from 0 to 80.21 deg. ") != std::string::npos);
  CHECK(of_ice("friction_angle: 80").find("friction_angle is 80, but it must be from 0 to 1.4 rad; write degrees with their unit, as in 30 deg. ") !=
        std::string::npos);
  CHECK(complaint(plate_with("{model: ordinary-state, youngs_modulus: 191 GPa, poissons_ratio: 0.25, density: 8000}",
                             "{model: bond-based, density: 900, ice: {temperature: 263 K, salinity: 5}}"))
            .empty());
  CHECK(complaint(plate_with("{model: ordinary-state, youngs_modulus: 191 GPa, poissons_ratio: 0.25, density: 8000}",
                             "{model: bond-based, density: 900, ice: {temperature: -40, salinity: 5}}"))
            .find("it must be from -22.9 to -0.5 degC. ") != std::string::npos);
}

TEST_CASE("mistakes: a factor has no unit, and a particle set is not named twice") {
  const auto with = [](const std::string& line) { return plate_with("    spacing: 0.001\n", "    spacing: 0.001\n    " + line + "\n"); };
  CHECK(complaint(with("mass_scaling: 10")).empty());
  for (const char* value : {"1000 kg", "x", ".inf", "0.5"}) {
    CAPTURE(value);
    CHECK(complaint(with(std::string("mass_scaling: ") + value)).starts_with("deck.yaml:7:19: mass_scaling is "));
  }
  const std::string failing = plate_with("density: 8000}", "density: 8000, critical_stretch: 0.01}\n    failure: {no_fail: [end, end]}");
  CHECK(complaint(failing) == place_of(failing, "[end, end]") + ": no_fail contains end twice; keep one.");
}

TEST_CASE("mistakes: a word that is not an allowed choice") {
  check_complaint(
      {"detector: swept", "detector: sweept", "sweept", "detector is sweept, but it must be one of swept, published, analytic; did you mean swept?"});
  check_complaint({"axis: z", "axis: up", "up", "axis is up, but it must be one of x, y, z."});
  check_complaint({"model: ordinary-state", "model: elastic", "elastic",
                   "model is elastic, which is unknown; known here: ordinary-state, linear-peridynamic-solid, bond-based, correspondence."});
  check_complaint({"{cylinder: {diameter", "{cone: {diameter", "cone",
                   "cone is not a key of impactors.cylinder.surface; known here: cylinder, sphere, box, hull, propeller, file."});
  check_complaint({"{cylinder: {diameter", "{sphere: {diameter: 1, edge_length: 1}, cylinder: {diameter", "sphere",
                   "impactors.cylinder.surface is both cylinder and sphere; keep one of the two."});
}

TEST_CASE("mistakes: names that cannot be column names") {
  check_complaint({"  plate:", "  ice sheet:", "ice sheet",
                   "\"ice sheet\" cannot be a name in bodies, because names become columns and files; use letters, digits, _ and -."});
  check_complaint(
      {"  cylinder:", "  \"\":", "\"\"", "\"\" cannot be a name in impactors, because names become columns and files; use letters, digits, _ and -."});
}

TEST_CASE("mistakes: invalid YAML and unsupported YAML features") {
  CHECK(complaint("") == "deck.yaml: the deck is empty; it needs at least time and bodies (perimpact describe lists all keys).");
  CHECK(complaint("# nothing\n") == "deck.yaml: the deck is empty; it needs at least time and bodies (perimpact describe lists all keys).");
  CHECK(complaint("- 1\n") == "deck.yaml:1:1: a deck is a map (title: …, time: …, bodies: …), but this is a list; begin with a key and a colon.");
  CHECK(complaint("time: {end: 1\n") ==
        "deck.yaml:2:1: this is not valid YAML (end of map flow not found); check indentation, colons, quotes and brackets here and just before.");
  CHECK(complaint("title: 'a\ntime: {end: 1}\n") == "deck.yaml:3:1: an opening quote before this position is not closed; close it.");
  CHECK(complaint("a: b: c\n").starts_with("deck.yaml:1:5: this is not valid YAML (illegal map value);"));
  CHECK(complaint("time:\n\tend: 1\n") == "deck.yaml:2:1: this line is indented with a tab, which YAML forbids; use spaces.");
  CHECK(complaint("time:\n  \t end: 1\n") == "deck.yaml:2:3: this line is indented with a tab, which YAML forbids; use spaces.");
  CHECK(complaint("---\ntime: {end: 1}\n---\na: 1\n") ==
        "deck.yaml:4:1: a second YAML document begins here, but a deck is a single document; remove the line --- before it.");
  CHECK(complaint("time: &t {end: 1}\nbodies: *t\n") == "deck.yaml:2:9: YAML anchors and aliases (& and *) are not supported in decks; write the value out.");
  CHECK(complaint("time: !!map {end: 1}\n") == "deck.yaml:1:7: YAML tags (!…) are not supported in decks; remove the tag.");
  CHECK(complaint(": 3\n") == "deck.yaml:1:1: a key is missing before the colon.");
  CHECK(complaint("? [1]\n: 3\n") == "deck.yaml:1:3: a list or map is given where a key is expected; keys are single words, and every bracket must be closed.");
  CHECK(complaint(std::string("a: \0", 4)) == "deck.yaml: this is not a text file; a deck is a YAML file.");
  CHECK(complaint("time: {end: \"a\\n" + std::string(100, 'b') + "\"}") ==
        "deck.yaml:1:13: end is \"a " + std::string(58, 'b') + "…\", but that is not a number; write a time, for example 0.1 us.");
  CHECK(complaint("time: {end: 1").starts_with("deck.yaml:2:1: this is not valid YAML (end of map flow not found);"));
  CHECK(complaint("time: {end: " + std::string(5000, '[') + "\n").starts_with("deck.yaml:1:"));
}

TEST_CASE("deck: tabs outside indentation, Windows line ends and a byte order mark are accepted") {
  CHECK(complaint(plate_with("bodies:\n", "bodies:\n\t\n\t# a remark\n")) == "");
  CHECK(complaint(plate_with("spacing: 0.001", "spacing:\t0.001")) == "");
  CHECK(complaint("\xEF\xBB\xBF" + fixtures::plate) == "");
  std::string windows;
  for (const char c : fixtures::plate) windows += c == '\n' ? "\r\n" : std::string(1, c);
  CHECK(complaint(windows) == "");
}
