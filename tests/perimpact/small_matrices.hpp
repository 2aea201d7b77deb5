/// Matrices of three dimensions by textbook formulas, as the oracle of the kernels' own.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/vec3.hpp"

namespace fixtures {

using namespace perimpact;

/// By cross products of the rows.
inline fccda::Mat3 inverse_of(const fccda::Mat3& m) {
  const fccda::Vec3d a = cross(m.row[1], m.row[2]), b = cross(m.row[2], m.row[0]), c = cross(m.row[0], m.row[1]);
  const double det = dot(m.row[0], a);
  return transpose(fccda::Mat3{{a / det, b / det, c / det}});
}

/// Of a symmetric matrix, by the roots of its cubic as cosines (Smith, Commun. ACM 4 (1961) 168).
inline std::array<double, 3> eigenvalues_of(const fccda::Mat3& m) {
  const double mean = (m.row[0].x + m.row[1].y + m.row[2].z) / 3;
  fccda::Mat3 d = m;
  for (std::size_t r = 0; r < 3; ++r) d.row[r][r] -= mean;
  const double p = std::sqrt((squared_norm(d.row[0]) + squared_norm(d.row[1]) + squared_norm(d.row[2])) / 6);
  if (p == 0) return {mean, mean, mean};
  const double angle = std::acos(std::clamp(dot(d.row[0], cross(d.row[1], d.row[2])) / (2 * p * p * p), -1.0, 1.0)) / 3;
  const double third = 2 * std::numbers::pi / 3;
  return {mean + 2 * p * std::cos(angle), mean + 2 * p * std::cos(angle + third), mean + 2 * p * std::cos(angle - third)};
}

}  // namespace fixtures
