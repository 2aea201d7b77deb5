/// One column of a table as a function of time, and what an engineer asks of it: means, spread, extremes, values at even intervals.
///
/// Rows of forces are means since the row before: the function is constant between rows, and its integral, the impulse, is exact. Rows of other
/// quantities are values at their time, with straight lines between. All numbers below are those of this function, so that rows need not be
/// evenly spaced, and none is weighted more because others are near it.
#pragma once

#include <span>
#include <vector>

namespace perimpact {

enum class RowIs { mean_since_row_before, value_at_its_time };

struct Extreme {
  double value;
  double time;  ///< [s] of the row
};

class Series {
 public:
  /// `times` [s] increasing, two or more; both must outlive this.
  Series(std::span<const double> times, std::span<const double> values, RowIs row_is) : times_(times), values_(values), row_is_(row_is) {}

  // From t0 to t1 [s], which lie in the times of the rows, t0 < t1.
  double mean(double t0, double t1) const;
  double standard_deviation(double t0, double t1) const;  ///< root of the mean square about the mean
  Extreme maximum(double t0, double t1) const;
  Extreme minimum(double t0, double t1) const;

  /// Means over `count` intervals of that length [s] that follow one another from t0 on.
  std::vector<double> resampled(double t0, double interval, std::size_t count) const;

 private:
  template <class Visit>
  void for_each_part(double t0, double t1, const Visit& visit) const;
  double value_at(std::size_t row, double time) const;

  std::span<const double> times_, values_;
  RowIs row_is_;
};

}  // namespace perimpact
