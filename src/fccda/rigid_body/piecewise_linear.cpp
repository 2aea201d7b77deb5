#include "fccda/rigid_body/piecewise_linear.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "base/error.hpp"

namespace fccda {

PiecewiseLinear::PiecewiseLinear(std::vector<double> arguments, std::vector<double> values) : arguments_(std::move(arguments)), values_(std::move(values)) {
  if (arguments_.empty()) throw InputError("table: there are no points; give at least one.");
  if (arguments_.size() != values_.size())
    throw InputError("table: there are " + std::to_string(arguments_.size()) + " arguments and " + std::to_string(values_.size()) +
                     " values, but each argument needs one value.");
  for (std::size_t k = 0; k < arguments_.size(); ++k) {
    if (!std::isfinite(arguments_[k]) || !std::isfinite(values_[k]))
      throw InputError("table: point " + std::to_string(k + 1) + " is not a finite number; correct it.");
    if (k > 0 && !(arguments_[k] > arguments_[k - 1]))
      throw InputError("table: point " + std::to_string(k + 1) + " is at " + std::to_string(arguments_[k]) + ", after one at " +
                       std::to_string(arguments_[k - 1]) + ", but arguments must increase.");
  }
}

std::size_t PiecewiseLinear::next_point(double x) const {
  return static_cast<std::size_t>(std::upper_bound(arguments_.begin(), arguments_.end(), x) - arguments_.begin());
}

double PiecewiseLinear::value_in(std::size_t k, double x) const {
  if (k == 0) return values_.front();
  if (k == arguments_.size()) return values_.back();
  return values_[k - 1] + (values_[k] - values_[k - 1]) * ((x - arguments_[k - 1]) / (arguments_[k] - arguments_[k - 1]));
}

double PiecewiseLinear::slope_in(std::size_t k) const {
  if (k == 0 || k == arguments_.size()) return 0;
  return (values_[k] - values_[k - 1]) / (arguments_[k] - arguments_[k - 1]);
}

template <class Visit>
void PiecewiseLinear::for_each_fragment(double x0, double x1, const Visit& visit) const {
  for (std::size_t k = next_point(x0); x0 < x1; ++k) {
    const double end = k < arguments_.size() ? std::min(arguments_[k], x1) : x1;
    visit(x0, end, k);
    x0 = end;
  }
}

double PiecewiseLinear::at(double x) const { return value_in(next_point(x), x); }

double PiecewiseLinear::largest_value() const {
  return *std::max_element(values_.begin(), values_.end(), [](double a, double b) { return std::fabs(a) < std::fabs(b); });
}

double PiecewiseLinear::largest_slope() const {
  double largest = 0;
  for (std::size_t k = 1; k < arguments_.size(); ++k)
    if (const double slope = slope_in(k); std::fabs(slope) > std::fabs(largest)) largest = slope;
  return largest;
}

double PiecewiseLinear::mean(double x0, double x1) const {
  const std::size_t k = next_point(x0);
  if (k == arguments_.size() || x1 <= arguments_[k]) return value_in(k, 0.5 * (x0 + x1));  // exact for a constant
  double integral = 0;
  for_each_fragment(x0, x1, [&](double from, double to, std::size_t piece) { integral += (to - from) * value_in(piece, 0.5 * (from + to)); });
  return integral / (x1 - x0);
}

double PiecewiseLinear::slope(double x0, double x1) const {
  const std::size_t k = next_point(x0);
  if (k == arguments_.size() || x1 <= arguments_[k]) return slope_in(k);
  double difference = 0;
  for_each_fragment(x0, x1, [&](double from, double to, std::size_t piece) { difference += (to - from) * slope_in(piece); });
  return difference / (x1 - x0);
}

}  // namespace fccda
