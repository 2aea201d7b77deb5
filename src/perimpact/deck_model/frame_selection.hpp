/// What of a body is written to output frames: a selection of its particles.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/parameter.hpp"
#include "base/vec3.hpp"

namespace perimpact {

using fccda::Field;
using fccda::Vec3d;

/// Fields of the particles in output frames, beside positions. A body has those of its material and discretisation.
inline constexpr std::string_view frame_field_words[] = {"displacement", "velocity", "damage", "plastic_strain", "fragment", "original"};

/// Axis-aligned box, faces included.
struct FrameBoxSetup {
  std::string name;
  Vec3d lower{}, upper{};  ///< [m] in the reference configuration
  static std::span<const Field<FrameBoxSetup>> fields();
  bool contains(const Vec3d& reference) const;  ///< [m]
};

/// The particles in output frames: of those in the boxes (of all, where there are none) the ones that meet at least one of the criteria (all, where there
/// is none).
struct FrameParticlesSetup {
  bool surface = false;                ///< at the surface of the reference configuration
  std::optional<int> stride;           ///< every n-th in each direction of the lattice
  std::optional<double> damage_above;  ///< [-]
  bool detached = false;               ///< outside the largest fragment
  std::vector<FrameBoxSetup> boxes;
  static std::span<const Field<FrameParticlesSetup>> fields();

  bool varies() const { return damage_above.has_value() || detached; }              ///< the selection changes during the run
  bool has_criterion() const { return surface || stride.has_value() || varies(); }  ///< beside boxes
};

}  // namespace perimpact
