/// A surface whose vertices move: hulls that bend, blades that twist, sheets and membranes. Its connectivity is that of construction. In each
/// step every vertex moves straight and uniformly from its position at t0 to that at t1.
///
///   const auto hull = std::make_shared<DeformingSurface>(Surface(panels));
///   hull->move(vertices);   // where the vertices of `panels` are at the end of the coming step
///
/// Both ends of a step have a surface and a search tree of the same shape; one moves on to the next step while the other stays. The tree
/// follows its triangles (Bvh::refit), and is rebuilt once its queries have become slow.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "fccda/deforming/moving_triangle.hpp"
#include "mesh/search/bvh.hpp"
#include "mesh/surface.hpp"

namespace fccda {

/// A triangulated surface with its vertices at the two ends of a step.
class DeformingSurface {
 public:
  /// At rest. Throws InputError if closed parts of the surface may overlap: their union is evaluated for rigid surfaces only.
  explicit DeformingSurface(const Surface& surface);

  /// Begins a step: t0 is where the last one ended. `vertices` [m]: at t1, numbered as the vertices of the panels that the surface was made of.
  /// Throws, and changes nothing: RunError if one is not finite, or moves farther than `longest_path` sizes of the surface in the step; InputError if
  /// their number differs, one parts from another with which it was merged at construction, a panel loses its area, or a closed surface is turned
  /// inside out.
  void move(std::span<const Vec3d> vertices);

  /// Gives the step in progress another end, from the same t0: for implicit coupling. `vertices` as for move(). Returns the largest distance of a
  /// vertex from its previous position at t1 [m].
  double move_again(std::span<const Vec3d> vertices);

  /// Puts the surface at rest at `vertices` [m], between two steps, as after a restart; throws as move().
  void place(std::span<const Vec3d> vertices);

  /// On longer paths the rounding error of coordinates grows until contact is missed.
  static constexpr double longest_path = 1e6;

  const Surface& at_t0() const { return end(0).surface; }  ///< at the beginning of the step
  const Surface& at_t1() const { return end(1).surface; }  ///< at its end
  const Bvh& bvh_t0() const { return end(0).bvh; }         ///< of at_t0()
  const Bvh& bvh_t1() const { return end(1).bvh; }         ///< of at_t1(), of the same shape

  /// A triangle during the step.
  MovingTriangle triangle(std::size_t t) const { return {corners(at_t0(), t), corners(at_t1(), t)}; }

  /// The vertices of the panels that are the corners of a triangle; of merged ones that of the first panel.
  std::array<int, 3> panel_vertices(std::size_t t) const;

  std::uint64_t steps() const { return steps_; }            ///< number of moves and placements so far
  std::uint64_t rebuilds() const { return rebuilds_; }      ///< how often the search tree was rebuilt
  double travel() const { return travel_; }                 ///< [m] largest displacement of a vertex in the step
  const Vec3d& mean_displacement() const { return mean_; }  ///< [m] middle of the box about the displacements of all vertices
  double spread() const { return spread_; }                 ///< [m] largest deviation of a vertex' displacement from that
  double size() const { return size_; }                     ///< [m] the largest extent at construction

 private:
  struct End {
    explicit End(const Surface& from) : surface(from), bvh(surface) {}
    Surface surface;
    Bvh bvh;
  };

  static Corners corners(const Surface& surface, std::size_t t) { return {surface.corner(t, 0), surface.corner(t, 1), surface.corner(t, 2)}; }
  const End& end(std::size_t which) const { return *ends_[which]; }
  void find_sources();
  void expect_usable(std::span<const Vec3d> from, std::span<const Vec3d> vertices) const;
  void take(std::span<const Vec3d> from, std::span<const Vec3d> vertices);
  void expect_sound() const;
  void measure_step();
  void update_tree();
  void finish_move();

  std::array<std::unique_ptr<End>, 2> ends_;  // t0, t1
  std::vector<int> source_;                   // the vertex of the panels that each vertex of the surface is
  struct Merged {
    int vertex, with;  // of the panels
    double distance;   // [m] at construction
  };
  std::vector<Merged> merged_;
  std::vector<Vec3d> positions_;  // of the surface's vertices at t1
  double size_ = 0;
  double built_cost_ = 0;  // of the tree when it was last built
  std::uint64_t steps_ = 0, rebuilds_ = 0;
  double travel_ = 0, spread_ = 0;
  Vec3d mean_{};
};

}  // namespace fccda
