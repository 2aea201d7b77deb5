/// What must hold whatever bytes a file holds: a reader gives panels that are sound, or says in one sentence why not.
#pragma once

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include "base/error.hpp"
#include "mesh/surface.hpp"
#include "mesh_io/read_panels.hpp"

namespace fuzz {

/// Ends the program, so that the fuzzer keeps the input.
inline void expect(bool holds, const char* claim) {
  if (holds) return;
  std::fprintf(stderr, "broken: %s\n", claim);
  std::abort();
}

inline bool is_printable(const std::string& text) {
  return std::none_of(text.begin(), text.end(), [](char c) { return (c >= '\0' && c < ' ') || c == '\x7f'; });
}

inline void expect_sentence(const std::string& sentence) {
  expect(!sentence.empty() && sentence.back() == '.', "a refusal ends like a sentence");
  expect(sentence.size() < 2000, "a refusal is no novel");
  expect(is_printable(sentence), "a refusal can be printed on any terminal");
}

inline void expect_sound(const fccda::Panels& panels) {
  const auto vertices = static_cast<long long>(panels.vertices.size());
  for (const auto& panel : panels.panels)
    for (std::size_t c = 0; c < 4; ++c) expect((panel[c] >= 0 && panel[c] < vertices) || (c == 3 && panel[c] == -1), "vertex numbers are in range");
  for (const fccda::Vec3d& vertex : panels.vertices) expect(is_finite(vertex), "coordinates are finite");
  expect(panels.part.empty() || panels.part.size() == panels.panels.size(), "each panel has a part, or none has");
  for (const std::string& name : panels.part_names) expect(is_printable(name), "names of parts can be printed on any terminal");
  for (const int part : panels.part) expect(part >= 0 && part < static_cast<int>(panels.part_names.size()), "parts are in range");
}

/// Reads the bytes as a file of that name, and makes a surface of what is read.
inline void sound_or_refused(std::string_view bytes, const std::string& name) {
  try {
    const fccda::Panels panels = fccda::parse_panels(bytes, name);
    expect(!panels.panels.empty(), "what is read holds panels");
    expect(panels.panels.size() <= 64 * bytes.size() + 64, "panels are no more than a small multiple of the bytes");
    expect_sound(panels);
    const fccda::Surface surface(panels, {.orientation = fccda::Orientation::normals, .name = name});
    expect(surface.report().area >= 0, "a surface has an area");
  } catch (const fccda::InputError& error) {
    expect_sentence(error.what());
  }
}

}  // namespace fuzz
