/// Division of a point cloud among ranks.
#pragma once

#include "perimpact/deck_model/setup.hpp"
#include "perimpact/particles/cloud.hpp"
#include "perimpact/particles/cloud_part.hpp"

namespace perimpact {

/// [m] of the longest bond that the cloud can have (family/bond_list.hpp), and a little more.
double largest_reach(FamilyRule rule, double horizon_ratio, const Cloud& cloud);

/// The part of a rank. `reach` [m]: ghosts are the eights with a point less than this from an owned point.
CloudPart cloud_part_of(const Cloud& cloud, double reach, const CloudPartition& partition, int rank);

}  // namespace perimpact
