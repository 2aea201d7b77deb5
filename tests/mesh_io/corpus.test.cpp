#include <doctest/doctest.h>

#include <fstream>
#include <iterator>

#include "fuzz/sound_or_refused.hpp"
#include "mesh_io/file/contents.hpp"

// Fuzzing corpus (tests/fuzz): inputs that cover the readers, and former failures.
TEST_CASE("corpus: every file of the fuzzing corpus is read soundly or refused in a sentence") {
  std::size_t files = 0;
  for (const auto& format : std::filesystem::directory_iterator(PROJECT_FOLDER "/tests/fuzz/corpus")) {
    for (const auto& file : std::filesystem::directory_iterator(format.path())) {
      std::ifstream stream(file.path(), std::ios::binary);
      const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
      CAPTURE(file.path().string());
      fuzz::sound_or_refused(bytes, "mesh." + format.path().filename().string());  // ends the program on a failure
      ++files;
    }
  }
  CHECK(files > 80);
}
