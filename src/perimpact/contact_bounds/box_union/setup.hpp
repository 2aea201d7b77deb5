/// Union of boxes, in the deck model.
#pragma once

#include <optional>
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

/// One box of a union.
struct BoundsBoxSetup {
  std::string name;
  Vec3d size{};    ///< [m]
  Vec3d centre{};  ///< [m] from the surface's origin
  static std::span<const Field<BoundsBoxSetup>> fields();
};

/// Union of boxes (example 2), given by name or fitted to the surface.
struct BoxUnionBoundsSetup {
  static constexpr std::string_view name = "box_union";
  std::optional<int> count;    ///< maximum number of fitted boxes
  std::optional<double> gain;  ///< [-] share of the bounding box that a further fitted box must save
  std::vector<BoundsBoxSetup> boxes;
  static std::span<const Field<BoxUnionBoundsSetup>> fields();
  void check(const DeckContext& deck) const;
  bool is_fitted() const { return boxes.empty(); }
  template <class Walker>
  static void sections(Walker& walk, BoxUnionBoundsSetup& bounds) {
    walk.named("boxes", bounds.boxes, fccda::Presence::optional, "Given boxes, each under a name of your choice, instead of count and gain.");
  }
};

}  // namespace perimpact
