/// A piecewise linear function of time, given by a table; constant before its first point and after its last.
#pragma once

#include <vector>

namespace fccda {

class TimeTable {
 public:
  /// Throws InputError if there is no point, if the lists differ in length, or if the times do not increase.
  TimeTable(std::vector<double> times, std::vector<double> values);
  /// A constant value.
  explicit TimeTable(double value) : TimeTable({0}, {value}) {}

  double at(double time) const;

  double largest_value() const;  ///< the value of the largest magnitude
  double largest_slope() const;  ///< the derivative of the largest magnitude; 0 if there is only one point

  /// Mean over t0 <= t <= t1, exact for the linear pieces; at(t0) if t1 = t0.
  double mean(double t0, double t1) const;

  /// Mean of the derivative, (at(t1) - at(t0))/(t1 - t0) without the cancellation of this difference over a short time; if t1 = t0, the slope
  /// just after.
  double slope(double t0, double t1) const;

 private:
  /// Calls visit(from, to, k) for each linear piece within [t0, t1]; it lies between the points k - 1 and k.
  template <class Visit>
  void for_each_fragment(double t0, double t1, const Visit& visit) const;
  std::size_t next_point(double time) const;  // the first at a later time
  double value_in(std::size_t k, double time) const;
  double slope_in(std::size_t k) const;

  std::vector<double> times_, values_;
};

}  // namespace fccda
