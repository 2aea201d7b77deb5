/// A structure that another program advances, such as an explicit finite-element code: each vertex has a lumped mass, and moves in a step by
///   x_t1 = x_free + dt j/m
/// under the contact impulse j of the step.
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "fccda/elastic/structure.hpp"

namespace fccda {

/// What the other program does.
struct StructureSolver {
  /// Positions of the vertices at t1 as without contact in this step [m]; called once in each step.
  std::function<std::vector<Vec3d>(const Step&)> advance;
  /// Takes the contact impulses of the step [N s]: velocities change by j/m, and positions at t1 by dt j/m.
  std::function<void(std::span<const Vec3d>)> apply;
  /// Kinetic and elastic energy, less the work of its supports and other loads, plus what it has dissipated, at the end of the last step [J];
  /// empty if the program does not report it.
  std::function<double()> energy;
};

/// Vertices with lumped masses; the generalised coordinates are their displacements.
class ExternalStructure final : public Structure {
 public:
  /// `masses` [kg], one for each vertex, positive; infinite where the motion is prescribed. `vertices` [m] at the start. Throws InputError.
  ExternalStructure(StructureSolver solver, std::vector<double> masses, std::span<const Vec3d> vertices);

  std::size_t size() const override { return 3 * masses_.size(); }
  std::size_t vertex_count() const override { return masses_.size(); }
  void begin(const Step& step) override;
  void move(std::span<const double> impulse, std::span<Vec3d> vertices) override;
  std::vector<std::size_t> coordinates_of(std::span<const int> vertices) const override;
  void velocity_change(std::span<const std::size_t> coordinates, std::span<const double> impulse, std::span<double> velocity) const override;
  Vec3d vertex_velocity(std::size_t vertex, std::span<const double> velocity) const override;
  void add_vertex_impulse(std::size_t vertex, const Vec3d& impulse, std::span<double> generalised) const override;
  double finish(std::span<const double> assumed, std::span<const double> found) override;

  std::optional<double> energy() const;  ///< [J] as StructureSolver::energy

 private:
  StructureSolver solver_;
  std::vector<double> masses_;
  std::vector<Vec3d> from_, free_;  // [m] at t0, and at t1 without contact
  std::vector<Vec3d> velocity_;     // [m/s] in the previous step; in the first step that without contact
  double dt_ = 0;
};

}  // namespace fccda
