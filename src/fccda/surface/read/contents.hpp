/// What is in a file, unpacked where it is gzip.
#pragma once

#include <filesystem>
#include <string>

namespace fccda {

/// All bytes of the file; those of a name that ends in `.gz` are unpacked. Throws InputError where the file is not there, empty, damaged or
/// unpacks to more than 256 times its size, which no mesh does (and at least 64 MiB, so that a few zeros are no offence).
std::string contents_of(const std::filesystem::path& path);

/// Does the name end in `.gz`?
bool is_gzip(const std::filesystem::path& path);

}  // namespace fccda
