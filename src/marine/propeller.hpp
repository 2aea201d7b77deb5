/// Parametric screw propeller: a hub and blades that extend into it, each closed by itself; contact is with their union.
///
/// Axes, with the shaft along x: x forward, y and z transverse, the origin in the middle of the hub. The generator line of the first blade is
/// along +y, the others follow towards +z. A right-handed propeller drives ahead while it rotates from y towards z; a left-handed one is its
/// mirror image. For another axis the coordinates are exchanged cyclically.
///
/// A blade is a stack of sections on cylinders of radius r. A section has the chord c, its leading edge s = a before the generator line and its
/// trailing edge c - a behind; y_face and y_back are the heights of its two sides above the chord line (wageningen.hpp). With the pitch angle
/// β = atan(P(r)/(2 π r)) a point of it lies at
///
///   X = s sin β + y cos β - k(r)              along the shaft; k is the rake, r tan(rake) or as given
///   angle = (s cos β - y sin β)/r             about it
///
/// Over the last three thicknesses before the tip the section is thinned to that of its edges, so that the outline has one edge all around.
///
/// Skew moves the section along its helix: s - θ r/cos β in place of s. The back (suction side ahead) faces forward.
#pragma once

#include <optional>
#include <vector>

#include "mesh/shapes/axis.hpp"
#include "mesh/shapes/monotone_cubic.hpp"

namespace fccda {

/// Sense of rotation that drives the ship ahead, seen from aft.
enum class Hand { right, left };

/// Sections at some radii, in place of the Wageningen series; monotone cubics between them. Lists as long as `radius`, or empty where stated.
struct PropellerSections {
  std::vector<double> radius;     ///< r/R, ascending, up to 1
  std::vector<double> chord;      ///< c/D; 0 at the tip makes it pointed. The chord is the root of a cubic through c², so a tip is round
  std::vector<double> thickness;  ///< t/D
  std::vector<double> pitch;      ///< P/D
  std::vector<double> rake;       ///< k/D, aft. Empty: by `rake` of the shape
  std::vector<double> skew;       ///< θ [rad] of the middle of the chord. Empty: as in the series, plus `skew` of the shape
  std::vector<double> camber;     ///< height of the mean line over the chord, a parabola with half the thickness to each side. Empty: the face of the series
};

/// Main dimensions of a propeller.
struct PropellerShape {
  int blades = 4;                             ///< number of blades
  double diameter = 0;                        ///< D [m]
  double pitch_ratio = 0;                     ///< P/D at 0.7 R and, except for four blades, everywhere; not with `sections`
  double area_ratio = 0;                      ///< expanded area ratio; not with `sections`
  double hub_ratio = 0;                       ///< hub diameter over D
  double hub_length = 0;                      ///< [m]
  double rake = 0;                            ///< [rad] of the generator line, aft
  double skew = 0;                            ///< [rad] lag of the tip, growing with the square of the distance from the hub; added to that of the series
  double thickness_factor = 1;                ///< [-] factor on all thicknesses
  double edge_thickness = 0.1;                ///< [-] of edges and tip, over the greatest thickness of the section
  Hand hand = Hand::right;                    ///< right or left
  Axis axis = Axis::x;                        ///< of the shaft; its positive direction is ahead
  std::optional<PropellerSections> sections;  ///< none: Wageningen B
  double edge_length = 0;                     ///< [m] longest edge
  double blade_edge_length = 0;               ///< [m] longest edge at leading edge, trailing edge and tip; 0: as edge_length
};

/// One blade as a curved form.
class BladeForm {
 public:
  /// Throws InputError, one sentence, if the dimensions are inconsistent.
  explicit BladeForm(const PropellerShape& shape);

  /// The blade section at one radius.
  struct Section {
    double radius;                     ///< [m]
    double chord, leading, thickest;   ///< c, a, b [m]
    double thickness, edge_thickness;  ///< t, t_e [m]
    double bulge;                      ///< t - t_e [m], reduced close to the tip
    double pitch_angle;                ///< β [rad]
    double rake;                       ///< k [m] aft
    double skew;                       ///< θ [rad]
  };
  /// The section at a radius [m].
  Section section(double radius) const;

  /// Point of the section: `along` from -1 (trailing edge) to 1 (leading edge), `through` from 0 (face) to 1 (back). The shaft is the axis z
  /// here, the generator line of the blade is along +x; right-handed.
  Vec3d place(const Section& section, double along, double through) const;

  double root_radius() const { return root_; }                 ///< [m] of the innermost section, inside the hub
  double tip_radius() const { return 0.5 * shape_.diameter; }  ///< R [m]

  /// Developed area of all blades, from this r/R to the tip, over that of the disc [-].
  double expanded_area_ratio(double from) const;

 private:
  PropellerShape shape_;
  double root_;
  // of `sections`, over r/R; empty without them
  std::vector<MonotoneCubic> chord_squared_, thickness_, pitch_, rake_, skew_, camber_;
};

/// The hub alone, about the axis z: a cylinder with rounded edges.
struct HubForm {
  double radius = 0, length = 0;     ///< [m]
  double rounding() const;           ///< [m] radius of the rounded edges: 0.3 of the radius, at most a quarter of the length
  double radius_at(double z) const;  ///< [m] at a position along the axis [m]; smaller in the rounded edges
};

/// Triangles, oriented outward, with vertices shared within each blade and the hub. Parts `hub`, `blade_1`, `blade_2` and so on. All vertices lie
/// on the form. Edges of a blade's face, back or outline are at most as long as requested at their middle: blade_edge_length at the outline,
/// growing by 0.3 of the distance from it up to edge_length. Face and back have the same triangulation, so that they cannot intersect. The hub
/// has edges of at most edge_length between and along its rings (diagonals 1.41 times), and of half its radius.
/// Throws InputError, one sentence, if the dimensions are inconsistent or the number of panels exceeds the limit.
Panels make_propeller(const PropellerShape& shape);

}  // namespace fccda
