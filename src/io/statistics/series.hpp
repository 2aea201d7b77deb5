/// One column of a table as a function of time: mean, standard deviation, extremes, resampling at even intervals.
///
/// Interval means (forces) give a piecewise constant function, whose integral, the impulse, is exact. Instantaneous values are interpolated
/// linearly. All statistics are those of this function, so rows need not be evenly spaced, and closely spaced rows have no excess weight.
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
  /// `times` [s]: increasing, at least two; both spans must outlive this object.
  Series(std::span<const double> times, std::span<const double> values, RowIs row_is) : times_(times), values_(values), row_is_(row_is) {}

  // From t0 to t1 [s], both within the times of the rows, t0 < t1.
  double mean(double t0, double t1) const;
  double standard_deviation(double t0, double t1) const;  ///< root of the mean square about the mean
  Extreme maximum(double t0, double t1) const;
  Extreme minimum(double t0, double t1) const;

  /// Means over `count` successive intervals of length `interval` [s] from t0.
  std::vector<double> resampled(double t0, double interval, std::size_t count) const;

 private:
  template <class Visit>
  void for_each_part(double t0, double t1, const Visit& visit) const;
  double value_at(std::size_t row, double time) const;

  std::span<const double> times_, values_;
  RowIs row_is_;
};

}  // namespace perimpact
