#include "fccda/elastic/external_structure.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/finite.hpp"

namespace fccda {

namespace {

Vec3d at(std::span<const double> numbers, std::size_t vertex) { return {numbers[3 * vertex], numbers[3 * vertex + 1], numbers[3 * vertex + 2]}; }

}  // namespace

ExternalStructure::ExternalStructure(StructureSolver solver, std::vector<double> masses, std::span<const Vec3d> vertices)
    : solver_(std::move(solver)), masses_(std::move(masses)), from_(vertices.begin(), vertices.end()), free_(from_) {
  if (masses_.size() != vertices.size())
    throw InputError("structure: there are " + std::to_string(masses_.size()) + " masses, but the surface has " + std::to_string(vertices.size()) +
                     " vertices; give one for each.");
  for (std::size_t v = 0; v < masses_.size(); ++v)
    if (!(masses_[v] > 0))
      throw InputError("structure: the mass of vertex " + std::to_string(v) + " is " + in_words(masses_[v]) +
                       " kg, but it must be positive; it is infinite where the motion is prescribed.");
}

void ExternalStructure::begin(const Step& step) {
  const bool is_first = dt_ == 0;
  dt_ = step.dt;
  free_ = solver_.advance(step);
  if (free_.size() != masses_.size())
    throw InputError("structure: advance returned the positions of " + std::to_string(free_.size()) + " vertices, but the surface has " +
                     std::to_string(masses_.size()) + ".");
  if (!is_first) return;
  for (std::size_t v = 0; v < masses_.size(); ++v) velocity_.push_back((free_[v] - from_[v]) / dt_);
}

void ExternalStructure::move(std::span<const double> impulse, std::span<Vec3d> vertices) {
  for (std::size_t v = 0; v < masses_.size(); ++v) vertices[v] = free_[v] + (dt_ / masses_[v]) * at(impulse, v);
}

std::vector<std::size_t> ExternalStructure::coordinates_of(std::span<const int> vertices) const {
  std::vector<std::size_t> coordinates;
  for (const int vertex : vertices)
    for (std::size_t c = 0; c < 3; ++c) coordinates.push_back(3 * static_cast<std::size_t>(vertex) + c);
  std::sort(coordinates.begin(), coordinates.end());
  coordinates.erase(std::unique(coordinates.begin(), coordinates.end()), coordinates.end());
  return coordinates;
}

void ExternalStructure::velocity_change(std::span<const std::size_t> coordinates, std::span<const double> impulse, std::span<double> velocity) const {
  for (const std::size_t c : coordinates) velocity[c] = impulse[c] / masses_[c / 3];
}

Vec3d ExternalStructure::vertex_velocity(std::size_t vertex, std::span<const double> velocity) const { return at(velocity, vertex); }

void ExternalStructure::add_vertex_impulse(std::size_t vertex, const Vec3d& impulse, std::span<double> generalised) const {
  for (std::size_t c = 0; c < 3; ++c) generalised[3 * vertex + c] += impulse[c];
}

double ExternalStructure::finish(std::span<const double> assumed, std::span<const double> found) {
  std::vector<Vec3d> impulses(masses_.size());
  double work = 0;
  for (std::size_t v = 0; v < masses_.size(); ++v) {
    impulses[v] = at(found, v);
    const Vec3d before = velocity_[v];
    velocity_[v] = (free_[v] - from_[v]) / dt_ + impulses[v] / masses_[v];
    // The mean of the velocities of both steps, as for particles: the inner forces of the structure act together with the impulse, and do work on its
    // displacement.
    if (impulses[v] != Vec3d{}) work += dot(impulses[v], 0.5 * (before + velocity_[v]));
    from_[v] = free_[v] + (dt_ / masses_[v]) * at(assumed, v);
  }
  solver_.apply(impulses);
  return work;
}

std::optional<double> ExternalStructure::energy() const {
  if (!solver_.energy) return std::nullopt;
  return solver_.energy();
}

}  // namespace fccda
