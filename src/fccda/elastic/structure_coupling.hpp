/// Implicit coupling of a structure's motion and its contact impulse within a step, solved by Newton's method: respond/coupling.hpp for a surface
/// that deforms. With the weights w of a place of contact, G = Σ w_i H_i is its velocity for the generalised one (structure.hpp), and
///
///   (1 + K A) δp = p_found - p_assumed,   K = Σ Gᵀ B G
///
/// with B of coupling.hpp. The equations are solved by BiCGSTAB (van der Vorst, 1992), without a matrix, on the coordinates of the vertices in
/// contact.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "fccda/deforming/respond.hpp"
#include "fccda/elastic/structure.hpp"

namespace fccda {

/// Newton iteration for the contact impulse of one step on a structure.
class StructureCoupling {
 public:
  static constexpr int max_passes = 12;

  /// Both must exist as long as this.
  StructureCoupling(Structure& structure, DeformingSurface& surface);

  std::span<const Vec3d> vertices() const { return vertices_; }  ///< [m] of the surface's panels, at the end of the last pass
  void start_at(std::span<const Vec3d> vertices);                ///< where they are before the coming step, after a restart

  void advance(const Step& step);  ///< starts with the contact-free motion

  /// Adds one contact of this pass, of a point of `mass` [kg], with its response to an unyielding panel.
  void add(const DeformingContact& contact, double mass, const PanelImpulse& impulse, double friction);

  /// Returns whether the iteration has converged: at the vertices in contact, assumed and found impulse cause velocity changes that agree to the
  /// fraction `share` of the largest.
  bool agrees(double share = 1e-6);

  void correct();  ///< begins the next pass with a Newton update
  void retreat();  ///< begins the next pass as the one in which assumed and found impulse differed least, for iterations that do not converge

  double correction() const { return correction_; }  ///< [m] largest displacement of a vertex at t1 between the last two passes
  double finish();                                   ///< applies the found impulse; returns the work of contact on the structure [J]

 private:
  struct Place {
    std::array<int, 3> vertices;
    std::array<double, 3> weights;
    double mass;    // [kg] of the point
    Vec3d normal;   // unit
    Vec3d along{};  // of δJ for a velocity change along the normal
    bool sticks;
  };

  void move();
  void end_pass();
  void activate();
  Vec3d velocity_at(const Place& place, std::span<const double> velocity) const;
  double largest_velocity(std::span<const double> impulse) const;
  std::vector<double> missing() const;
  void multiply(std::span<const double> x, std::span<double> product) const;
  void solve(std::span<const double> right, std::span<double> x) const;

  Structure& structure_;
  DeformingSurface& surface_;
  std::vector<double> assumed_, found_;
  std::vector<double> best_;         // the assumed impulse of the pass in which it differed least from the one found
  double least_error_ = 0;           // [m/s] of the vertices in that pass
  std::vector<Place> places_;        // of this pass
  std::vector<int> touched_;         // vertices in contact in any pass of the step, ascending
  std::vector<std::size_t> active_;  // their coordinates
  std::vector<Vec3d> vertices_;      // [m] at t1
  double correction_ = 0, dt_ = 0;
};

}  // namespace fccda
