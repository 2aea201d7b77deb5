#include <doctest/doctest.h>

#include <fstream>
#include <iterator>

#include "fuzz/sound_or_refused.hpp"
#include "mesh_io/file/contents.hpp"

// What fuzzing kept (tests/fuzz): inputs that reach every corner of the readers, and those that once broke one.
TEST_CASE("corpus: every file that fuzzing kept is read soundly or refused in a sentence") {
  std::size_t files = 0;
  for (const auto& format : std::filesystem::directory_iterator(PROJECT_FOLDER "/tests/fuzz/corpus")) {
    for (const auto& file : std::filesystem::directory_iterator(format.path())) {
      std::ifstream stream(file.path(), std::ios::binary);
      const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
      CAPTURE(file.path().string());
      fuzz::sound_or_refused(bytes, "mesh." + format.path().filename().string());  // ends the program where it breaks
      ++files;
    }
  }
  CHECK(files > 80);
}
