#include "mesh/inspect/volume_below.hpp"

#include "mesh/submerged.hpp"

namespace fccda {

double volume_below(const Surface& surface, double height) { return submerged(surface, {.height = height}).volume; }

}  // namespace fccda
