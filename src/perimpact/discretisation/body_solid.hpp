/// The solid of a body: its shape and parts united, without the holes.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "perimpact/deck_model/setup.hpp"
#include "perimpact/discretisation/solid.hpp"

namespace perimpact {

/// How far outside a solid a particle may be and still counts as on its surface, and so inside, in spacings: particles on a face are not left
/// to rounding. The same everywhere: a hole takes out, and a region names, the particles on its surface too.
inline constexpr double surface_share = 1e-6;

/// The axes of the body in the world.
Frame frame_of(const BodySetup& body);

/// The solid of a part, hole or region. `key`: of the setup, "bodies.plate.holes.drain", for the SetupError where it cannot be made.
Solid solid_of(const SolidSetup& solid, const BodySetup& body, const std::string& key);

class BodySolid {
 public:
  /// Of a body whose shape is a solid. Throws SetupError where a file cannot be used.
  explicit BodySolid(const BodySetup& body);

  bool contains(const Vec3d& point, double margin = 0) const;
  /// Sets `inside` to 1 for those points of the row that are in the body, to 0 for the others.
  void mark(const Row& row, double margin, std::span<std::uint8_t> inside) const;

  fccda::Box bounds() const;                                              ///< [m] of shape and parts
  double thickness() const { return united_.front().bounds().size().z; }  ///< [m] of the shape along z: of a plane body
  std::optional<double> volume() const;                                   ///< [m³] where it is known: of one solid without parts and holes

 private:
  std::vector<Solid> united_;
  std::vector<Solid> holes_;
};

}  // namespace perimpact
