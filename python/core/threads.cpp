#include "threads.hpp"

#include <fmt/format.h>

#include <atomic>

#include "base/error.hpp"
#include "base/parallel.hpp"

namespace perimpact::python {

namespace {

constexpr int most_threads = 1024;  // as of --threads
std::atomic<int> chosen_threads = 0;

}  // namespace

void choose_threads(long long count) {
  if (count < 1 || count > most_threads)
    throw fccda::InputError(fmt::format("use_threads was given {}, but the number of threads must be between 1 and {}.", count, most_threads));
  chosen_threads = static_cast<int>(count);
}

void use_chosen_threads() {
  if (const int count = chosen_threads; count > 0) fccda::use_threads(count);
}

}  // namespace perimpact::python
