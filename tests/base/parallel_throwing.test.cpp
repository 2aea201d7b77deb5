#include "base/parallel_throwing.hpp"

#include <doctest/doctest.h>

#include <stdexcept>
#include <vector>

#include "fixtures/threads.hpp"

using namespace fccda;

TEST_CASE("parallel loop: an exception of an iteration is that of the loop, after all others are done, with any number of threads") {
  for (const int threads : {1, 3}) {
    const fixtures::Threads with_several(threads);
    std::vector<int> calls(1000, 0);
    CHECK_THROWS_WITH_AS(parallel_for_throwing(1000,
                                               [&](std::ptrdiff_t i) {
                                                 ++calls[static_cast<std::size_t>(i)];
                                                 if (i % 300 == 7) throw std::runtime_error("of an iteration");
                                               }),
                         "of an iteration", std::runtime_error);
    CHECK(calls == std::vector<int>(1000, 1));
    parallel_for_throwing(1000, [&](std::ptrdiff_t i) { --calls[static_cast<std::size_t>(i)]; });
    CHECK(calls == std::vector<int>(1000, 0));
  }
}
