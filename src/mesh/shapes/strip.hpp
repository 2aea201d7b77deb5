/// Triangles between two rows of vertices.
#pragma once

#include <span>

#include "base/vec3.hpp"

namespace fccda {

/// Fills the strip between the rows a and b, which run the same way and may have different numbers of vertices, at least 1: calls
/// add(p, q, r) for each triangle, oriented from a across to b and on along the rows. Of the two possible next edges the shorter is taken,
/// so that the triangles of a skew strip are divided across its short diagonals. Every triangle has two vertices that are neighbours in one
/// of the rows. `at(vertex)`: its position.
template <class At, class Add>
void fill_strip(std::span<const int> a, std::span<const int> b, const At& at, const Add& add) {
  std::size_t i = 0, j = 0;
  while (i + 1 < a.size() || j + 1 < b.size()) {
    const bool only_a = j + 1 == b.size(), only_b = i + 1 == a.size();
    if (only_a || (!only_b && squared_norm(at(a[i + 1]) - at(b[j])) <= squared_norm(at(a[i]) - at(b[j + 1])))) {
      add(a[i], b[j], a[i + 1]);
      ++i;
    } else {
      add(a[i], b[j], b[j + 1]);
      ++j;
    }
  }
}

}  // namespace fccda
