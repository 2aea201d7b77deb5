#include "fccda/modes/modes_on.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "base/error.hpp"
#include "base/finite.hpp"

namespace fccda {
namespace {

constexpr double matching = 1e-6;      // of the size: single precision resolves 1e-7
constexpr double independence = 1e-6;  // part of a mode that no combination of others has: mode shapes in single precision have 1e-7

double size_of(std::span<const Vec3d> points) {
  if (points.empty()) return 0;
  Vec3d low = points.front(), high = points.front();
  for (const Vec3d& point : points) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], point[axis]);
      high[axis] = std::max(high[axis], point[axis]);
    }
  }
  return norm(high - low);
}

/// Points sorted along a direction that planes of a mesh rarely have, so that few lie at the same place along it.
class SortedPoints {
 public:
  SortedPoints(std::span<const Vec3d> points, double tolerance) : points_(points), tolerance_(tolerance), order_(points.size()), places_(points.size()) {
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::vector<double> along(points.size());
    std::transform(points.begin(), points.end(), along.begin(), place);
    std::stable_sort(order_.begin(), order_.end(), [&](std::size_t a, std::size_t b) { return along[a] < along[b]; });
    std::transform(order_.begin(), order_.end(), places_.begin(), [&](std::size_t point) { return along[point]; });
  }

  /// The points within the tolerance, the nearest first.
  std::vector<std::size_t> near(const Vec3d& position) const {
    const auto first = std::lower_bound(places_.begin(), places_.end(), place(position) - 2 * tolerance_);
    std::vector<std::size_t> found;
    for (auto at = static_cast<std::size_t>(first - places_.begin()); at < places_.size() && places_[at] <= place(position) + 2 * tolerance_; ++at)
      if (distance(order_[at], position) <= tolerance_) found.push_back(order_[at]);
    std::stable_sort(found.begin(), found.end(), [&](std::size_t a, std::size_t b) { return distance(a, position) < distance(b, position); });
    return found;
  }

  /// Of all points.
  std::size_t nearest(const Vec3d& position) const {
    std::size_t best = 0;
    for (std::size_t point = 1; point < points_.size(); ++point)
      if (distance(point, position) < distance(best, position)) best = point;
    return best;
  }

  double distance(std::size_t point, const Vec3d& position) const { return norm(points_[point] - position); }

 private:
  static double place(const Vec3d& position) { return dot(position, Vec3d{0.5403023, 0.6421092, 0.5438214}); }  // of length 1

  std::span<const Vec3d> points_;
  double tolerance_;
  std::vector<std::size_t> order_;
  std::vector<double> places_;
};

std::vector<char> used_vertices(const Panels& panels) {
  std::vector<char> is_used(panels.vertices.size(), 0);
  for (const auto& panel : panels.panels)
    for (const int vertex : panel)
      if (vertex >= 0) is_used[static_cast<std::size_t>(vertex)] = 1;
  return is_used;
}

class Matching {
 public:
  Matching(const Panels& panels, const ModesFile& file)
      : panels_(panels), file_(file), tolerance_(matching * size_of(panels.vertices)), points_(file.points, tolerance_) {}

  /// For each vertex the point of the file, or nothing for an unused one without a point.
  std::vector<std::optional<std::size_t>> points() const {
    const std::vector<char> is_used = used_vertices(panels_);
    std::vector<std::optional<std::size_t>> found;
    for (std::size_t v = 0; v < panels_.vertices.size(); ++v) {
      const std::vector<std::size_t> near = points_.near(panels_.vertices[v]);
      if (near.empty() && is_used[v]) refuse_lonely(v);
      for (const std::size_t other : near) expect_same_motion(near.front(), other, v);
      found.push_back(near.empty() ? std::nullopt : std::optional(near.front()));
    }
    return found;
  }

