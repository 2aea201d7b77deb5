/// Views of vectors in the caller's own memory, whichever way they lie there:
///
///   std::vector<Vec3d> x;                  ConstVectors view = x;
///   std::vector<double> xyz;               ConstVectors view = xyz;                          x y z x y z …
///   double *x, *y, *z;                     ConstVectors view(x, y, z, count);                three arrays
///   struct Particle { double r[3], m; };   ConstVectors view(p->r, p->r + 1, p->r + 2, count, sizeof(Particle) / sizeof(double));
///
/// A view owns nothing and must not outlive the memory. `Vectors` can be written through.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <ranges>
#include <span>
#include <string>
#include <type_traits>

#include "fccda/core/error.hpp"
#include "fccda/core/vec3.hpp"

namespace fccda {

/// `Number` is double or const double.
template <class Number>
class VectorView {
  using Vector = std::conditional_t<std::is_const_v<Number>, const Vec3d, Vec3d>;
  static_assert(sizeof(Vec3d) == 3 * sizeof(double));

 public:
  VectorView() = default;

  /// Component c of vector i is the double at i·stride behind the pointer to component c of the first vector.
  VectorView(Number* x, Number* y, Number* z, std::size_t count, std::size_t stride = 1) : first_{x, y, z}, count_(count), stride_(stride) {}

  /// Vec3d one behind the other: a vector, an array, a span.
  template <std::ranges::contiguous_range Range>
  requires std::convertible_to<Range&, std::span<Vector>> VectorView(Range&& vectors) : count_(std::ranges::size(vectors)), stride_(3) {
    if (count_ == 0) return;
    Vector& first = *std::ranges::data(vectors);
    first_ = {&first.x, &first.y, &first.z};
  }

  /// Doubles x y z x y z. Throws InputError where their number is no multiple of three.
  template <std::ranges::contiguous_range Range>
  requires std::convertible_to<Range&, std::span<Number>> VectorView(Range&& xyz) : count_(std::ranges::size(xyz) / 3), stride_(3) {
    if (std::ranges::size(xyz) % 3 != 0)
      throw InputError("vectors: " + std::to_string(std::ranges::size(xyz)) + " doubles are no whole number of vectors; give x, y and z of each.");
    Number* first = std::ranges::data(xyz);
    if (count_ > 0) first_ = {first, first + 1, first + 2};
  }

  /// What can be written can be read.
  VectorView(const VectorView<double>& view) requires std::is_const_v<Number>
      : first_{view.first_[0], view.first_[1], view.first_[2]}, count_(view.count_), stride_(view.stride_) {}

  std::size_t size() const { return count_; }
  Vec3d operator[](std::size_t i) const { return {first_[0][i * stride_], first_[1][i * stride_], first_[2][i * stride_]}; }
  void set(std::size_t i, const Vec3d& vector) const requires(!std::is_const_v<Number>) {
    for (std::size_t axis = 0; axis < 3; ++axis) first_[axis][i * stride_] = vector[axis];
  }

 private:
  friend class VectorView<const double>;

  std::array<Number*, 3> first_{};
  std::size_t count_ = 0;
  std::size_t stride_ = 1;
};

using Vectors = VectorView<double>;
using ConstVectors = VectorView<const double>;

}  // namespace fccda
