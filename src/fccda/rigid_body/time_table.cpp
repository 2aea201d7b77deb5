#include "fccda/rigid_body/time_table.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "base/error.hpp"

namespace fccda {

TimeTable::TimeTable(std::vector<double> times, std::vector<double> values) : times_(std::move(times)), values_(std::move(values)) {
  if (times_.empty()) throw InputError("time table: there are no points; give at least one time with its value.");
  if (times_.size() != values_.size())
    throw InputError("time table: there are " + std::to_string(times_.size()) + " times and " + std::to_string(values_.size()) +
                     " values, but each time needs one value.");
  for (std::size_t k = 0; k < times_.size(); ++k) {
    if (!std::isfinite(times_[k]) || !std::isfinite(values_[k]))
      throw InputError("time table: point " + std::to_string(k + 1) + " is not a finite number; correct it.");
    if (k > 0 && !(times_[k] > times_[k - 1]))
      throw InputError("time table: point " + std::to_string(k + 1) + " is at " + std::to_string(times_[k]) + " s, after one at " +
                       std::to_string(times_[k - 1]) + " s, but times must increase.");
  }
}

std::size_t TimeTable::next_point(double time) const { return static_cast<std::size_t>(std::upper_bound(times_.begin(), times_.end(), time) - times_.begin()); }

double TimeTable::value_in(std::size_t k, double time) const {
  if (k == 0) return values_.front();
  if (k == times_.size()) return values_.back();
  return values_[k - 1] + (values_[k] - values_[k - 1]) * ((time - times_[k - 1]) / (times_[k] - times_[k - 1]));
}

double TimeTable::slope_in(std::size_t k) const {
  if (k == 0 || k == times_.size()) return 0;
  return (values_[k] - values_[k - 1]) / (times_[k] - times_[k - 1]);
}

template <class Visit>
void TimeTable::for_each_fragment(double t0, double t1, const Visit& visit) const {
  for (std::size_t k = next_point(t0); t0 < t1; ++k) {
    const double end = k < times_.size() ? std::min(times_[k], t1) : t1;
    visit(t0, end, k);
    t0 = end;
  }
}

double TimeTable::at(double time) const { return value_in(next_point(time), time); }

double TimeTable::largest_value() const {
  return *std::max_element(values_.begin(), values_.end(), [](double a, double b) { return std::fabs(a) < std::fabs(b); });
}

double TimeTable::largest_slope() const {
  double largest = 0;
  for (std::size_t k = 1; k < times_.size(); ++k)
    if (const double slope = slope_in(k); std::fabs(slope) > std::fabs(largest)) largest = slope;
  return largest;
}

double TimeTable::mean(double t0, double t1) const {
  const std::size_t k = next_point(t0);
  if (k == times_.size() || t1 <= times_[k]) return value_in(k, 0.5 * (t0 + t1));  // exact for a constant
  double integral = 0;
  for_each_fragment(t0, t1, [&](double from, double to, std::size_t piece) { integral += (to - from) * value_in(piece, 0.5 * (from + to)); });
  return integral / (t1 - t0);
}

double TimeTable::slope(double t0, double t1) const {
  const std::size_t k = next_point(t0);
  if (k == times_.size() || t1 <= times_[k]) return slope_in(k);
  double difference = 0;
  for_each_fragment(t0, t1, [&](double from, double to, std::size_t piece) { difference += (to - from) * slope_in(piece); });
  return difference / (t1 - t0);
}

}  // namespace fccda
