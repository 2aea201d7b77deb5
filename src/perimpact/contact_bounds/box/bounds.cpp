#include "perimpact/contact_bounds/box/bounds.hpp"

namespace perimpact {

using namespace fccda;

ImpactorBounds make_bounds(const BoxRegionSetup& box, const Surface& surface, Beyond beyond) { return {BoxUnion({box.size, box.centre}, surface, beyond), ""}; }

}  // namespace perimpact
