/// Parallel loops of detectors over points: over all, and over selected ones.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "base/parallel_throwing.hpp"
#include "fccda/detect/points.hpp"

namespace fccda {

/// Calls evaluate(point, found of its block) for each point. Blocks are processed in parallel, each with its own Found in `found`, so that the
/// results gathered in order do not depend on the number of threads.
template <Points P, class Found, class Evaluate>
void evaluate_every_point(const P& points, std::vector<Found>& found, const Evaluate& evaluate) {
  found.resize(points.block_count());
  fetch_every_point(points);
  parallel_for_uneven_throwing(static_cast<std::ptrdiff_t>(points.block_count()), [&](std::ptrdiff_t k) {
    const auto b = static_cast<std::size_t>(k);
    found[b] = {};
    for (std::size_t i = points.block_begin(b); i < points.block_end(b); ++i)
      if (points.occupied(i)) evaluate(i, found[b]);
  });
}

/// The same for selected points, 64 at a time.
template <class Found, class Evaluate>
void evaluate_points(std::span<const std::size_t> which, std::vector<Found>& found, const Evaluate& evaluate) {
  constexpr std::size_t share = 64;
  found.resize((which.size() + share - 1) / share);
  parallel_for_uneven_throwing(static_cast<std::ptrdiff_t>(found.size()), [&](std::ptrdiff_t k) {
    const auto s = static_cast<std::size_t>(k);
    found[s] = {};
    for (const std::size_t i : which.subspan(s * share, std::min(share, which.size() - s * share))) evaluate(i, found[s]);
  });
}

}  // namespace fccda
