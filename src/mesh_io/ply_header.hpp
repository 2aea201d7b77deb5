/// The header of a PLY file: which elements follow it, and of what their properties are made.
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
  std::optional<NumberType> count;  ///< of a list: the type of the count before it
};

struct PlyElement {
  std::string_view name;
  std::size_t count = 0;
  std::vector<PlyProperty> properties;

  /// Of one of these elements: bytes in a binary file, and at least so many in a text.
  std::size_t least_bytes(bool is_text) const;
};

struct PlyHeader {
  std::optional<std::endian> order;  ///< of binary numbers; none: they are text
  std::vector<PlyElement> elements;

  bool is_text() const { return !order; }
  const PlyElement* element(std::string_view name) const;  ///< nothing where there is none
};

/// Reads up to the first byte behind the header. Throws InputError with the line where it is none.
PlyHeader parse_ply_header(Words& words);

}  // namespace fccda