 private:
  [[noreturn]] void refuse_lonely(std::size_t v) const {
    const Vec3d& vertex = panels_.vertices[v];
    std::string sentence = file_.file + ": vertex " + std::to_string(v) + " of the surface (counted from 0), at " + in_words(vertex) +
                           " m, has no point within " + in_words(tolerance_) + " m, a millionth of the size of the surface; ";
    if (file_.points.empty()) throw InputError(sentence + "the file has no points: export it again.");
    const std::size_t nearest = points_.nearest(vertex);
    sentence += "the nearest is at " + in_words(file_.points[nearest]) + " m, " + in_words(points_.distance(nearest, vertex)) + " m away. ";
    const double size = size_of(panels_.vertices), other = size_of(file_.points);
    constexpr double another_unit = 5;
    if (other > another_unit * size || size > another_unit * other)
      throw InputError(sentence + "The points extend over " + in_words(other) + " m, the surface over " + in_words(size) +
                       " m: convert the file to metres, or give the surface its scale.");
    throw InputError(sentence + "Make surface and modes from the same mesh, in the same axes.");
  }

  void expect_same_motion(std::size_t one, std::size_t other, std::size_t v) const {
    if (one == other) return;
    for (std::size_t m = 0; m < file_.modes.size(); ++m) {
      const std::vector<Vec3d>& shape = file_.modes[m].shape;
      constexpr double rounding = 1e-5;  // of numbers that a file has with six digits
      if (norm(shape[one] - shape[other]) > rounding * std::max(norm(shape[one]), norm(shape[other])))
        throw InputError(file_.file + ": points " + std::to_string(std::min(one, other)) + " and " + std::to_string(std::max(one, other)) +
                         " (counted from 0) are both at vertex " + std::to_string(v) + " of the surface, at " + in_words(panels_.vertices[v]) +
                         " m, but mode_" + std::to_string(m + 1) + " moves them differently; connect the parts of the model there, or export one of them.");
    }
  }

  const Panels& panels_;
  const ModesFile& file_;
  double tolerance_;
  SortedPoints points_;
};

/// Values of the vertices from those of the points; nothing where the points have none.
template <class Value>
std::vector<Value> of_vertices(const std::vector<Value>& of_points, std::span<const std::optional<std::size_t>> points) {
  std::vector<Value> values;
  if (of_points.empty()) return values;
  for (const std::optional<std::size_t>& point : points) values.push_back(point ? of_points[*point] : Value{});
  return values;
}

double product(std::span<const Vec3d> a, std::span<const Vec3d> b) {
  double sum = 0;
  for (std::size_t v = 0; v < a.size(); ++v) sum += dot(a[v], b[v]);
  return sum;
}

/// Gram–Schmidt: what is left of a mode without the directions of those before it.
void expect_independent(const Modes& modes, const std::string& file) {
  std::vector<std::vector<Vec3d>> basis;
  for (std::size_t m = 0; m < modes.size(); ++m) {
    std::vector<Vec3d> left = modes[m].shape;
    const double whole = std::sqrt(product(left, left));
    const std::string mode = "mode_" + std::to_string(m + 1);
    if (!(whole > 0)) throw InputError(file + ": " + mode + " does not move the surface; remove the mode.");
    for (const std::vector<Vec3d>& direction : basis) {
      const double share = product(left, direction);
      for (std::size_t v = 0; v < left.size(); ++v) left[v] -= share * direction[v];
    }
    const double rest = std::sqrt(product(left, left));
    if (!(rest > independence * whole))
      throw InputError(file + ": on the surface " + mode + " is a linear combination of the modes before it; remove the repeated mode.");
    for (Vec3d& vector : left) vector = (1 / rest) * vector;
    basis.push_back(std::move(left));
  }
}

}  // namespace

Modes modes_on(const Panels& panels, const ModesFile& file) {
  const std::vector<std::optional<std::size_t>> points = Matching(panels, file).points();
  Modes modes;
  for (const Mode& mode : file.modes)
    modes.push_back({mode.angular_frequency, mode.damping_ratio, of_vertices(mode.shape, points), of_vertices(mode.stress, points)});
  expect_independent(modes, file.file);
  return modes;
}

}  // namespace fccda
