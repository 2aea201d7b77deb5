#include "perimpact/body/initial_cracks.hpp"

#include <fmt/format.h>

#include <cstdint>

#include "base/error.hpp"
#include "perimpact/deck_model/setup_error.hpp"
#include "perimpact/discretisation/body_solid.hpp"
#include "perimpact/discretisation/crack.hpp"

namespace perimpact {

namespace {

std::string key_of(const CrackSetup& crack, const BodySetup& body) { return fmt::format("bodies.{}.cracks.{}.polygon", body.name, crack.name); }

Crack crack_of(const CrackSetup& setup, const BodySetup& body, const Particles& particles) {
  const Frame frame = frame_of(body);
  std::vector<Vec3d> corners;
  for (const Vec3d& corner : setup.polygon) corners.push_back(frame.to_world(corner));
  const double tolerance = surface_share * particles.spacing();
  try {
    if (!particles.is_plane()) return Crack(corners, tolerance);
    if (corners.size() != 2)
      throw fccda::InputError(
          fmt::format("the crack has {} corners, but a crack in a plane body is a line of two points, a cut through the thickness.", corners.size()));
    // at any z, it cuts the single layer
    const double z = particles.reference(0).z;
    return Crack::through_thickness({corners[0].x, corners[0].y, z}, {corners[1].x, corners[1].y, z}, tolerance);
  } catch (const fccda::InputError& error) {
    throw SetupError(key_of(setup, body), error.what());
  }
}

}  // namespace

std::vector<CrackCut> cut_first_cracks(const BodySetup& body, const Particles& particles, Family& family) {
  std::vector<CrackCut> cuts;
  if (body.cracks.empty()) return cuts;
  std::vector<Crack> cracks;
  for (const CrackSetup& crack : body.cracks) {
    cracks.push_back(crack_of(crack, body, particles));
    cuts.push_back({crack.name, 0, 0});
  }

  // only particles within the reach of a bond across a crack are tested in detail
  const double reach = family.horizon() + particles.spacing();
  std::vector<std::uint8_t> is_near(particles.slots(), 0);
  for (std::size_t slot = 0; slot < particles.slots(); ++slot) {
    if (!particles.is_occupied(slot)) continue;
    const Vec3d X = particles.reference(slot);
    for (std::size_t c = 0; c < cracks.size(); ++c) {
      if (cracks[c].may_reach(X, reach)) is_near[slot] = 1;
      if (particles.owns(slot) && cracks[c].contains(X)) ++cuts[c].in_plane;
    }
  }
  family.cut([&](std::size_t i, std::size_t j) {
    if (is_near[i] == 0 || is_near[j] == 0) return false;
    const Vec3d Xi = particles.reference(i), Xj = particles.reference(j);
    for (std::size_t c = 0; c < cracks.size(); ++c)
      if (cracks[c].cuts(Xi, Xj)) return ++cuts[c].bonds, true;
    return false;
  });
  for (std::size_t c = 0; c < cuts.size(); ++c) {
    Ranks& ranks = particles.share().ranks();
    cuts[c].bonds = static_cast<std::size_t>(ranks.sum(static_cast<std::int64_t>(cuts[c].bonds))) / 2;  // each was counted at both ends
    cuts[c].in_plane = static_cast<std::size_t>(ranks.sum(static_cast<std::int64_t>(cuts[c].in_plane)));
    if (cuts[c].bonds == 0)
      throw SetupError(
          key_of(body.cracks[c], body),
          fmt::format("the crack {} cuts no bond of body {}: it lies outside the body, or coincides with another crack; its corners are relative to the "
                      "body's position, in metres.",
                      cuts[c].name, body.name));
  }
  return cuts;
}

std::vector<std::string> warnings_of(const std::vector<CrackCut>& cracks, const std::string& body) {
  std::vector<std::string> warnings;
  for (const CrackCut& crack : cracks)
    if (crack.in_plane > 0)
      warnings.push_back(
          fmt::format("{} particles of body {} lie in the plane of crack {} and are assigned to the side of its normal. Move the crack by half a spacing "
                      "to place it between two layers.",
                      crack.in_plane, body, crack.name));
  return warnings;
}

}  // namespace perimpact
