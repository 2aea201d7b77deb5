/// The triangulated surface for contact: welded, consistently oriented triangles with their neighbours and pseudonormals, in the body
/// frame. Only displace() changes it after construction, so any number of threads may read it.
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

/// Closed (watertight) if every edge has two triangles.
enum class Closure : std::uint8_t { closed, open };

/// A named part of a surface, as its file groups the panels.
struct PartReport {
  std::string name;        ///< empty if the panels are unnamed
  std::size_t panels = 0;  ///< as given
  double area = 0;         ///< [m²] of the triangles kept
};

/// What construction found and repaired.
struct SurfaceReport {
  std::size_t panels = 0;                      ///< as given
  std::size_t triangles = 0;                   ///< kept
  std::size_t vertices = 0;                    ///< after welding
  std::size_t welded = 0;                      ///< vertices merged into another
  std::size_t degenerate = 0;                  ///< dropped triangles without area
  std::size_t duplicate = 0;                   ///< dropped triangles that repeat another
  std::size_t back_to_back = 0;                ///< dropped triangles that lay back to back in pairs (duplicates.hpp)
  std::size_t non_manifold_edge_count = 0;     ///< edges of more than two triangles, resolved by dihedral angle (connect.hpp)
  std::size_t cut_edges = 0;                   ///< of these, the unresolved ones: an unmatched side is a boundary edge
  std::size_t rewound = 0;                     ///< triangles flipped to agree with their neighbours
  std::size_t flipped = 0;                     ///< closed components that pointed inward and were flipped as a whole
  std::size_t components = 0;                  ///< parts connected over edges
  std::size_t cavities = 0;                    ///< closed components that lie inside another and bound a cavity in it
  std::size_t solids = 0;                      ///< components other than cavities
  std::size_t may_overlap = 0;                 ///< closed components, except cavities, whose bounding box intersects that of another
  std::size_t boundary_edges = 0;              ///< edges of one triangle, or cut
  Closure closure = Closure::closed;           ///< of the whole surface
  double area = 0;                             ///< [m²]
  double volume = 0;                           ///< [m³] enclosed; 0 if open. The shared volume of overlapping components counts twice
  Vec3d centroid{};                            ///< [m] of the enclosed volume; of the area if open
  Vec3d inertia_diagonal{};                    ///< [m⁵] ∫(y²+z²) dV and so on about the centroid, along the surface's axes
  Vec3d inertia_products{};                    ///< [m⁵] ∫yz dV, ∫zx dV, ∫xy dV about the centroid
  double shortest_edge = 0, longest_edge = 0;  ///< [m]
  Box bounds;                                  ///< [m]
  std::vector<PartReport> parts;               ///< at least one, in the order of Surface::part_names()
};

/// A triangulated surface, ready for contact.
class Surface {
 public:
  /// How panels become a surface.
  struct Options {
    double weld_tolerance = 1e-9;                       ///< vertices nearer than this times the size of the surface are merged
    double weld_distance = 0;                           ///< [m] at least 0: or nearer than this, if larger; closes gaps left by rounding between parts
    Orientation orientation = Orientation::undeclared;  ///< outer side of an open surface
    std::string name = "surface";                       ///< its name in messages
  };

  /// Welds vertices, splits quads (along the shorter diagonal), drops degenerate and duplicate triangles, orients each component
  /// consistently and outward (inner walls of hollow bodies face the cavity), separates parts that meet in a vertex, and classifies the
  /// surface. Throws InputError if there are no panels, coordinates or the weld distance are not finite, or vertex or part numbers are out of range. Throws
  /// SurfaceError (defects.hpp), which lists panels, if a component is not orientable or a closed one has no volume. It does so too if the
  /// orientation is undeclared and the surface is open, or has non-manifold edges that must be cut. Throws InputError if the surface is closed and the
  /// orientation reversed.
  Surface(const Panels& panels, const Options& options);
  /// With default options.
  explicit Surface(const Panels& panels) : Surface(panels, Options{}) {}

  std::span<const Vec3d> vertices() const { return linked_.vertices; }       ///< [m] after welding
  std::span<const Triangle> triangles() const { return linked_.triangles; }  ///< by vertex numbers, outward
  const Panels& panels() const { return panels_; }                           ///< as given, for the published detector and for output files
  const SurfaceReport& report() const { return report_; }                    ///< what was found and repaired

  /// Names of the parts, indexed by Panels::part; one empty name if the panels have none.
  std::span<const std::string> part_names() const { return part_names_; }
  /// The part of a panel, as an index into part_names(); `panel` is numbered as in Contact and Triangle.
  int part_of_panel(int panel) const { return panels_.part.empty() ? 0 : panels_.part[static_cast<std::size_t>(panel)]; }

  bool is_closed() const { return report_.closure == Closure::closed; }  ///< watertight

  const Vec3d& corner(std::size_t triangle, std::size_t c) const { return linked_.corner(triangle, c); }  ///< [m] corner 0, 1 or 2
  /// Unit, outward.
  Vec3d normal(std::size_t triangle) const { return normals_.faces.empty() ? pseudonormal(triangle, Feature::face) : normals_.faces[triangle]; }

  /// Unit normal of the feature: of the face; the mean of both faces on an edge; the angle-weighted mean on a vertex. The sign of
  /// (point - closest point)·pseudonormal gives the side of a point (Bærentzen and Aanæs, IEEE TVCG 11 (2005) 243).
  Vec3d pseudonormal(std::size_t triangle, Feature feature) const;

  /// True if this vertex of the panels became that vertex of the surface, by itself or merged with others. Where fans were separated (fans.hpp) it may
  /// have become several.
  bool became(int panel_vertex, int vertex) const {
    return welded_to_[static_cast<std::size_t>(panel_vertex)] == welded_from_[static_cast<std::size_t>(vertex)];
  }

  /// Number of solids bounded by the surface: outer components with their cavities. They may overlap, as blades and their hub do.
  std::size_t solids() const { return report_.solids; }
  int solid_of(std::size_t triangle) const { return solid_of_[triangle]; }  ///< counted from 0

  /// The panels with a boundary edge, in ascending order.
  std::vector<int> panels_on_boundary() const { return panels_of<std::size_t>(linked_.triangles, triangles_on_boundary(linked_)); }

  /// The triangle beyond edge e, or -1 at a boundary edge.
  int neighbour(std::size_t triangle, std::size_t e) const { return linked_.neighbours[triangle][e]; }

  /// True if the feature lies on the boundary of an open surface, where the pseudonormal does not define a side.
  bool is_boundary_edge(std::size_t triangle, Feature feature) const;

  /// Moves the vertices [m], as many as vertices() and all finite; triangles and neighbours remain. The bounds of report() follow, its other
  /// numbers remain those of construction. From then on normals are computed when they are asked for.
  void displace(std::span<const Vec3d> vertices);

  /// Radius of the bounding sphere about `point` [m].
  double radius_about(const Vec3d& point) const;

 private:
  Components build_components(const Options& options);
  void measure_parts();

  Panels panels_;
  std::vector<std::string> part_names_;
  LinkedTriangles linked_;
  Pseudonormals normals_;       // empty once displaced
  IncidentTriangles incident_;  // empty until displaced
  std::vector<bool> boundary_vertices_;
  std::vector<int> welded_to_, welded_from_;  // numbers after welding: of each vertex of the panels, and of each vertex of the surface
  std::vector<int> solid_of_;                 // of each triangle
  SurfaceReport report_;
};

}  // namespace fccda
