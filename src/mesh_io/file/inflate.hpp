/// Unpacking of what zlib has packed.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace fccda {

/// The contents of a gzip file, all members one after the other. Throws InputError where it is no gzip file, cut short, damaged, or
/// unpacks to more than 256 times its size and 64 MiB.
std::string gunzip(std::string_view packed, const std::string& file);

/// A zlib stream that unpacks to exactly `size` bytes; nothing where it does not. Takes memory of `size`, so check that first: zlib packs
/// at most 1032 bytes into one.
std::optional<std::string> inflated(std::string_view packed, std::size_t size);

}  // namespace fccda
