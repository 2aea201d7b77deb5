/// One box, in the deck model.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/parameter.hpp"
#include "base/vec3.hpp"
#include "perimpact/deck_model/deck_context.hpp"

namespace perimpact {

using fccda::Field;
using fccda::Vec3d;

/// One box fixed to the impactor, outside which contact is not searched (Zhang et al., section 3.1, example 1).
struct BoxRegionSetup {
  static constexpr std::string_view name = "box";
  Vec3d size{};    ///< [m]
  Vec3d centre{};  ///< [m] from the surface's origin
  static std::span<const Field<BoxRegionSetup>> fields();
  void check(const DeckContext& deck) const;
  bool is_fitted() const { return false; }
};

}  // namespace perimpact
