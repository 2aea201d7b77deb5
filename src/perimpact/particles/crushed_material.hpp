/// Extent to which impactors have crushed the particles of a body (fccda/respond/crushing.hpp).
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "perimpact/particles/slot_array.hpp"

namespace perimpact {

/// Arrays by slot; empty where impactors do not crush the material.
class CrushedMaterial {
 public:
  CrushedMaterial() = default;
  /// `thickness` [m] of the material of a particle.
  CrushedMaterial(double thickness, std::size_t slots) : thickness_(thickness), depth_(slots, 0.0), offset_(slots, 0) {}

  bool empty() const { return depth_.empty(); }
  double thickness() const { return thickness_; }                                        ///< [m]
  double depth(std::size_t slot) const { return empty() ? 0 : depth_[slot]; }            ///< [m] so far
  Vec3d offset(std::size_t slot) const { return empty() ? Vec3d{} : offset_.at(slot); }  ///< [m] from the particle's centre to that of the ball that is left
  /// [m] that may still be crushed. A small ball always remains, since a point without a radius slides less accurately over edges.
  double left(std::size_t slot) const { return std::max(0.0, share_crushed * thickness_ - depth(slot)); }
  /// Nothing is left but the small ball: the particle has no bonds, and is in contact with impactors alone.
  bool is_crushed(std::size_t slot) const { return !empty() && left(slot) <= rounding * thickness_; }

  void set(std::size_t slot, double depth, const Vec3d& offset) {
    depth_[slot] = depth;
    offset_.set(slot, offset);
  }

  template <class Visitor>
  void visit_state(const std::string& name, Visitor&& visit) {
    if (empty()) return;
    constexpr const char* axis[] = {"_x", "_y", "_z"};
    visit(name + ".crushed_depth", std::span(depth_));
    for (std::size_t c = 0; c < 3; ++c) visit(name + ".crushed_offset" + axis[c], std::span<double>(offset_.component(c), depth_.size()));
  }

 private:
  static constexpr double share_crushed = 0.999, rounding = 1e-12;

  double thickness_ = 0;
  std::vector<double> depth_;
  VectorArray offset_;
};

}  // namespace perimpact
