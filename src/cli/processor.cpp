// The first thing that runs, compiled for any x86-64: a program built for AVX2 must say so on a processor that lacks it, before it meets
// an instruction that ends it without a word. Compiled where PERIMPACT_ARCH is x86-64-v3 only (CMakeLists.txt).
#include <unistd.h>

#include <string_view>

namespace {

__attribute__((constructor(101))) void expect_x86_64_v3() {  // 101: before all constructors of the program's own
  __builtin_cpu_init();
  const bool is_enough = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2");
  if (is_enough) return;
  constexpr std::string_view sentence =
      "error: this build of perimpact needs a processor with AVX2 and FMA (x86-64-v3), which this one lacks; build it from its sources on this machine "
      "(./run.sh), for which any x86-64 will do.\n";
  [[maybe_unused]] const auto written = ::write(STDERR_FILENO, sentence.data(), sentence.size());
  ::_exit(2);
}

}  // namespace
