/// A quantity against time: linear between the points of a table, and held at the first value before them and at the last one after.
#pragma once

#include <vector>

namespace fccda {

class TimeTable {
 public:
  /// Throws InputError where there is no point, where the lists differ in length, or where the times do not increase.
  TimeTable(std::vector<double> times, std::vector<double> values);
  /// The same value at all times.
  explicit TimeTable(double value) : TimeTable({0}, {value}) {}

  double at(double time) const;

  double largest_value() const;  ///< the value of the largest magnitude
  double largest_slope() const;  ///< likewise, of the derivative; 0 where there is one point only

  /// Mean over t0 <= t <= t1, exact for the lines between the points; at(t0) where t1 = t0.
  double mean(double t0, double t1) const;

  /// Mean of the derivative, (at(t1) - at(t0))/(t1 - t0) without the digits that this difference loses over a short time; where t1 = t0,
  /// the slope just after.
  double slope(double t0, double t1) const;

 private:
  /// Calls visit(from, to, k) for each stretch of [t0, t1] without a kink; it lies between the points k - 1 and k.
  template <class Visit>
  void for_each_fragment(double t0, double t1, const Visit& visit) const;
  std::size_t next_point(double time) const;  // the first later than that
  double value_in(std::size_t k, double time) const;
  double slope_in(std::size_t k) const;

  std::vector<double> times_, values_;
};

}  // namespace fccda
