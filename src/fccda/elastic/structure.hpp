/// Interface of a structure whose surface deforms: what implicit contact needs of its dynamics.
///
/// The structure has N generalised coordinates. In a step from t0 to t1 = t0 + dt a generalised impulse p acts at t0. To first order the vertices of
/// the surface move, in the mean over the step, with
///   v_i = v_i(p = 0) + H_i A p
/// with the symmetric compliance A and p = Σ H_iᵀ j_i for impulses j_i on the vertices. Vertices are numbered as those of the surface's panels.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "base/vec3.hpp"
#include "fccda/rigid_body/step.hpp"

namespace fccda {

/// A structure with N generalised coordinates and a surface of n vertices.
class Structure {
 public:
  Structure() = default;
  Structure(const Structure&) = delete;
  Structure& operator=(const Structure&) = delete;
  virtual ~Structure() = default;

  virtual std::size_t size() const = 0;          ///< N
  virtual std::size_t vertex_count() const = 0;  ///< n

  /// Begins a step. Other loads of the step have been applied.
  virtual void begin(const Step& step) = 0;

  /// Moves the structure to t1 under the impulse p, from its state at the beginning of the step, and writes the positions of the vertices there [m].
  virtual void move(std::span<const double> impulse, std::span<Vec3d> vertices) = 0;

  /// The coordinates that impulses on these vertices act on, in ascending order.
  virtual std::vector<std::size_t> coordinates_of(std::span<const int> vertices) const = 0;

  /// A p, of these coordinates of p, the others being 0; writes the same coordinates of `velocity`.
  virtual void velocity_change(std::span<const std::size_t> coordinates, std::span<const double> impulse, std::span<double> velocity) const = 0;

  virtual Vec3d vertex_velocity(std::size_t vertex, std::span<const double> velocity) const = 0;                       ///< [m/s] H_i times the velocity
  virtual void add_vertex_impulse(std::size_t vertex, const Vec3d& impulse, std::span<double> generalised) const = 0;  ///< adds H_iᵀ j_i [N s]

  /// Ends the step with the impulse `found`. The motion to t1 is that of the last move(), with `assumed`; the difference changes velocities only.
  /// Returns the work of contact on the structure [J].
  virtual double finish(std::span<const double> assumed, std::span<const double> found) = 0;
};

}  // namespace fccda
