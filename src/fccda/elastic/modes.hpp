/// Vibration modes of an elastic body on the vertices of its surface: mode shapes, frequencies, damping and modal stresses, as an eigenvalue
/// analysis by finite elements gives them.
///
/// The displacement of vertex v in the body frame is u_v = Σ_k φ_kv q_k, and each modal coordinate obeys
///   q̈_k + 2 ζ_k ω_k q̇_k + ω_k² q_k = Σ_v φ_kv · F_v
/// with shapes normalised to unit modal mass, φᵀMφ = 1.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "base/vec3.hpp"

namespace fccda {

/// Components xx, yy, zz, xy, yz, zx of a symmetric tensor, in the body frame.
using SymmetricTensor = std::array<double, 6>;

/// One mode.
struct Mode {
  double angular_frequency = 0;           ///< [rad/s] ω, undamped; positive
  double damping_ratio = 0;               ///< [-] ζ, at least 0 and below 1
  std::vector<Vec3d> shape;               ///< [1/√kg] φ of each vertex of the surface's panels
  std::vector<SymmetricTensor> stress{};  ///< [Pa/(m √kg)] of each vertex at q = 1; empty where unknown
};

/// The modes of a body, in any order; all with shapes of equal length.
using Modes = std::vector<Mode>;

}  // namespace fccda
