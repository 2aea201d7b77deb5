/// The one list of bounding regions (seed paper, section 3.1): where contact can happen, in the body frame. Points that do not come near
/// are rejected without a look at the surface.
///
/// Promises of every region (tests/fccda/contact_bounds/contact_bounds_contract.test.cpp):
///  1. a path that can come within `margin` of a panel inside the region is never called untouchable;
///  2. nothing changes after construction, so any number of threads may ask at once.
///
///   clips()                    some of the surface lies outside the region, where it is not felt
///   contains(point)            a place where contact counts
///   may_touch(path, margin)    false: the path surely stays further than margin [m] away
///   distance_at_least(point)   [m] a lower bound of the distance from the region
///   volume()                   [m³]
///
/// How a region looks is region_panels.hpp; fit_region.hpp finds one for a surface.
#pragma once

#include <variant>

#include "fccda/contact_bounds/box_union.hpp"
#include "fccda/contact_bounds/cylinder_sectors.hpp"
#include "fccda/contact_bounds/unbounded.hpp"

namespace fccda {

using ContactBounds = std::variant<Unbounded, BoxUnion, CylinderSectors>;

}  // namespace fccda
