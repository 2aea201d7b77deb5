#include "perimpact/impactor/modes_of.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/contract.hpp"
#include "fccda/modes/modes_on.hpp"
#include "perimpact/deck_model/setup_error.hpp"

namespace perimpact {

namespace {

double frequency(const fccda::Mode& mode) { return mode.angular_frequency / (2 * std::numbers::pi); }

void leave_out_high_modes(fccda::Modes& modes, const ElasticImpactorSetup& elastic, const std::string& key) {
  if (!elastic.highest_frequency) return;
  const auto lowest =
      std::min_element(modes.begin(), modes.end(), [](const fccda::Mode& a, const fccda::Mode& b) { return a.angular_frequency < b.angular_frequency; });
  if (frequency(*lowest) > *elastic.highest_frequency)
    throw SetupError(key + ".highest_frequency", fmt::format("highest_frequency is {:.4g} Hz, but the lowest mode of {} has {:.4g} Hz; raise it, or remove "
                                                             "elastic.",
                                                             *elastic.highest_frequency, elastic.modes, frequency(*lowest)));
  std::erase_if(modes, [&](const fccda::Mode& mode) { return frequency(mode) > *elastic.highest_frequency; });
}

using VertexField = std::vector<Vec3d>;  // a vector for each vertex

double product(const VertexField& a, const VertexField& b) {
  double sum = 0;
  for (std::size_t v = 0; v < a.size(); ++v) sum += fccda::dot(a[v], b[v]);
  return sum;
}

/// What is left of the field without its parts along orthonormal ones.
VertexField without(VertexField field, std::span<const VertexField> directions) {
  for (const VertexField& direction : directions) {
    const double share = product(field, direction);
    for (std::size_t v = 0; v < field.size(); ++v) field[v] -= share * direction[v];
  }
  return field;
}

/// Orthonormal motions of the vertices in the free degrees of freedom, rotations about the centre of mass.
std::vector<VertexField> free_motions(const ImpactorSetup& setup, const fccda::Surface& surface) {
  const Vec3d centre = setup.centre_of_mass.value_or(surface.report().centroid);
  std::vector<VertexField> motions;
  for (std::size_t degree = 0; degree < std::size(degree_words); ++degree) {
    if (std::ranges::find(setup.free_dofs, degree_words[degree]) == setup.free_dofs.end()) continue;
    Vec3d axis{};
    axis[degree % 3] = 1;
    VertexField motion;
    for (const Vec3d& vertex : surface.panels().vertices) motion.push_back(degree < 3 ? axis : fccda::cross(axis, vertex - centre));
    const double whole = std::sqrt(product(motion, motion));
    motion = without(std::move(motion), motions);
    const double rest = std::sqrt(product(motion, motion));
    constexpr double independence = 1e-9;  // a rotation about a line through all vertices moves none
    if (!(rest > independence * whole)) continue;
    for (Vec3d& vector : motion) vector = (1 / rest) * vector;
    motions.push_back(std::move(motion));
  }
  return motions;
}

void refuse_free_motions(const fccda::Modes& modes, const ImpactorSetup& setup, const fccda::Surface& surface) {
  const std::vector<VertexField> motions = free_motions(setup, surface);
  if (motions.empty()) return;
  constexpr double accuracy = 1e-3;  // of eigenvectors of iterative solvers, in files of six digits
  for (std::size_t m = 0; m < modes.size(); ++m) {
    const VertexField& shape = modes[m].shape;
    const VertexField rest = without(shape, motions);
    if (product(rest, rest) <= accuracy * accuracy * product(shape, shape))
      throw fccda::InputError(
          fmt::format("{}: mode_{}, of {:.4g} Hz, is a rigid motion, which {} has by its free degrees of freedom ({}) already; remove the mode.",
                      setup.elastic->modes, m + 1, frequency(modes[m]), setup.name, fmt::join(setup.free_dofs, ", ")));
  }
}

}  // namespace

fccda::Modes modes_of(const ImpactorSetup& setup, const fccda::Surface& surface) {
  EXPECTS(setup.elastic.has_value());
  const ElasticImpactorSetup& elastic = *setup.elastic;
  const std::string key = fmt::format("impactors.{}.elastic", setup.name);
  try {
    fccda::Modes modes = fccda::modes_on(surface.panels(), fccda::read_modes(elastic.modes));
    refuse_free_motions(modes, setup, surface);
    leave_out_high_modes(modes, elastic, key);
    if (elastic.damping)
      for (fccda::Mode& mode : modes) mode.damping_ratio = *elastic.damping;
    return modes;
  } catch (const SetupError&) {
    throw;
  } catch (const fccda::InputError& error) {
    throw SetupError(key + ".modes", error);
  }
}

}  // namespace perimpact
