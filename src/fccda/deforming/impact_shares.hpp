/// Perfectly inelastic impact of many points on panels whose vertices have masses, all in one step.
///
/// At an unyielding panel the velocity of point k changes by d_k n_k where the panel pushes it, n_k being the direction of that, usually the panel's normal,
/// and by Δt_k by friction. At a panel that yields it changes by s_k d_k n_k + r_k Δt_k. Vertices i of masses M_i then change their velocities by u_i, and the
/// panel at the place of contact by w_k. The shares are those with
///
///   s_k d_k - n_k·w_k = d_k           or, where the panel retreats faster,                  s_k = 0
///   r_k |Δt_k| - t_k·w_k = |Δt_k|     or, where the panel moves along with the point,       r_k = 0,
///                                     or, as friction diminishes with the push,             r_k = s_k
///
/// For a single point contact this is s = r = 1/(1 + m W), W = Σ w_i²/M_i. In general it is a linear complementarity problem, solved by projected Gauss-Seidel
/// sweeps (Cottle, Pang and Stone, The Linear Complementarity Problem, 1992, section 5.2). w_k is the velocity on which the impulse of the point does work,
/// so that the matrix of the problem is symmetric and positive definite, which the sweeps need, and no contact adds energy: push and friction must have
/// shares of their own, since points that press from two sides do not move a thin panel along its normal, but may both drag it along.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "base/vec3.hpp"

namespace fccda {

/// A point that meets a panel.
struct PanelImpact {
  /// The change of the point's velocity in one direction, at an unyielding panel.
  struct Part {
    double change = 0;                       ///< [m/s]; 0 if there is none
    Vec3d direction{};                       ///< unit
    std::array<Vec3d, 3> vertex_impulses{};  ///< [-] on the vertices, of a unit impulse on the panel in that direction
  };

  std::array<int, 3> vertices{};           ///< of the panels
  std::array<double, 3> inverse_masses{};  ///< [1/kg] 1/M_i, 0 for prescribed motion
  double mass = 0;                         ///< [kg] m of the point
  bool is_pushed = false;                  ///< along the panel's normal
  Part push;                               ///< d, n
  Part friction;                           ///< |Δt|, t
};

/// What is left of the change of a velocity where the panel yields.
struct ImpactShare {
  double push = 0;      ///< s
  double friction = 0;  ///< r
};

/// The shares of each impact, at least 0 and at most 1 unless other points drive the panel towards this one. Ends when no share changes a velocity by more
/// than 1e-6 of the largest, or after 200 sweeps; the momentum of point and panel balances for any shares.
std::vector<ImpactShare> impact_shares(std::span<const PanelImpact> impacts);

}  // namespace fccda
