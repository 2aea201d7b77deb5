/// Compression of output arrays.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace perimpact::output {

/// The fastest level of zlib: numbers of a simulation gain little from higher ones.
inline constexpr int deflate_level = 1;

/// The bytes as a zlib stream. Throws std::bad_alloc.
std::vector<std::byte> deflated(std::span<const std::byte> bytes);

}  // namespace perimpact::output
