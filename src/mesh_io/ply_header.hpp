/// PLY header: the elements that follow and the types of their properties.
///
/// Format: G. Turk, The PLY Polygon File Format (1994).
#pragma once

#include <bit>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mesh_io/file/number_type.hpp"
#include "mesh_io/file/words.hpp"

namespace fccda {

struct PlyProperty {
  std::string_view name;
  NumberType type;
  std::optional<NumberType> count;  ///< for lists: type of the preceding count
};

struct PlyElement {
  std::string_view name;
  std::size_t count = 0;
  std::vector<PlyProperty> properties;

  /// Minimum size of one such element [bytes], in a binary or text file.
  std::size_t least_bytes(bool is_text) const;
};

struct PlyHeader {
  std::optional<std::endian> order;  ///< byte order of binary numbers; empty: text
  std::vector<PlyElement> elements;

  bool is_text() const { return !order; }
  const PlyElement* element(std::string_view name) const;  ///< nullptr where there is none
};

/// Reads up to the first byte after the header. Throws InputError with the line where the header is invalid.
PlyHeader parse_ply_header(Words& words);

}  // namespace fccda
