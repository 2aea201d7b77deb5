/// The rigid surface that particles strike: welded, consistently wound triangles with their neighbours and pseudonormals,
/// in the frame of the body. It never changes after construction, so any number of threads may read it.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/vec3.hpp"
#include "mesh/outward.hpp"
#include "mesh/panels.hpp"
#include "mesh/pseudonormals.hpp"
#include "mesh/triangle.hpp"
#include "mesh/winding.hpp"

namespace fccda {

/// Has every edge two triangles?
enum class Closure : std::uint8_t { closed, open };

/// A named part of a surface, as its file groups the panels.
struct PartReport {
  std::string name;        ///< empty where nothing is named
  std::size_t panels = 0;  ///< as given
  double area = 0;         ///< [m²] of the triangles kept
};

/// What construction found and mended.
struct SurfaceReport {
  std::size_t panels = 0;                   ///< as given
  std::size_t triangles = 0;                ///< kept
  std::size_t vertices = 0;                 ///< after welding
  std::size_t welded = 0;                   ///< vertices merged into another
  std::size_t degenerate = 0;               ///< dropped triangles without area
  std::size_t duplicate = 0;                ///< dropped triangles that repeat another
  std::size_t back_to_back = 0;             ///< dropped triangles that lay back to back in pairs (duplicates.hpp)
  std::size_t non_manifold_edge_count = 0;  ///< edges of more than two triangles, found their neighbours by the wedge between them (connect.hpp)
  std::size_t cut_edges = 0;                ///< of these, such where a triangle found none; its side there is a rim
  std::size_t rewound = 0;                  ///< triangles turned to agree with their neighbours
  std::size_t flipped = 0;                  ///< closed components whose normals pointed inward and that were turned as a whole
  std::size_t components = 0;               ///< parts that hang together over edges
  std::size_t cavities = 0;                 ///< closed components that lie inside another and bound a hollow in it
  std::size_t solids = 0;                   ///< components that are no cavities
  std::size_t may_overlap = 0;              ///< closed components, but for cavities, whose bounding box meets that of another: they may overlap
  std::size_t boundary_edges = 0;           ///< edges with one triangle, or cut
  Closure closure = Closure::closed;
  double area = 0;                             ///< [m²]
  double volume = 0;                           ///< [m³] enclosed; 0 where open. What overlapping components share counts twice
  Vec3d centroid{};                            ///< [m] of the enclosed volume; of the area where open
  Vec3d inertia_diagonal{};                    ///< [m⁵] ∫(y²+z²) dV and so on about the centroid, along the surface's axes
  Vec3d inertia_products{};                    ///< [m⁵] ∫yz dV, ∫zx dV, ∫xy dV about the centroid
  double shortest_edge = 0, longest_edge = 0;  ///< [m]
  Box bounds;
  std::vector<PartReport> parts;  ///< at least one, in the order of Surface::part_names()
};

class Surface {
 public:
  struct Options {
    double weld_tolerance = 1e-9;  ///< vertices nearer than this times the size of the surface become one
    double weld_distance = 0;      ///< [m] or nearer than this, where that is more: closes gaps that rounding left between parts
    Orientation orientation = Orientation::undeclared;
    std::string name = "surface";  ///< how messages call it
  };

  /// Welds, splits quads (along the shorter diagonal), drops degenerate and duplicate triangles, makes the winding consistent in each
  /// component and outward (inner walls of hollow bodies face the hollow), separates parts that touch in a vertex, classifies. Throws InputError where the
  /// surface cannot be used: no panels, coordinates that are not numbers, vertex or part numbers out of range; SurfaceError (defects.hpp), which names
  /// panels, where a winding cannot be made consistent, a closed part has no volume, or the surface is open, or has edges of more than
  /// two panels that must be cut, and its outside is undeclared.
  Surface(const Panels& panels, const Options& options);
  explicit Surface(const Panels& panels) : Surface(panels, Options{}) {}

  std::span<const Vec3d> vertices() const { return linked_.vertices; }
  std::span<const Triangle> triangles() const { return linked_.triangles; }
  const Panels& panels() const { return panels_; }  ///< as given, for the published detector and for pictures
  const SurfaceReport& report() const { return report_; }

  /// Names of the parts in the order that Panels::part counts them; one empty name where the panels have none.
  std::span<const std::string> part_names() const { return part_names_; }
  /// Which of part_names() a panel belongs to; `panel` as Contact and Triangle number it.
  int part_of_panel(int panel) const { return panels_.part.empty() ? 0 : panels_.part[static_cast<std::size_t>(panel)]; }

  bool is_closed() const { return report_.closure == Closure::closed; }

  const Vec3d& corner(std::size_t triangle, std::size_t c) const { return linked_.corner(triangle, c); }
  const Vec3d& normal(std::size_t triangle) const { return normals_.faces[triangle]; }  ///< unit, outward

  /// Unit normal of the feature: of the face; the mean of both faces on an edge; the angle-weighted mean on a vertex. The sign of
  /// (point - closest point)·pseudonormal says on which side a point is (Bærentzen and Aanæs, IEEE TVCG 11 (2005) 243).
  const Vec3d& pseudonormal(std::size_t triangle, Feature feature) const;

  /// Bodies of material that the surface bounds: outer components with their cavities. They may overlap, as blades do in their hub.
  std::size_t solids() const { return report_.solids; }
  int solid_of(std::size_t triangle) const { return solid_of_[triangle]; }  ///< counted from 0

  /// The panels with an edge on a rim, in rising order.
  std::vector<int> panels_on_boundary() const { return panels_of<std::size_t>(linked_.triangles, triangles_on_boundary(linked_)); }

  /// The triangle beyond edge e, or -1 on a rim.
  int neighbour(std::size_t triangle, std::size_t e) const { return linked_.neighbours[triangle][e]; }

  /// True where the feature touches the rim of an open surface: there the pseudonormal gives no side.
  bool is_boundary_edge(std::size_t triangle, Feature feature) const;

  /// Radius of the sphere about `point` that holds all vertices [m].
  double radius_about(const Vec3d& point) const;

 private:
  Components build_components(const Options& options);
  void measure_parts();

  Panels panels_;
  std::vector<std::string> part_names_;
  LinkedTriangles linked_;
  Pseudonormals normals_;
  std::vector<bool> boundary_vertices_;
  std::vector<int> solid_of_;  // of each triangle
  SurfaceReport report_;
};

}  // namespace fccda
