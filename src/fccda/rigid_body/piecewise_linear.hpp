/// A piecewise linear function, given by a table: of time in prescribed motion and loads, of speed in loads. It is constant before its first point and
/// after its last.
#pragma once

#include <vector>

namespace fccda {

class PiecewiseLinear {
 public:
  /// Throws InputError if there is no point, if the lists differ in length, or if the arguments do not increase.
  PiecewiseLinear(std::vector<double> arguments, std::vector<double> values);
  /// A constant value.
  explicit PiecewiseLinear(double value) : PiecewiseLinear({0}, {value}) {}

  double at(double x) const;

  double largest_value() const;  ///< the value of the largest magnitude
  double largest_slope() const;  ///< the derivative of the largest magnitude; 0 if there is only one point

  /// Mean over x0 <= x <= x1, exact for the linear pieces; at(x0) if x1 = x0.
  double mean(double x0, double x1) const;

  /// Mean of the derivative, (at(x1) - at(x0))/(x1 - x0) without the cancellation of this difference over a short interval; if x1 = x0, the slope
  /// just after.
  double slope(double x0, double x1) const;

 private:
  /// Calls visit(from, to, k) for each linear piece within [x0, x1]; it lies between the points k - 1 and k.
  template <class Visit>
  void for_each_fragment(double x0, double x1, const Visit& visit) const;
  std::size_t next_point(double x) const;  // the first with a larger argument
  double value_in(std::size_t k, double x) const;
  double slope_in(std::size_t k) const;

  std::vector<double> arguments_, values_;
};

}  // namespace fccda
