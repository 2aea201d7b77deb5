/// Cracks that a body has from the start: bonds that cross them are cut before the first step, after the surface correction, which stays that of
/// the whole body. They count as damage.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "perimpact/deck_model/setup.hpp"
#include "perimpact/family/family.hpp"
#include "perimpact/particles/particles.hpp"

namespace perimpact {

struct CrackCut {
  std::string name;
  std::size_t bonds;     ///< that it cut; one that several cross is counted for the first
  std::size_t in_plane;  ///< particles that lie in it, and count as on the side of its normal (solid/crack.hpp)
};

/// Throws SetupError, with the key of the crack, where its polygon is none, has two points but the body is no plane one or the other way round, or cuts
/// no bond.
std::vector<CrackCut> cut_first_cracks(const BodySetup& body, const Particles& particles, Family& family);

/// A sentence for each crack with particles in its plane.
std::vector<std::string> warnings_of(const std::vector<CrackCut>& cracks, const std::string& body);

}  // namespace perimpact
