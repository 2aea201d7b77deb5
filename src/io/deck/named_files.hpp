/// Files referenced by a deck: surfaces, point clouds, tables, modes.
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

namespace perimpact::deck {

/// The values of all keys `file` and `modes` in a text of setup_to_text, in order.
std::vector<std::filesystem::path> named_files(std::string_view setup);

}  // namespace perimpact::deck
