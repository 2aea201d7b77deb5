/// What is in a file.
#pragma once

#include <filesystem>
#include <string>

namespace fccda {

/// All bytes of the file, as they are. Throws InputError where it is not there, is no file, empty, or cannot be read.
std::string contents_of(const std::filesystem::path& path);

/// Does the name end in `.gz`? Then the contents are to be unpacked (inflate.hpp).
bool is_gzip(const std::filesystem::path& path);

/// hull.stl for hull.stl.gz; other names as they are.
std::filesystem::path unpacked(const std::filesystem::path& path);

}  // namespace fccda
