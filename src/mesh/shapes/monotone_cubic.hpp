/// Monotone cubic interpolation: a smooth curve through points without overshoot.
#pragma once

#include <vector>

namespace fccda {

/// Piecewise cubic through points (x, y), x ascending, monotone wherever the points are. Slopes are weighted harmonic means of those on both
/// sides (Fritsch and Butland, SIAM J. Sci. Stat. Comput. 5 (1984) 300); at the ends, those of a limited parabola. Two points give a straight
/// line.
class MonotoneCubic {
 public:
  /// As many x as y, at least two.
  MonotoneCubic(std::vector<double> x, std::vector<double> y);

  /// Outside the range of the points the value is constant, that of the nearest one.
  double operator()(double x) const;

 private:
  std::vector<double> x_, y_, slope_;
};

}  // namespace fccda
