/// Panels as pressure sees them: how large, where, facing which way, and which share an edge. Numbered as in the file.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "mesh/surface.hpp"

namespace fccda {

struct PanelFace {
  double area = 0;  ///< [m²] of the triangles the surface kept; 0 for a panel it dropped
  Vec3d middle{};   ///< [m] centroid, in the frame of the body
  Vec3d normal{};   ///< unit, outward; of a warped quad the area-weighted mean
};

class PanelFaces {
 public:
  explicit PanelFaces(const Surface& surface);

  std::size_t size() const { return faces_.size(); }
  const PanelFace& operator[](std::size_t panel) const { return faces_[panel]; }

  /// The panels that share an edge with this one, in no particular order; one that shares two edges appears twice.
  std::span<const int> neighbours(std::size_t panel) const {
    return std::span<const int>(neighbours_).subspan(first_neighbour_[panel], first_neighbour_[panel + 1] - first_neighbour_[panel]);
  }

  /// This panel and those on its side of the surface around it: middles within `radius` [m] of its middle, normals less than 60° off its
  /// own, reached from it over such panels. In ascending order.
  std::vector<int> around(std::size_t panel, double radius) const;

 private:
  std::vector<PanelFace> faces_;
  std::vector<std::size_t> first_neighbour_;  // of each panel, and the number of all
  std::vector<int> neighbours_;
};

}  // namespace fccda
