/// Contact bounds chosen for the surface, in the deck model.
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

/// Contact bounds chosen automatically for the surface.
struct AutoBoundsSetup {
  static constexpr std::string_view name = "auto";
  static std::span<const Field<AutoBoundsSetup>> fields();
  void check(const DeckContext& deck) const;
  bool is_fitted() const { return true; }
};

}  // namespace perimpact
