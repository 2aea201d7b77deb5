/// A smooth curve through points that never overshoots them.
#pragma once

#include <vector>

namespace fccda {

/// Piecewise cubic through points (x, y), x rising, monotone wherever the points are: slopes are weighted harmonic means of those on both sides
/// (Fritsch and Butland, SIAM J. Sci. Stat. Comput. 5 (1984) 300), at the ends a parabola's, kept from overshooting. Two points give a straight line.
class MonotoneCubic {
 public:
  /// As many x as y, two at least.
  MonotoneCubic(std::vector<double> x, std::vector<double> y);

  /// Before the first point and behind the last the value is theirs.
  double operator()(double x) const;

 private:
  std::vector<double> x_, y_, slope_;
};

}  // namespace fccda
