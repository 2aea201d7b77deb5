// libFuzzer: one program for each extension, which CMakeLists.txt gives as FUZZ_NAME.
#include <cstddef>
#include <cstdint>

#include "fuzz/sound_or_refused.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::sound_or_refused({reinterpret_cast<const char*>(data), size}, FUZZ_NAME);
  return 0;
}
