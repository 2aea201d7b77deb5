/// What runs the kernels of bodies, by the word of --device.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "perimpact/device/processor.hpp"

namespace perimpact {

inline constexpr std::array<std::string_view, 4> device_words{"cpu", "cuda", "cpu-scalar", "emulated"};

/// `word`: one of device_words. A device is opened by the first call, and closed at the end of the program. Throws InputError where the library of the
/// device is missing or of another version, or finds no device.
Processor opened_processor(std::string_view word);

}  // namespace perimpact
