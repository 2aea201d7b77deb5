#include "mesh/shapes/monotone_cubic.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/contract.hpp"

namespace fccda {
namespace {

/// The slope at the first of three points, from the lengths h and slopes d of the first two intervals.
double end_slope(double h0, double h1, double d0, double d1) {
  const double slope = ((2 * h0 + h1) * d0 - h0 * d1) / (h0 + h1);
  if (slope * d0 <= 0) return 0;
  if (d0 * d1 <= 0 && std::fabs(slope) > 3 * std::fabs(d0)) return 3 * d0;
  return slope;
}

}  // namespace

MonotoneCubic::MonotoneCubic(std::vector<double> x, std::vector<double> y) : x_(std::move(x)), y_(std::move(y)), slope_(x_.size()) {
  EXPECTS(x_.size() == y_.size() && x_.size() >= 2);
  EXPECTS(std::is_sorted(x_.begin(), x_.end(), std::less_equal<>()));
  const std::size_t last = x_.size() - 1;
  std::vector<double> h(last), d(last);
  for (std::size_t k = 0; k < last; ++k) h[k] = x_[k + 1] - x_[k], d[k] = (y_[k + 1] - y_[k]) / h[k];
  for (std::size_t k = 1; k < last; ++k) {
    const double w1 = 2 * h[k] + h[k - 1], w2 = h[k] + 2 * h[k - 1];
    slope_[k] = d[k - 1] * d[k] > 0 ? (w1 + w2) / (w1 / d[k - 1] + w2 / d[k]) : 0;
  }
  slope_[0] = last == 1 ? d[0] : end_slope(h[0], h[1], d[0], d[1]);
  slope_[last] = last == 1 ? d[0] : end_slope(h[last - 1], h[last - 2], d[last - 1], d[last - 2]);
}

double MonotoneCubic::operator()(double x) const {
  if (x <= x_.front()) return y_.front();
  if (x >= x_.back()) return y_.back();
  const auto k = static_cast<std::size_t>(std::upper_bound(x_.begin(), x_.end(), x) - x_.begin() - 1);
  const double h = x_[k + 1] - x_[k], t = (x - x_[k]) / h, s = 1 - t;
  return s * s * (1 + 2 * t) * y_[k] + t * t * (1 + 2 * s) * y_[k + 1] + h * t * s * (s * slope_[k] - t * slope_[k + 1]);
}

}  // namespace fccda
