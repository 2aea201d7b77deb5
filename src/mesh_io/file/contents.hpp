/// File contents as bytes.
#pragma once

#include <filesystem>
#include <string>

namespace fccda {

/// All bytes of the file. Throws InputError where the file does not exist, is not a regular file, is empty or cannot be read.
std::string contents_of(const std::filesystem::path& path);

/// Whether the name ends in `.gz`, so that the contents must be decompressed (inflate.hpp).
bool is_gzip(const std::filesystem::path& path);

/// The name without `.gz`: hull.stl for hull.stl.gz; other names are unchanged.
std::filesystem::path unpacked(const std::filesystem::path& path);

}  // namespace fccda
