#include "mesh/shapes/divisions.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

#include "base/error.hpp"
#include "mesh/shapes/refuse.hpp"

namespace fccda {
namespace {
constexpr double rounding = 1e-9;  // of decimal lengths, far below any manufacturing tolerance
}

double divisions(double length, double panel) { return std::max(1.0, std::ceil(length / panel * (1 - rounding))); }

double circle_divisions(double radius, double panel) {
  const double half_chord = 0.5 * panel / radius * (1 + rounding);
  if (half_chord >= 1) return 4;
  return std::max(4.0, 4 * std::ceil(0.25 * std::numbers::pi / std::asin(half_chord)));
}

void expect_sizes(std::initializer_list<double> lengths, double panel, std::string_view shape) {
  for (const double length : lengths)
    if (!(length > 0 && std::isfinite(length))) refuse_shape(shape, "a length is ", length, " m, but it must be positive and finite.");
  if (!(panel >= 0)) refuse_shape(shape, "the edge length is ", panel, " m, but it must be positive; omit it for the default.");
}

void expect_affordable(double panels, double panel, std::string_view shape) {
  constexpr double most = 1e8;
  if (panels <= most) return;
  std::ostringstream sentence;
  sentence << shape << ": an edge length of " << panel << " m would give " << panels << " panels, more than the limit of " << most << "; use a larger one.";
  throw InputError(sentence.str());
}

}  // namespace fccda
