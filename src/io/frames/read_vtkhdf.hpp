/// Reader of series in one file (vtkhdf.hpp). It follows the offsets of the format, whatever the program wrote there.
#pragma once

#include <filesystem>
#include <vector>

#include "io/frames/frame.hpp"

namespace perimpact::frames {

/// Times of the steps [s]. Throws InputError with the file where it is missing or damaged.
std::vector<double> times_of_vtkhdf(const std::filesystem::path& file);

/// Reads a step, from 0. Throws InputError with the file where it is missing or damaged.
Frame read_vtkhdf(const std::filesystem::path& file, std::size_t step);

}  // namespace perimpact::frames
