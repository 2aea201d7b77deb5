/// LS-DYNA keywords as a mesh reader classifies them.
#pragma once

#include <cstdint>
#include <string_view>

namespace fccda {

struct LsdynaBlock {
  enum class Kind : std::uint8_t {
    skipped,
    usual_width,  ///< *KEYWORD
    end,          ///< *END
    nodes,
    shells,
    solids,
    thick_shells,
    parts,  ///< heading and number, followed by more cards
    part,   ///< the same for a single part: the number of cards depends on their contents
    include,
    maker,  ///< moves nodes, or generates or copies elements
    other   ///< unsupported shells or solids
  };
  Kind kind = Kind::skipped;

  /// Number of cards after the one (or two) that define an element or part.
  int more_cards = 0;
  bool has_thickness = false;  ///< shells: one additional card, and another where mid-side nodes are given
  bool has_inertia = false;    ///< parts: one additional card where the fifth field of the first one is 1
};

/// Classifies a keyword. `name`: in capitals without asterisk, ELEMENT_SHELL_THICKNESS_OFFSET (LS-DYNA Keyword User's Manual I).
LsdynaBlock lsdyna_block(std::string_view name);

}  // namespace fccda
