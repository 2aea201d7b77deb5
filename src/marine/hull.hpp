/// Parametric hull of an icebreaker, closed by a flat deck.
///
/// Axes: x aft, y to starboard, z up. The origin is the intersection of the stem with the waterline, z = 0. The stem extends to -F/tan φ
/// before the origin, the stern to L + F/tan φ_s.
///
///   stem      x_b(z) = -z/tan φ                       a straight line at the stem angle φ with the waterline
///   stern     x_e(z) = L + z/tan φ_s
///   section   b(z) = B/2 + z tan γ                     above the bilge, which begins at z = R - T; γ is the flare of the sides
///                  = that - R + sqrt(R² - (z + T - R)²)  in the bilge, down to the flat bottom z = -T
///   bow       W_b(t) = 1 - (1 - t)^p, t = (x - x_b)/l_b from 0 to 1; beyond, 1.   l_b = p (B/2)/tan α
///             A stem of radius r: an arc tangent to that curve, whose foremost point is on the stem; the curve then begins s before the stem.
///   stern     W_s(u) = 1 - (1 - u)², u = (x_e - x)/l_s as for t.                  l_s = 2 (B/2)/tan α_s
///   hull      y(x, z) = b(z) W_b W_s
///
/// Consequences, without flare: every waterline above the bilge meets the centreline at exactly the angle α (α_s at the stern), with a stem of
/// radius r past its arc; the buttocks of the bow are straight and parallel to the stem, so the normals have n_x/n_z = tan φ everywhere there. With flare both
/// hold on the waterline. Angles as in Lindqvist (POAC 1989) and Riska et al. (1997): φ between stem and waterline, α between waterline and centreline.
#pragma once

#include <numbers>

#include "mesh/panels.hpp"

namespace fccda {

/// Main dimensions of a hull.
struct HullShape {
  double length = 0;                                           ///< L [m] of the waterline
  double breadth = 0;                                          ///< B [m] on the waterline
  double draft = 0;                                            ///< T [m]
  double freeboard = 0;                                        ///< F [m] height of the deck above the waterline
  double stem_angle = 0;                                       ///< φ [rad], above 0, π/2 at most
  double waterline_angle = 0;                                  ///< α [rad] half angle of entrance, between 0 and π/2
  double fullness = 2;                                         ///< p [-] of the waterlines of the bow; 1 is a wedge
  double stern_angle = std::numbers::pi * 35 / 180;            ///< φ_s [rad]
  double stern_waterline_angle = std::numbers::pi * 30 / 180;  ///< α_s [rad]
  double bilge_radius = 0;                                     ///< R [m]; 0: a hard chine
  double stem_radius = 0;                                      ///< r [m] of the waterlines at the stem, 0.001 to 0.25 of the breadth; 0: a sharp edge
  double flare = 0;                                            ///< γ [rad] of the sides from the vertical, outward as they rise
  double edge_length = 0;                                      ///< [m] edge length of panels aft of the bow
  double bow_edge_length = 0;                                  ///< [m] in the bow, growing gradually behind it; 0: as edge_length
};

/// The curved form that the panels approximate.
class HullForm {
 public:
  /// Throws InputError, one sentence, if the lengths and angles are inconsistent.
  explicit HullForm(const HullShape& shape);

  double stem(double z) const { return -z * cot_stem_; }                   ///< x_b [m]
  double stern(double z) const { return shape_.length + z * cot_stern_; }  ///< x_e [m]
  double section(double z) const;                                          ///< b [m], -T <= z <= F
  double bow_length() const { return bow_length_; }                        ///< [m] from the stem to the full breadth: l_b - s
  double stem_arc() const { return arc_; }                                 ///< [m] aft of the stem to the end of its arc; 0 for a sharp edge
  double stern_length() const { return stern_length_; }                    ///< l_s [m]
  double bow_share(double t) const;                                        ///< W_b, t from the stem to the full breadth
  double stern_share(double u) const { return 1 - (1 - u) * (1 - u); }     ///< W_s
  double bilge_top() const { return shape_.bilge_radius - shape_.draft; }  ///< R - T [m]
  double half_breadth(double x, double z) const;                           ///< y [m], 0 before the stem and behind the stern
  const HullShape& shape() const { return shape_; }                        ///< as given

 private:
  void round_stem();

  HullShape shape_;
  double cot_stem_, cot_stern_, tan_flare_;
  double bow_length_, stern_length_;
  double ahead_ = 0, arc_ = 0;  ///< [m] s; of stem_arc()
};

/// Triangles oriented outward, closed, with shared vertices on the form; starboard and port are exact mirror images. Parts: `bow`, `side` and
/// `stern` above the bilge (bow and stern as far as waterlines widen), `bilge`, `bottom`, `deck`.
///
/// The panels lie in strips between columns, lines from the deck to the bottom that follow stem and stern, so every panel of bow and stern has
/// an edge along a buttock. Without flare, a bow panel therefore has n_x/n_z = tan φ up to rounding. Edges along the columns, and those across
/// them on the longest waterline, are at most as long as requested; other edges can reach 1.5 times that. Behind the bow the edges grow by a
/// fifth of the distance, up to edge_length.
/// Throws InputError, one sentence, if the dimensions are inconsistent or the number of panels exceeds the limit.
Panels make_hull(const HullShape& shape);

}  // namespace fccda
