/// The Points interface (detect/points.hpp) over the arrays of a caller.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "base/parallel.hpp"
#include "fccda/api/vectors.hpp"
#include "fccda/detect/points.hpp"

namespace fccda {

/// Points per block. One bound on the path length is kept per block: blocks are large enough to be cheap, and small enough that a fast point
/// makes few others due.
inline constexpr std::size_t block_size = 64;

/// Minimum number of blocks for a parallel loop: the paths of fewer are measured (in 25 µs) before other threads have woken.
inline constexpr std::ptrdiff_t blocks_worth_threads = 128;

/// Number of blocks of so many points.
inline std::size_t blocks_of(std::size_t points) { return (points + block_size - 1) / block_size; }

/// Calls body(block) for each block, in parallel where that pays off.
template <class Body>
void for_blocks(std::size_t count, const Body& body) {
  const auto blocks = static_cast<std::ptrdiff_t>(count);
  if (blocks < blocks_worth_threads)
    for (std::ptrdiff_t block = 0; block < blocks; ++block) body(block);
  else
    parallel_for(blocks, body);
}

/// Relative rounding error of the stored positions: half a unit in the last place.
inline double rounding_of(ConstVectors x) { return x.is_single() ? 0.5 * std::numeric_limits<float>::epsilon() : 0; }

/// The longest path of each block [m], into `travel`. Throws InputError if the numbers of positions differ, and RunError if a path is not finite or
/// longer than `longest` [m].
void measure_paths(ConstVectors x_t0, ConstVectors x_t1, double longest, std::vector<double>& travel);

/// Points of one contact radius.
class ArrayPoints {
 public:
  /// `travel` [m]: the longest path of each block (measure_paths).
  ArrayPoints(ConstVectors x_t0, ConstVectors x_t1, std::span<const double> travel) : x_t0_(x_t0), x_t1_(x_t1), travel_(travel) {}

  /// As the concept Points states.
  /// @{
  std::size_t size() const { return x_t0_.size(); }
  Vec3d position_t0(std::size_t i) const { return x_t0_[i]; }
  Vec3d position_t1(std::size_t i) const { return x_t1_[i]; }
  static bool occupied(std::size_t) { return true; }
  std::size_t block_count() const { return blocks_of(size()); }
  static std::size_t block_begin(std::size_t block) { return block * block_size; }
  std::size_t block_end(std::size_t block) const { return std::min((block + 1) * block_size, size()); }
  double block_travel(std::size_t block) const { return travel_[block]; }
  /// @}

 private:
  ConstVectors x_t0_, x_t1_;
  std::span<const double> travel_;
};

/// The same for points that are balls of individual radii.
class ArrayBalls : public ArrayPoints {
 public:
  /// `largest` [m]: bound of all radii.
  ArrayBalls(const ArrayPoints& points, const Numbers& radius, double largest) : ArrayPoints(points), radius_(radius), largest_(largest) {}

  double radius(std::size_t i) const { return radius_[i]; }  ///< [m]
  double largest_radius() const { return largest_; }         ///< [m]

 private:
  Numbers radius_;
  double largest_;
};
static_assert(PointsOfOwnRadius<ArrayBalls> && !PointsOfOwnRadius<ArrayPoints>);

}  // namespace fccda
