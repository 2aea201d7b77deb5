/// How a shape says that its dimensions do not go together.
#pragma once

#include <sstream>
#include <string_view>

#include "base/error.hpp"

namespace fccda {

/// Throws InputError("shape: words…"), numbers with four digits.
template <class... Words>
[[noreturn]] void refuse_shape(std::string_view shape, const Words&... words) {
  std::ostringstream sentence;
  sentence.precision(4);
  sentence << shape << ": ";
  (sentence << ... << words);
  throw InputError(sentence.str());
}

}  // namespace fccda
