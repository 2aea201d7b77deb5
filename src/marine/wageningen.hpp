/// Blades of the Wageningen B-series of propellers, with 4 to 7 blades, as tables over the relative radius r/R.
///
/// Oosterveld and van Oossanen, "Further computer-analyzed data of the Wageningen B-screw series", Int. Shipbuilding Progress 22 (1975) 251;
/// Kuiper, The Wageningen Propeller Series (1992); the section formulas also in Carlton, Marine Propellers and Propulsion, ch. 2.
///
///   r/R              0.2   0.3   0.4   0.5   0.6   0.7   0.8   0.9   1.0
///   chord        K = (c/D)(Z/A), A the expanded area ratio
///   leading part a/c     of the chord, before the generator line; at the tip, where a = c = 0, extrapolated linearly
///   thickest     b/c     position of the greatest thickness, from the leading edge
///   thickness    t/D = A_r - Z B_r
///   pitch        P(r)/P: 1, but less towards the hub for four blades
///
/// Interpolation between the radii: the chord as the root of a monotone cubic through K², which makes the tip round, as it is (integrated from
/// the hub of the series, r/R = 0.167, the expanded area ratio is then within 0.14 % of A); the others as monotone cubics. Below r/R = 0.2,
/// where the tables end, their last values apply.
///
/// A section has, at the position P from -1 (trailing edge) over 0 (thickest) to 1 (leading edge), and with the thickness t_e of the edges,
///
///   y_face = V1 (t - t_e),   y_back = (V1 + V2) (t - t_e) + t_e   [m]  above the chord line
#pragma once

namespace fccda::wageningen {

inline constexpr int fewest_blades = 4, most_blades = 7;
inline constexpr double hub = 0.167;  ///< r/R of the hub of the series, where the expanded area begins

double chord(double r, int blades, double area_ratio);  ///< c/D
double leading_part(double r);                          ///< a/c
double thickest(double r);                              ///< b/c
double thickness(double r, int blades);                 ///< t/D
double pitch(double r, int blades);                     ///< P(r)/P
double face(double r, double place);                    ///< V1
double rise(double r, double place);                    ///< V2

}  // namespace fccda::wageningen
