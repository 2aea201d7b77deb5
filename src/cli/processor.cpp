// Runs first and is compiled for any x86-64: reports a processor without AVX2 before an illegal instruction ends the program. Compiled
// only if PERIMPACT_ARCH is x86-64-v3 (CMakeLists.txt).
#include <unistd.h>

#include <string_view>

namespace {

__attribute__((constructor(101))) void expect_x86_64_v3() {  // 101: before all other constructors of the program
  __builtin_cpu_init();
  const bool is_enough = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2");
  if (is_enough) return;
  constexpr std::string_view sentence =
      "error: this build of perimpact requires a processor with AVX2 and FMA (x86-64-v3), which this one lacks; build it from source on this machine "
      "(./run.sh), which supports any x86-64.\n";
  [[maybe_unused]] const auto written = ::write(STDERR_FILENO, sentence.data(), sentence.size());
  ::_exit(2);
}

}  // namespace
