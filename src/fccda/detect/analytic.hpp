/// Contact with a sphere or an infinite cylinder by the distance to its centre or axis: the "original" peridynamic contact
/// (seed paper, section 2.2, eq. 7), here with a contact radius.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "fccda/body/pose.hpp"
#include "fccda/core/parallel.hpp"
#include "fccda/detect/contact.hpp"
#include "fccda/detect/points.hpp"

namespace fccda {

class Analytic {
 public:
  /// `axis`: direction of the cylinder's axis through the body's origin, zero for a sphere.
  Analytic(double radius, const Vec3d& axis, double contact_radius) : reach_(radius + contact_radius), contact_radius_(contact_radius), axis_(axis) {}

  /// Appends the contacts of this step, in point order.
  template <Points P>
  void detect(const P& points, const Motion& motion, double surface_travel, std::vector<Contact>& contacts) {
    clearance_.resize(points.block_count(), 0.0);
    std::vector<std::vector<Contact>> found(points.block_count());
    parallel_for(static_cast<std::ptrdiff_t>(points.block_count()), [&](std::ptrdiff_t b) {
      const std::size_t block = static_cast<std::size_t>(b);
      clearance_[block] -= surface_travel + points.block_travel(block);
      if (clearance_[block] > 0) return;
      double nearest = std::numeric_limits<double>::infinity();
      for (std::size_t i = points.block_begin(block); i < points.block_end(block); ++i) {
        if (!points.occupied(i)) continue;
        const Vec3d end = motion.t1.to_body(points.position_t1(i));
        const Vec3d arm = end - dot(end, axis_) * axis_;
        const double distance = norm(arm);
        nearest = std::min(nearest, std::fabs(distance - reach_));
        if (!(distance < reach_) || distance == 0) continue;
        const Vec3d normal = arm / distance;
        found[block].push_back({.point = i,
                                .hit = motion.t1.to_world(end + (reach_ - contact_radius_ - distance) * normal),
                                .normal = motion.t1.turn_to_world(normal),
                                .relocation = motion.t1.to_world(end + (reach_ - distance) * normal),
                                .depth = reach_ - distance});
      }
      clearance_[block] = found[block].empty() ? nearest : 0.0;
    });
    for (const auto& of_block : found) contacts.insert(contacts.end(), of_block.begin(), of_block.end());
  }

  template <class Visitor>
  void visit_state(Visitor&&) {}

 private:
  double reach_;           // [m] radius + contact radius
  double contact_radius_;  // [m]
  Vec3d axis_;
  std::vector<double> clearance_;  // [m] what each block may still travel; a cache, not state
};

}  // namespace fccda
