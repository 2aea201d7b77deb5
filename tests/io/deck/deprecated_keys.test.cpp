#include "io/deck/deprecated_keys.hpp"

#include <fstream>
#include <string>
#include <vector>

#include "fixtures/temporary_folder.hpp"
#include "io/deck/fixtures.hpp"
#include "io/deck/setup_to_text.hpp"

using namespace perimpact;

namespace {

const std::string current = R"(
time: {end: 1 ms}
bodies:
  sheet:
    shape: {box: {size: [8, 4, 1]}}
    spacing: 0.5
    material: {model: linear-peridynamic-solid, youngs_modulus: 2 GPa, density: 900, critical_stretch: 1e-3, influence: constant}
    add: {knob: {shape: {box: {size: [1, 1, 1]}}, position: [0, 0, 1]}}
    particle_sets: {rim: {shape: {box: {size: [1, 4, 1]}}, position: [-3.5, 0, 0]}}
    boundary_conditions: {rim: {fixed: {particle_set: rim}}, lift: {body_force: {particle_set: rim, force_density: [0, 0, 1]}}}
impactors:
  ship:
    surface: {hull: {length: 40, breadth: 8, draft: 3, stem_angle: 30 deg, waterline_angle: 30 deg, edge_length: 1, bow_edge_length: 0.5}}
    coarsen: {max_deviation: 1 mm, max_edge_length: 4}
    refine: {bow: {edge_length: 0.25, surface_part: bow}}
    density: 500
    position: [60, 0, 0]
    free_dofs: [x]
    contact_bounds: {box: {size: [50, 10, 12]}, on_exceed: clip}
    gauges: {bow: {surface_parts: [bow]}}
  screw:
    surface: {propeller: {diameter: 4, blades: 4, pitch_ratio: 0.8, area_ratio: 0.6, edge_length: 0.3, blade_edge_length: 0.1}}
    mass: 10
    position: [0, 40, 0]
  rod:
    surface: {cylinder: {diameter: 1, height: 1, edge_length: 0.2, panel_shape: quads}}
    mass: 1
    position: [0, -40, 0]
  part:
    surface: {file: part.stl, file_parts: [a], mirror_merge: x, orientation: normals}
    mass: 1
    position: [0, 80, 0]
contact: {impactors: {detector: published, variant: literal, initial_overlap: remove}}
output: {history_interval: 1 us, checkpoint_interval: 10 s}
)";

const std::string former = R"(
time: {end: 1 ms}
bodies:
  sheet:
    shape: {box: {size: [8, 4, 1]}}
    spacing: 0.5
    material: {model: linear-peridynamic-solid, youngs_modulus: 2 GPa, density: 900, critical_stretch: 1e-3, influence: one}
    parts: {knob: {shape: {box: {size: [1, 1, 1]}}, position: [0, 0, 1]}}
    regions: {rim: {shape: {box: {size: [1, 4, 1]}}, position: [-3.5, 0, 0]}}
    boundaries: {rim: {fixed: {region: rim}}, lift: {body_force: {region: rim, force_density: [0, 0, 1]}}}
impactors:
  ship:
    surface: {hull: {length: 40, breadth: 8, draft: 3, stem_angle: 30 deg, waterline_angle: 30 deg, panel: 1, bow_panel: 0.5}}
    coarsen: {distance: 1 mm, panel: 4}
    refine: {bow: {panel: 0.25, part: bow}}
    density: 500
    position: [60, 0, 0]
    free: [x]
    region: {box: {size: [50, 10, 12]}, outside: clip}
    gauges: {bow: {parts: [bow]}}
  screw:
    surface: {propeller: {diameter: 4, blades: 4, pitch_ratio: 0.8, area_ratio: 0.6, panel: 0.3, edge_panel: 0.1}}
    mass: 10
    position: [0, 40, 0]
  rod:
    surface: {cylinder: {diameter: 1, height: 1, panel: 0.2, panels: quads}}
    mass: 1
    position: [0, -40, 0]
  part:
    surface: {file: part.stl, parts: [a], complete: x, outside: normals}
    mass: 1
    position: [0, 80, 0]
