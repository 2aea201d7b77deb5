#include "perimpact/self_contact/wrapped_cells.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/parallel.hpp"

namespace perimpact {

namespace {

/// Index of the cube along an axis; positions that are NaN or out of range share the cube 0.
std::int64_t cube(double position, double edge) {
  constexpr double most = 1e15;
  const double number = std::floor(position / edge);
  return std::fabs(number) < most ? static_cast<std::int64_t>(number) : 0;
}

}  // namespace

void WrappedCells::sort(const VectorArray& points, double edge) {
  constexpr double far = std::numeric_limits<double>::infinity();
  const std::size_t count = points.slots();
  std::array<std::array<double, 2>, 3> ends;  // minimum and maximum along each axis
  for (std::size_t c = 0; c < 3; ++c) {
    ends[c] = {far, -far};
    for (std::size_t p = 0; p < count; ++p) ends[c] = {std::min(ends[c][0], points.component(c)[p]), std::max(ends[c][1], points.component(c)[p])};
  }
  constexpr unsigned most_bits = 10;  // a thousand cells along an axis
  for (std::size_t c = 0; c < 3; ++c) {
    const double length = ends[c][1] - ends[c][0];
    bits_[c] = length > 0 ? 2 : 0;
    while (length > 0 && bits_[c] < most_bits && static_cast<double>(std::size_t{1} << bits_[c]) * edge < length) ++bits_[c];
  }
  // about as many cells as points
  while (bits_[0] + bits_[1] + bits_[2] > 6 && (std::size_t{1} << (bits_[0] + bits_[1] + bits_[2])) > count) --*std::max_element(bits_.begin(), bits_.end());

  cell_of_.resize(count);
  fccda::parallel_for(static_cast<std::ptrdiff_t>(count), [&](std::ptrdiff_t p) {
    const auto along = [&](std::size_t c) { return static_cast<std::size_t>(cube(points.component(c)[p], edge)) & mask(c); };
    cell_of_[static_cast<std::size_t>(p)] = static_cast<std::uint32_t>((along(2) << (bits_[0] + bits_[1])) | (along(1) << bits_[0]) | along(0));
  });
  first_.assign((std::size_t{1} << (bits_[0] + bits_[1] + bits_[2])) + 1, 0);
  for (const std::uint32_t cell : cell_of_) ++first_[cell + 1];
  for (std::size_t cell = 1; cell < first_.size(); ++cell) first_[cell] += first_[cell - 1];
  points_.resize(count);
  if (sorted_.slots() != count) sorted_ = VectorArray(count, fccda::byte_lanes);
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for (std::size_t p = 0; p < count; ++p) {
    const std::uint32_t place = next[cell_of_[p]]++;
    points_[place] = static_cast<std::uint32_t>(p);
    sorted_.set(place, points.at(p));
  }
}

}  // namespace perimpact
