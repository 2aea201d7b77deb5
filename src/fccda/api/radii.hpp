/// Individual contact radii of points, which may change from step to step, for the plain calls.
#pragma once

#include <cstddef>
#include <vector>

#include "fccda/api/vectors.hpp"

namespace fccda {

/// Throws InputError if a contact radius [m] is negative or not finite.
double checked_radius(double radius);

/// Offsets of single precision (Contact::offset) must be this share of a contact radius at most, or of the surface's size for points without extent: at
/// a larger offset contact would be noticed late, and at the radius itself never.
inline constexpr double largest_offset = 0.1;

/// Throws InputError if the offset [m] is larger than that. `size` [m] of the surface.
void expect_small_offset(double offset, double radius, double size);

/// Throws InputError if there are neither so many radii nor one for all.
void expect_radii(const Numbers& radius, std::size_t points);

/// The contact radii of the previous step. A known distance is a distance beyond the point's contact radius, so a point whose radius has grown
/// must be reported to its detector.
class Radii {
 public:
  bool known() const { return !radius_.empty(); }  ///< individual radii were given in the previous step

  /// The points have the radius of their detector in this step [m].
  void note_common(double radius, std::size_t points);
  /// Those of the previous step are not known: after a restart, or with other numbers. A radius is then taken for that of the previous step.
  void forget();

  /// Takes the radii [m] of a step; returns the largest. Throws InputError if one is negative or not finite, or too small for this offset [m]
  /// (largest_offset; 0: in double precision), or their number differs from that of the points; the radii of the previous step are then kept.
  double note(const Numbers& radius, std::size_t points, double offset);

  const std::vector<std::size_t>& grown() const { return grown_; }  ///< the points whose radius is larger than in the previous step, in ascending order

 private:
  std::vector<double> radius_;     // individual ones of the previous step
  std::size_t common_points_ = 0;  // or the number of its points, which had that of the detector
  double common_ = 0;              // [m]
  std::vector<std::size_t> grown_;
};

}  // namespace fccda
