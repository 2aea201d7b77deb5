/// Decompression of gzip and zlib data.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace fccda {

/// The decompressed contents of a gzip file, all members concatenated. Throws InputError where the data are not gzip, are truncated or damaged,
/// or exceed both 256 times the compressed size and 64 MiB.
std::string gunzip(std::string_view packed, const std::string& file);

/// Decompresses a zlib stream of exactly `size` bytes; nothing for any other size. Allocates `size` bytes, so check it first: zlib compresses at most
/// 1032 bytes into one.
std::optional<std::string> inflated(std::string_view packed, std::size_t size);

}  // namespace fccda
