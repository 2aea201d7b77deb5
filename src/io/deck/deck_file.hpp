/// Files that a deck names.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

namespace perimpact::deck {

/// The full path of a file. Refuses at `place` of the deck where there is none.
std::string full_path(const std::filesystem::path& file, const std::string& place);

/// The same for the file of a surface; the name of panels in memory stays as it is.
std::string full_path_of_surface(const std::string& file, const std::filesystem::path& folder, const std::string& place);

/// The file, opened to be read. Refuses at `place` where it cannot be.
std::ifstream open_file(const std::string& full_path, const std::string& place);

}  // namespace perimpact::deck
