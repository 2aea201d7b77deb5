#include "perimpact/force/wrapped_cells.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fccda/core/parallel.hpp"

namespace perimpact {

namespace {

/// Number of the cube along an axis; positions that are not numbers, or beyond all that is counted, are all in one.
std::int64_t cube(double position, double edge) {
  constexpr double most = 1e15;
  const double number = std::floor(position / edge);
  return std::fabs(number) < most ? static_cast<std::int64_t>(number) : 0;
}

}  // namespace

void WrappedCells::sort(std::span<const Vec3d> points, double edge) {
  constexpr double far = std::numeric_limits<double>::infinity();
  Vec3d low{far, far, far}, high{-far, -far, -far};
  for (const Vec3d& point : points)
    for (std::size_t c = 0; c < 3; ++c) low[c] = std::min(low[c], point[c]), high[c] = std::max(high[c], point[c]);
  const std::size_t most_bits = 10;  // a thousand cells along an axis
  for (std::size_t c = 0; c < 3; ++c) {
    bits_[c] = 0;
    if (!(high[c] > low[c])) continue;
    bits_[c] = 2;
    while (bits_[c] < most_bits && static_cast<double>(std::size_t{1} << bits_[c]) * edge < high[c] - low[c]) ++bits_[c];
  }
  // about as many cells as points
  while (bits_[0] + bits_[1] + bits_[2] > 6 && (std::size_t{1} << (bits_[0] + bits_[1] + bits_[2])) > points.size()) {
    unsigned& widest = *std::max_element(bits_.begin(), bits_.end());
    --widest;
  }

  cell_of_.resize(points.size());
  fccda::parallel_for(static_cast<std::ptrdiff_t>(points.size()), [&](std::ptrdiff_t p) {
    const Vec3d& point = points[static_cast<std::size_t>(p)];
    const auto along = [&](std::size_t c) { return static_cast<std::size_t>(cube(point[c], edge)) & mask(c); };
    cell_of_[static_cast<std::size_t>(p)] = static_cast<std::uint32_t>((along(2) << (bits_[0] + bits_[1])) | (along(1) << bits_[0]) | along(0));
  });
  first_.assign((std::size_t{1} << (bits_[0] + bits_[1] + bits_[2])) + 1, 0);
  for (const std::uint32_t cell : cell_of_) ++first_[cell + 1];
  for (std::size_t cell = 1; cell < first_.size(); ++cell) first_[cell] += first_[cell - 1];
  points_.resize(points.size());
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for (std::size_t p = 0; p < points.size(); ++p) points_[next[cell_of_[p]]++] = static_cast<std::uint32_t>(p);
}

}  // namespace perimpact
