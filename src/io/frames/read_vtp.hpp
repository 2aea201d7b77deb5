/// Reader of frames in files of their own.
#pragma once

#include <filesystem>

#include "io/frames/frame.hpp"

namespace perimpact::frames {

/// Reads a file written by output::write_vtp. Throws InputError with the file and the line where it is missing or damaged.
Frame read_vtp(const std::filesystem::path& path);

}  // namespace perimpact::frames
