/// Errors for inconsistent dimensions of a shape.
#pragma once

#include <sstream>
#include <string_view>

#include "base/error.hpp"

namespace fccda {

/// Throws InputError("shape: words…"), with numbers to four digits.
template <class... Words>
[[noreturn]] void refuse_shape(std::string_view shape, const Words&... words) {
  std::ostringstream sentence;
  sentence.precision(4);
  sentence << shape << ": ";
  (sentence << ... << words);
  throw InputError(sentence.str());
}

}  // namespace fccda
