/// Division of a point cloud among ranks.
#pragma once

#include "perimpact/deck_model/setup.hpp"
#include "perimpact/family/slot_tree.hpp"
#include "perimpact/particles/cloud.hpp"
#include "perimpact/particles/cloud_part.hpp"

namespace perimpact {

/// [m] of the longest bond that the cloud can have (family/bond_list.hpp), and a little more.
double largest_reach(FamilyRule rule, double horizon_ratio, const Cloud& cloud);

/// The parts of all ranks in a cloud, which must outlive this.
class CloudParts {
 public:
  /// `reach` [m]: ghosts are the eights with a point less than this from an owned point.
  CloudParts(const Cloud& cloud, double reach, CloudPartition partition);

  const CloudPartition& partition() const { return partition_; }
  CloudPart of(int rank) const;

 private:
  const Cloud& cloud_;
  double reach_;
  CloudPartition partition_;
  SlotTree tree_;
};

}  // namespace perimpact
