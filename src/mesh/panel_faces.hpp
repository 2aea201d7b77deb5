/// Area, centroid, normal and neighbours of panels, for pressure evaluation. Numbered as in the file.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "mesh/surface.hpp"

namespace fccda {

struct PanelFace {
  double area = 0;  ///< [m²] of the triangles kept by the surface; 0 for a dropped panel
  Vec3d middle{};   ///< [m] centroid, in the frame of the body
  Vec3d normal{};   ///< unit, outward; the area-weighted mean for a warped quad
};

class PanelFaces {
 public:
  explicit PanelFaces(const Surface& surface);

  std::size_t size() const { return faces_.size(); }
  const PanelFace& operator[](std::size_t panel) const { return faces_[panel]; }

  /// The panels that share an edge with this one, in no particular order; a panel that shares two edges appears twice.
  std::span<const int> neighbours(std::size_t panel) const {
    return std::span<const int>(neighbours_).subspan(first_neighbour_[panel], first_neighbour_[panel + 1] - first_neighbour_[panel]);
  }

  /// This panel and its surroundings on the same side of the surface: centroids within `radius` [m] of its centroid, normals within 60° of
  /// its normal, connected to it over such panels. In ascending order.
  std::vector<int> around(std::size_t panel, double radius) const;

 private:
  std::vector<PanelFace> faces_;
  std::vector<std::size_t> first_neighbour_;  // of each panel, and the number of all
  std::vector<int> neighbours_;
};

}  // namespace fccda
