/// Files that a deck names.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

namespace perimpact::deck {

/// The full path of a file. Throws InputError at `place` of the deck if the file does not exist.
std::string full_path(const std::filesystem::path& file, const std::string& place);

/// Opens the file for reading. Throws InputError at `place` if that fails.
std::ifstream open_file(const std::string& full_path, const std::string& place);

}  // namespace perimpact::deck
