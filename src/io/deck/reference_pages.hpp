/// The files of reference_pages/, embedded in the program by CMake.
#pragma once

#include <span>
#include <string_view>

namespace perimpact::deck {

struct PageSource {
  std::string_view name;  ///< of the file, without extension
  std::string_view text;
};

std::span<const PageSource> page_sources();

}  // namespace perimpact::deck
