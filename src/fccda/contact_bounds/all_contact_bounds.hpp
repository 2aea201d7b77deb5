/// The list of contact bounds (Zhang et al., section 3.1): where contact is possible, in the body frame. Points that stay away from them are
/// rejected without evaluation of the surface.
///
/// Guarantees of all contact bounds (tests/fccda/contact_bounds/contact_bounds_contract.test.cpp):
///  1. a path that can come within `margin` of a panel inside the bounds is never rejected;
///  2. they are immutable after construction, so any number of threads may query them concurrently.
///
///   clips()                    part of the surface lies outside the bounds, where contact is ignored
///   contains(point)            contact counts at this position
///   may_contact(path, margin)    false: the path certainly stays farther than margin [m] away
///   distance_at_least(point)   [m] a lower bound of the distance from the bounds
///   volume()                   [m³]
///   visit_facts(visit)         optional: visit("radius [m]", radius) for each number that reports show
/// and a function panels_of(bounds), their picture. bounds_panels.hpp gives their faces for output; fit_contact_bounds.hpp fits them to a surface.
#pragma once

#include <variant>

#include "fccda/contact_bounds/box_union.hpp"
#include "fccda/contact_bounds/cylinder_sectors.hpp"
#include "fccda/contact_bounds/unbounded.hpp"

namespace fccda {

/// Contact bounds of any kind.
using ContactBounds = std::variant<Unbounded, BoxUnion, CylinderSectors>;

}  // namespace fccda
