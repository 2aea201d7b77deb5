/// Argument checks: values that are not finite, or out of range, are rejected before they propagate.
#pragma once

#include <cmath>
#include <sstream>
#include <string>
#include <string_view>

#include "base/error.hpp"
#include "base/vec3.hpp"

namespace fccda {

/// "0.5", for messages.
inline std::string in_words(double number) {
  std::ostringstream text;
  text << number;
  return text.str();
}

/// "(1, 2, 3)"
inline std::string in_words(const Vec3d& x) { return '(' + in_words(x.x) + ", " + in_words(x.y) + ", " + in_words(x.z) + ')'; }

/// Throws InputError("what is nan, but it must be finite."). `what`: "contact: the position of the body at t1"
inline void expect_finite(double number, std::string_view what) {
  if (!std::isfinite(number)) throw InputError(std::string(what) + " is " + in_words(number) + ", but it must be finite.");
}
/// The same for the three components.
inline void expect_finite(const Vec3d& vector, std::string_view what) {
  if (!is_finite(vector)) throw InputError(std::string(what) + " is " + in_words(vector) + ", but it must be finite.");
}

/// The coefficient of Coulomb friction: finite and not negative.
inline void expect_friction(double friction) {
  if (!(friction >= 0 && std::isfinite(friction)))
    throw InputError("contact: the friction coefficient is " + in_words(friction) + ", but it must be a finite number of at least 0.");
}

}  // namespace fccda
