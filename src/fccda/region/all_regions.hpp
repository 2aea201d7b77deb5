/// The one list of bounding regions. A new region is its file, and its name here.
#pragma once

#include <variant>

#include "fccda/region/box.hpp"

namespace fccda {

using Region = std::variant<Unbounded, BoxRegion>;

}  // namespace fccda
