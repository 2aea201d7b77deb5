/// Perfectly inelastic impact of many points on panels whose vertices have masses, all in one step.
///
/// At an unyielding panel the velocity of point k changes by Δv_k, of which d_k = Δv_k·n_k is along the normal. With the share s_k of that, the vertices i
/// of masses M_i change theirs by u_i = -Σ_k w_ki m_k s_k Δv_k/M_i, and the panel at the place of contact by Σ_i w_ki u_i. The shares are those with
///
///   s_k d_k - n_k·Σ_i w_ki u_i = d_k   or, where the panel retreats faster,   s_k = 0
///
/// For a single contact this is s = 1/(1 + m W), W = Σ w_i²/M_i. In general it is a linear complementarity problem, solved by projected Gauss-Seidel
/// sweeps (Cottle, Pang and Stone, The Linear Complementarity Problem, 1992, section 5.2). A contact shares the friction of its Δv_k.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "base/vec3.hpp"

namespace fccda {

/// A point that meets a panel.
struct PanelImpact {
  std::array<int, 3> vertices{};           ///< of the panels
  std::array<double, 3> weights{};         ///< w_i, barycentric coordinates of the place of contact
  double mass = 0;                         ///< [kg] m of the point
  Vec3d change{};                          ///< [m/s] Δv at an unyielding panel
  Vec3d normal{};                          ///< unit, n
  std::array<double, 3> inverse_masses{};  ///< [1/kg] 1/M_i, 0 for prescribed motion
};

/// The share s_k of each impact, at least 0 and at most 1 unless other points drive the panel towards this one. Ends when no share changes a velocity by more
/// than 1e-6 of the largest, or after 200 sweeps; the momentum of point and panel balances for any shares.
std::vector<double> impact_shares(std::span<const PanelImpact> impacts);

}  // namespace fccda
