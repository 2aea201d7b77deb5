/// The rigid surface that particles strike: welded, consistently wound triangles with their neighbours and pseudonormals,
/// in the frame of the body. It never changes after construction, so any number of threads may read it.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "fccda/core/vec3.hpp"
#include "fccda/surface/panels.hpp"

namespace fccda {

/// Half of a quad, or a whole triangular panel. Edge e goes from vertex[e] to vertex[(e + 1) % 3].
struct Triangle {
  std::array<int, 3> vertex;
  int panel;  ///< number of the panel it came from, as in the file
};

/// The part of a triangle that a closest point lies on.
enum class Feature : std::uint8_t { face, edge_0, edge_1, edge_2, vertex_0, vertex_1, vertex_2 };

enum class Closure : std::uint8_t { closed, open, non_manifold };

/// What construction found and mended. All counts are of panels unless said otherwise.
struct SurfaceReport {
  std::size_t panels = 0;      ///< as given
  std::size_t triangles = 0;   ///< kept
  std::size_t vertices = 0;    ///< after welding
  std::size_t welded = 0;      ///< vertices merged into another
  std::size_t degenerate = 0;  ///< dropped triangles without area
  std::size_t duplicate = 0;   ///< dropped panels that repeat another
  std::size_t rewound = 0;     ///< triangles turned to agree with their neighbours
  bool flipped = false;        ///< a closed surface whose normals pointed inward was turned as a whole
  std::size_t components = 0;
  std::size_t rim_edges = 0;           ///< edges with one triangle
  std::size_t non_manifold_edges = 0;  ///< edges with more than two
  Closure closure = Closure::closed;
  double area = 0;                             ///< [m²]
  double volume = 0;                           ///< [m³] enclosed; 0 where open
  Vec3d centroid{};                            ///< [m] of the enclosed volume; of the area where open
  Vec3d inertia_diagonal{};                    ///< [m⁵] ∫(y²+z²) dV and so on about the centroid, along the surface's axes
  Vec3d inertia_products{};                    ///< [m⁵] ∫yz dV, ∫zx dV, ∫xy dV about the centroid
  double shortest_edge = 0, longest_edge = 0;  ///< [m]
  Box bounds;
};

/// How an open surface says which side is outside.
enum class OutsideIs : std::uint8_t { undeclared, normals, reversed };

class Surface {
 public:
  struct Options {
    double weld_tolerance = 1e-9;  ///< vertices nearer than this times the size of the surface become one
    OutsideIs outside = OutsideIs::undeclared;
    std::string name = "surface";  ///< how messages call it
  };

  /// Welds, splits quads (along the shorter diagonal), drops degenerate and duplicate panels, makes the winding consistent in each
  /// component and outward, classifies. Throws InputError where the surface cannot be used: no panels, coordinates that are not
  /// numbers, vertex numbers out of range, non-manifold edges, a winding that cannot be made consistent, or an open surface
  /// whose outside is undeclared.
  Surface(const Panels& panels, const Options& options);
  explicit Surface(const Panels& panels) : Surface(panels, Options{}) {}

  std::span<const Vec3d> vertices() const { return vertices_; }
  std::span<const Triangle> triangles() const { return triangles_; }
  const Panels& panels() const { return panels_; }  ///< as given, for the published detector and for pictures
  const SurfaceReport& report() const { return report_; }
  bool is_closed() const { return report_.closure == Closure::closed; }

  const Vec3d& corner(std::size_t triangle, std::size_t c) const { return vertices_[static_cast<std::size_t>(triangles_[triangle].vertex[c])]; }
  const Vec3d& normal(std::size_t triangle) const { return normals_[triangle]; }  ///< unit, outward

  /// Unit normal of the feature: of the face; the mean of both faces on an edge; the angle-weighted mean on a vertex. The sign of
  /// (point - closest point)·pseudonormal says on which side a point is (Bærentzen and Aanæs, IEEE TVCG 11 (2005) 243).
  const Vec3d& pseudonormal(std::size_t triangle, Feature feature) const;

  /// The triangle beyond edge e, or -1 on a rim.
  int neighbour(std::size_t triangle, std::size_t e) const { return neighbours_[triangle][e]; }

  /// True where the feature touches the rim of an open surface: there the pseudonormal gives no side.
  bool is_rim(std::size_t triangle, Feature feature) const;

  /// Radius of the sphere about `point` that holds all vertices [m].
  double radius_about(const Vec3d& point) const;

 private:
  Panels panels_;
  std::vector<Vec3d> vertices_;
  std::vector<Triangle> triangles_;
  std::vector<Vec3d> normals_;                      // of faces
  std::vector<std::array<Vec3d, 3>> edge_normals_;  // of each triangle's edges
  std::vector<Vec3d> vertex_normals_;
  std::vector<std::array<int, 3>> neighbours_;
  std::vector<bool> rim_vertices_;
  SurfaceReport report_;
};

}  // namespace fccda