contact: {impactors: {detector: published, reading: letter, starting_inside: remove}}
output: {history: 1 us, checkpoint_every: 10 s}
)";

/// With the surface part.stl in the deck's folder.
deck::Deck read(const std::string& text, const std::vector<std::string>& overrides = {}) {
  static const fixtures::TemporaryFolder folder;
  fixtures::put(folder.path() / "part.stl", "solid\n");
  return deck::read_deck_text(text, "deck.yaml", folder.path(), overrides);
}

std::string complaint(const std::string& text) {
  try {
    read(text);
    return "";
  } catch (const fccda::InputError& error) {
    return error.what();
  }
}

std::vector<std::string> warnings_of(const std::string& deck, std::vector<std::string> overrides = {}) { return read(deck, overrides).warnings; }

}  // namespace

TEST_CASE("deprecated keys: a deck with former names equals that with current names, with one warning per name and position, grouped beyond three") {
  CHECK(warnings_of(current).empty());
  const deck::Deck deck = read(former);
  CHECK(deck::setup_to_text(deck.setup) == deck::setup_to_text(read(current).setup));
  CHECK(deck.warnings.size() == 24);  // of 28, five about one name are grouped
  CHECK(deck.warnings.front() == "deck.yaml:8:5: `parts` is now called `add`; the former name is accepted until release 0.2.0.");
  CHECK(deck.places.of("bodies.sheet.add") == "deck.yaml:8:5");
}

TEST_CASE("deprecated keys: a former name in --set changes the value of a deck in current names, as a whole or in part") {
  const Setup changed = read(current, {"bodies.sheet.boundaries.rim.fixed.region=none", "output.history=2 us", "impactors.ship.region={}"}).setup;
  CHECK(std::get<FixedSetup>(changed.bodies[0].boundary_conditions[0].kind).particle_set == "none");
  CHECK(changed.bodies[0].boundary_conditions.size() == 2);
  CHECK(changed.output.history_interval == 2e-6);
  CHECK(std::holds_alternative<std::monostate>(changed.impactors[0].contact_bounds.shape));
}

TEST_CASE("deprecated keys: a current name in --set changes the value of a deck in former names, as a whole or in part") {
  const Setup changed =
      read(former, {"bodies.sheet.boundary_conditions.rim.fixed.particle_set=none", "output.history_interval=2 us", "impactors.ship.contact_bounds={}"}).setup;
  CHECK(std::get<FixedSetup>(changed.bodies[0].boundary_conditions[0].kind).particle_set == "none");
  CHECK(changed.bodies[0].boundary_conditions.size() == 2);
  CHECK(changed.output.history_interval == 2e-6);
  CHECK(std::holds_alternative<std::monostate>(changed.impactors[0].contact_bounds.shape));
}

TEST_CASE("deprecated keys: a deck that gives one value under both names is refused, maps under both are merged") {
  const std::string text = current;
  CHECK(complaint(text + "time2: 0\n").find("time2") != std::string::npos);
  std::string both = text;
  both.replace(both.find("history_interval: 1 us"), 22, "history_interval: 1 us, history: 1 us");
  CHECK(complaint(both).ends_with("`history` is the former name of `history_interval`, and the deck gives both; keep `history_interval`."));
  std::string sets = text;
  sets.replace(sets.find("    boundary_conditions"), 0, "    regions: {bow: {shape: {box: {size: [1, 4, 1]}}, position: [3.5, 0, 0]}}\n");
  CHECK(read(sets).setup.bodies[0].particle_sets.size() == 2);
}

TEST_CASE("deprecated keys: user-chosen names are never renamed") {
  std::string text = current;
  for (std::size_t at = text.find("rim"); at != std::string::npos; at = text.find("rim", at + 1)) text.replace(at, 3, "regions");
  CHECK(warnings_of(text).empty());
  CHECK(read(text).setup.bodies[0].particle_sets[0].name == "regions");
}
