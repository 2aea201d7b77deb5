/// A screw propeller: a hub and blades that reach into it, each closed by itself; contact strikes their union.
///
/// Axes, with the shaft along x: x forward, y and z across, the origin in the middle of the hub. The first blade's generator line runs along +y,
/// the others follow towards +z. A right-handed propeller drives ahead while it turns from y towards z; a left-handed one is its mirror
/// image. With another axis the coordinates are exchanged in turn.
///
/// A blade is a stack of sections on cylinders of the radii r. A section has the chord c, its leading edge s = a before the generator line and its
/// trailing edge c - a behind; y_face and y_back are the heights of its two sides above the chord line (wageningen.hpp). With the pitch angle
/// β = atan(P(r)/(2 π r)) a point of it lies at
///
///   X = s sin β + y cos β - k(r)              along the shaft; k is the rake, r tan(rake) or as given
///   angle = (s cos β - y sin β)/r             about it
///
/// Over the last three thicknesses before the tip the section thins to that of its edges, so that the outline has one edge all around.
///
/// Skew moves the section along its helix: s - θ r/cos β in place of s. The back, which sucks when going ahead, faces forward.
#pragma once

#include <optional>
#include <vector>

#include "mesh/shapes/axis.hpp"
#include "mesh/shapes/monotone_cubic.hpp"

namespace fccda {

enum class Hand { right, left };

/// Sections at some radii, in place of the Wageningen series; monotone cubics between them. Lists as long as `radius`, or empty where said so.
struct PropellerSections {
  std::vector<double> radius;     ///< r/R, rising, up to 1
  std::vector<double> chord;      ///< c/D; 0 at the tip makes it pointed. The chord is the root of a cubic through c², so a tip is round
  std::vector<double> thickness;  ///< t/D
  std::vector<double> pitch;      ///< P/D
  std::vector<double> rake;       ///< k/D, aft. Empty: by `rake` of the shape
  std::vector<double> skew;       ///< θ [rad] of the middle of the chord. Empty: as in the series, plus `skew` of the shape
  std::vector<double> camber;     ///< height of the mean line over the chord, a parabola with half the thickness to each side. Empty: the face of the series
};

struct PropellerShape {
  int blades = 4;
  double diameter = 0;          ///< D [m]
  double pitch_ratio = 0;       ///< P/D at 0.7 R and, but for four blades, everywhere; not with sections of one's own
  double area_ratio = 0;        ///< expanded area ratio; not with sections of one's own
  double hub_ratio = 0;         ///< hub diameter over D
  double hub_length = 0;        ///< [m]
  double rake = 0;              ///< [rad] of the generator line, aft
  double skew = 0;              ///< [rad] by which the tip lags, growing with the square of the distance from the hub; beside what the series has
  double thickness_factor = 1;  ///< [-] multiplies all thicknesses
  double edge_thickness = 0.1;  ///< [-] of edges and tip, over the greatest thickness of the section
  Hand hand = Hand::right;
  Axis axis = Axis::x;
  std::optional<PropellerSections> sections;  ///< none: Wageningen B
  double edge_length = 0;                     ///< [m] longest edge
  double blade_edge_length = 0;               ///< [m] longest edge at leading edge, trailing edge and tip; 0: as elsewhere
};

/// One blade as a curved shape.
class BladeForm {
 public:
  /// Throws InputError, one sentence, where the sizes make no blade.
  explicit BladeForm(const PropellerShape& shape);

  struct Section {
    double radius;                     ///< [m]
    double chord, leading, thickest;   ///< c, a, b [m]
    double thickness, edge_thickness;  ///< t, t_e [m]
    double bulge;                      ///< t - t_e [m], less close to the tip
    double pitch_angle;                ///< β [rad]
    double rake;                       ///< k [m] aft
    double skew;                       ///< θ [rad]
  };
  Section section(double radius) const;

  /// On the section: `along` from -1 (trailing edge) to 1 (leading edge), `through` from 0 (face) to 1 (back). The shaft is the axis z here, the
  /// generator line of the blade runs along +x; right-handed.
  Vec3d place(const Section& section, double along, double through) const;

  double root_radius() const { return root_; }  ///< [m] of the innermost section, inside the hub
  double tip_radius() const { return 0.5 * shape_.diameter; }

  /// Area of all blades laid flat, from this r/R to the tip, over that of the disc [-].
  double expanded_area_ratio(double from) const;

 private:
  PropellerShape shape_;
  double root_;
  // of sections of one's own, over r/R; empty where there are none
  std::vector<MonotoneCubic> chord_squared_, thickness_, pitch_, rake_, skew_, camber_;
};

/// The hub alone, about the axis z: a cylinder with rounded rims.
struct HubForm {
  double radius = 0, length = 0;  ///< [m]
  double rounding() const;        ///< [m] radius of the rims: 0.3 of the radius, a quarter of the length at most
  double radius_at(double z) const;
};

/// Triangles, wound outward, vertices shared within a blade and the hub. Parts `hub`, `blade_1`, `blade_2` and so on. All vertices lie on the form. No
/// edge of a blade's face, back or outline is longer than the panel asked at its middle: edge_panel at the outline, growing by 0.3 of the distance from
/// it up to panel. Face and back are cut alike, so that they cannot cross. The hub has edges of at most panel between and along its rings
/// (diagonals 1.41 times), and of half its radius.
/// Throws InputError, one sentence, where the sizes make no propeller or there would be too many panels.
Panels make_propeller(const PropellerShape& shape);

}  // namespace fccda
