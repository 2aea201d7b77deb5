/// A body as the short-range force sees it.
#pragma once

#include <span>

#include "perimpact/family/family.hpp"
#include "perimpact/particles/particles.hpp"

namespace perimpact {

struct ContactingBody {
  Particles& particles;
  const Family& family;
  std::span<const std::size_t> broken_ends;  ///< so far, of each row
  double stiffness;                          ///< [N/m⁷] k of its springs (ShortRangeLaw::stiffness)
};

}  // namespace perimpact
