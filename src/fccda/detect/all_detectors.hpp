/// The one list of detectors.
#pragma once

#include <variant>

#include "fccda/detect/analytic.hpp"

namespace fccda {

using Detector = std::variant<Analytic>;

}  // namespace fccda
