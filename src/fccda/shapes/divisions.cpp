#include "fccda/shapes/divisions.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

#include "fccda/core/error.hpp"

namespace fccda {
namespace {
constexpr double rounding = 1e-9;  // of decimal lengths, far below any tolerance of manufacture
}

double divisions(double length, double panel) { return std::max(1.0, std::ceil(length / panel * (1 - rounding))); }

double circle_divisions(double radius, double panel) {
  const double half_chord = 0.5 * panel / radius * (1 + rounding);
  if (half_chord >= 1) return 4;
  return std::max(4.0, 4 * std::ceil(0.25 * std::numbers::pi / std::asin(half_chord)));
}

void expect_affordable(double panels, double panel, std::string_view shape) {
  constexpr double most = 1e8;
  if (panels <= most) return;
  std::ostringstream sentence;
  sentence << shape << ": panels of " << panel << " m would be " << panels << " in number, more than the " << most << " that fit in memory; use larger ones.";
  throw InputError(sentence.str());
}

}  // namespace fccda
