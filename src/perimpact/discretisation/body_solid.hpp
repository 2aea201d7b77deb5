/// Solid geometry of a body: Boolean union of shape and added solids, minus the holes.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "perimpact/deck_model/setup.hpp"
#include "perimpact/discretisation/solid.hpp"

namespace perimpact {

/// Tolerance of the inside test, in spacings: particles this close to the surface of a solid count as inside, independent of rounding. Holes
/// and particle sets also include the particles on their surface.
inline constexpr double surface_share = 1e-6;

/// Local frame of the body.
Frame frame_of(const BodySetup& body);

/// The solid of an added solid, hole or particle set. `key`: of the setup, "bodies.plate.holes.drain", for the SetupError if it is invalid.
Solid solid_of(const SolidSetup& solid, const BodySetup& body, const std::string& key);

class BodySolid {
 public:
  /// `body`: its shape must be a solid. Throws SetupError for an invalid file.
  explicit BodySolid(const BodySetup& body);

  bool contains(const Vec3d& point, double margin = 0) const;
  /// Sets `inside` to 1 for points of the row inside the body, else to 0.
  void mark(const Row& row, double margin, std::span<std::uint8_t> inside) const;

  fccda::Box bounds() const;                                              ///< [m] of shape and added solids
  double thickness() const { return united_.front().bounds().size().z; }  ///< [m] of the shape along z: of a plane body
  std::optional<double> volume() const;                                   ///< [m³] if known: of one solid without added solids and holes

 private:
  std::vector<Solid> united_;
  std::vector<Solid> holes_;
};

}  // namespace perimpact
