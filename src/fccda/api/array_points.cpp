#include "fccda/api/array_points.hpp"

#include <cmath>
#include <string>

#include "base/error.hpp"
#include "base/finite.hpp"

namespace fccda {

namespace {

double squared_path(ConstVectors x_t0, ConstVectors x_t1, std::size_t i) { return squared_norm(x_t1[i] - x_t0[i]); }

[[noreturn]] void refuse_path(ConstVectors x_t0, ConstVectors x_t1, double longest) {
  std::size_t i = 0;
  while (std::sqrt(squared_path(x_t0, x_t1, i)) <= longest) ++i;
  const std::string sentence = "contact: point " + std::to_string(i) + " goes from " + in_words(x_t0[i]) + " to " + in_words(x_t1[i]) + " in one step, ";
  if (!std::isfinite(squared_path(x_t0, x_t1, i))) throw RunError(sentence + "which is not finite; the solver has become unstable, use a shorter step.");
  throw RunError(sentence + "farther than " + in_words(longest) +
                 " m, beyond which rounding hides its contact; the solver has become unstable, use a shorter step.");
}

}  // namespace

void measure_paths(ConstVectors x_t0, ConstVectors x_t1, double longest, std::vector<double>& travel) {
  if (x_t0.size() != x_t1.size())
    throw InputError("contact: there are " + std::to_string(x_t0.size()) + " points at the beginning of the step and " + std::to_string(x_t1.size()) +
                     " at its end; give both positions of every point.");
  travel.resize(blocks_of(x_t0.size()));
  const auto measure = [&](std::ptrdiff_t block) {
    const std::size_t begin = static_cast<std::size_t>(block) * block_size, end = std::min(begin + block_size, x_t0.size());
    double furthest = 0;
    for (std::size_t i = begin; i < end; ++i) {
      const double squared = squared_path(x_t0, x_t1, i);
      if (!(squared <= furthest)) furthest = squared;
      if (std::isnan(furthest)) break;  // comparisons with it are always false
    }
    travel[static_cast<std::size_t>(block)] = std::sqrt(furthest);
  };
  for_blocks(travel.size(), measure);
  if (!std::ranges::all_of(travel, [&](double of_block) { return of_block <= longest; })) refuse_path(x_t0, x_t1, longest);
}

}  // namespace fccda
