/// The plate deck, and the reader's messages for changed copies of it.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"
#include "io/deck/deck.hpp"

namespace fixtures {

inline const std::string plate = R"(title: Rigid cylinder impacts the edge of a plate (Zhang et al., section 5)
time: {end: 200 us, step: 0.1 us}
bodies:
  plate:
    shape: {box: {size: [0.2, 0.1, 0.009]}}
    spacing: 0.001
    horizon_ratio: 3.015
    material: {model: ordinary-state, youngs_modulus: 191 GPa, poissons_ratio: 0.25, density: 8000}
impactors:
  cylinder:
    surface: {cylinder: {diameter: 0.05, height: 0.025, axis: z, edge_length: 0.001}}   # or {file: hull.stl, scale: 0.001}
    mass: 1.57
    position: [0, 0.075, 0]        # of the surface's origin; history gives the centre of mass
    velocity: [0, -32, 0]
    free_dofs: [y]                 # the other degrees of freedom are constrained
    contact_bounds: {box: {size: [0.05, 0.05, 0.01]}, on_exceed: clip}
contact:
  impactors: {detector: swept, friction: 0, radius_ratio: 0.5}      # in spacings, the default (∛V/2 for point clouds); 0 as in the paper
  fragments: {law: none}
output: {folder: results, frames: 40, history_interval: 1 us, probes: {centre: {body: plate, at: [0,0,0]}}}
)";

/// The plate deck with the first `old_text` replaced.
inline std::string plate_with(std::string_view old_text, std::string_view new_text) {
  std::string text = plate;
  const std::size_t at = text.find(old_text);
  REQUIRE_MESSAGE(at != std::string::npos, "the plate deck does not contain: " << old_text);
  return text.replace(at, old_text.size(), new_text);
}

inline perimpact::deck::Deck read(const std::string& text, const std::vector<std::string>& overrides = {}) {
  return perimpact::deck::read_deck_text(text, "deck.yaml", "", overrides);
}

/// Message of the InputError for the deck; empty if it is accepted.
inline std::string complaint(const std::string& text, const std::vector<std::string>& overrides = {}) {
  try {
    read(text, overrides);
    return "";
  } catch (const fccda::InputError& error) {
    return error.what();
  }
}

/// file:line:column of the `occurrence`-th (from 1) `needle` in an ASCII line, counted by hand.
inline std::string place_of(const std::string& text, std::string_view needle, int occurrence = 1) {
  std::size_t at = text.find(needle);
  for (int i = 1; i < occurrence; ++i) at = text.find(needle, at + 1);
  REQUIRE_MESSAGE(at != std::string::npos, "not in the deck: " << needle);
  const std::string before = text.substr(0, at);
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  const std::size_t column = 1 + (line == 1 ? at : at - 1 - before.rfind('\n'));
  return "deck.yaml:" + std::to_string(line) + ":" + std::to_string(column);
}

/// A change to the plate deck and the expected message.
struct Mistake {
  std::string_view old_text, new_text;
  std::string_view at;        ///< position in the changed deck
  std::string_view sentence;  ///< the whole message after the position
};

inline void check_complaint(const Mistake& mistake) {
  const std::string text = plate_with(mistake.old_text, mistake.new_text);
  CHECK(complaint(text) == place_of(text, mistake.at) + ": " + std::string(mistake.sentence));
}

}  // namespace fixtures
