/// Initial cracks: bonds across them are cut before the first step, after the surface correction, which remains that of the uncracked body. Cut
/// bonds count as damage.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "perimpact/deck_model/setup.hpp"
#include "perimpact/family/family.hpp"
#include "perimpact/particles/particles.hpp"

namespace perimpact {

/// Result of cutting one crack.
struct CrackCut {
  std::string name;
  std::size_t bonds;     ///< cut bonds; a bond cut by several cracks counts for the first
  std::size_t in_plane;  ///< particles in its plane, assigned to the side of its normal (discretisation/crack.hpp)
};

/// Cuts the bonds across all initial cracks. Throws SetupError with the key of the crack if its polygon is invalid, has two points for a 3-D body or
/// more for a 2-D body, or cuts no bond.
std::vector<CrackCut> cut_first_cracks(const BodySetup& body, const Particles& particles, Family& family);

/// One warning for each crack with particles in its plane.
std::vector<std::string> warnings_of(const std::vector<CrackCut>& cracks, const std::string& body);

}  // namespace perimpact
