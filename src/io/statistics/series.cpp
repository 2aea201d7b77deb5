#include "io/statistics/series.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/contract.hpp"

namespace perimpact {

namespace {

/// An interval between two rows, or between a row and an end of the window.
struct Part {
  std::size_t row;     // row at the end of the interval, before clipping to the window
  double begin, end;   // [s]
  double first, last;  // values at its ends
  double length() const { return end - begin; }
};

}  // namespace

double Series::value_at(std::size_t row, double time) const {
  if (row_is_ == RowIs::mean_since_row_before) return values_[row];
  const double share = (time - times_[row - 1]) / (times_[row] - times_[row - 1]);
  return (1 - share) * values_[row - 1] + share * values_[row];
}

template <class Visit>
void Series::for_each_part(double t0, double t1, const Visit& visit) const {
  EXPECTS(times_.size() == values_.size() && times_.size() >= 2 && t0 < t1);
  const auto first = std::upper_bound(times_.begin() + 1, times_.end() - 1, t0);
  for (std::size_t row = static_cast<std::size_t>(first - times_.begin()); row < times_.size() && times_[row - 1] < t1; ++row) {
    const double begin = std::max(t0, times_[row - 1]), end = std::min(t1, times_[row]);
    constexpr double sliver = 1e-9;  // relative length below which an interval is a rounding artefact at the end of the window
    if (end - begin > sliver * (times_[row] - times_[row - 1])) visit(Part{row, begin, end, value_at(row, begin), value_at(row, end)});
  }
}

double Series::mean(double t0, double t1) const {
  double integral = 0, time = 0;
  for_each_part(t0, t1, [&](const Part& part) {
    integral += 0.5 * (part.first + part.last) * part.length();
    time += part.length();
  });
  return integral / time;
}

double Series::standard_deviation(double t0, double t1) const {
  const double middle = mean(t0, t1);
  double integral = 0, time = 0;
  for_each_part(t0, t1, [&](const Part& part) {
    const double a = part.first - middle, b = part.last - middle;
    integral += (a * a + a * b + b * b) / 3 * part.length();
    time += part.length();
  });
  return std::sqrt(integral / time);
}

Extreme Series::maximum(double t0, double t1) const {
  Extreme largest{-std::numeric_limits<double>::infinity(), t0};
  for_each_part(t0, t1, [&](const Part& part) {
    if (row_is_ == RowIs::value_at_its_time && part.first > largest.value) largest = {part.first, part.begin};
    if (part.last > largest.value) largest = {part.last, row_is_ == RowIs::value_at_its_time ? part.end : times_[part.row]};
  });
  return largest;
}

Extreme Series::minimum(double t0, double t1) const {
  Extreme smallest{std::numeric_limits<double>::infinity(), t0};
  for_each_part(t0, t1, [&](const Part& part) {
    if (row_is_ == RowIs::value_at_its_time && part.first < smallest.value) smallest = {part.first, part.begin};
    if (part.last < smallest.value) smallest = {part.last, row_is_ == RowIs::value_at_its_time ? part.end : times_[part.row]};
  });
  return smallest;
}

std::vector<double> Series::resampled(double t0, double interval, std::size_t count) const {
  std::vector<double> means;
  means.reserve(count);
  for (std::size_t k = 0; k < count; ++k) means.push_back(mean(t0 + static_cast<double>(k) * interval, t0 + static_cast<double>(k + 1) * interval));
  return means;
}

}  // namespace perimpact
