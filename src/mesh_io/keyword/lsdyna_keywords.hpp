/// What a keyword of LS-DYNA means to a reader of meshes.
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
    parts,  ///< heading and number, with more cards behind
    part,   ///< the same, but for one part: how many cards follow depends on their contents
    include,
    maker,  ///< moves nodes, makes or copies elements
    other   ///< shells or solids of a kind that cannot be read
  };
  Kind kind = Kind::skipped;

  /// Cards that follow the one (or two) that define an element or part.
  int more_cards = 0;
  bool has_thickness = false;  ///< shells: a card more, and another where middle nodes are given
  bool has_inertia = false;    ///< parts: a card more where the fifth field of the first one says 1
};

/// `name`: without star, in capitals: ELEMENT_SHELL_THICKNESS_OFFSET. (LS-DYNA Keyword User's Manual I.)
LsdynaBlock lsdyna_block(std::string_view name);

}  // namespace fccda
