/// Views of vectors in the caller's memory, in double or single precision, for any layout:
///
///   std::vector<Vec3d> x;                  ConstVectors view = x;
///   std::vector<double> xyz;               ConstVectors view = xyz;                          x y z x y z …, or floats
///   double *x, *y, *z;                     ConstVectors view(x, y, z, count);                three arrays, or of floats
///   struct Particle { double r[3], m; };   ConstVectors view(p->r, p->r + 1, p->r + 2, count, sizeof(Particle) / sizeof(double));
///
/// and of numbers: one for all points, or one for each:
///
///   std::vector<double> m;                 Numbers mass = m;                                 or floats
///   Numbers mass = 1e-3;
///   Numbers mass(&p->m, count, sizeof(Particle) / sizeof(double));
///
/// A view does not own memory and must not outlive it. `Vectors` is writable.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <ranges>
#include <span>
#include <string>
#include <type_traits>

#include "base/error.hpp"
#include "base/vec3.hpp"

namespace fccda {

/// `Number` is double or const double. The memory may contain floats nevertheless: they are read as doubles, and rounded when written.
template <class Number>
class VectorView {
  static constexpr bool is_const = std::is_const_v<Number>;
  using Vector = std::conditional_t<is_const, const Vec3d, Vec3d>;
  using Single = std::conditional_t<is_const, const float, float>;
  using Byte = std::conditional_t<is_const, const std::byte, std::byte>;
  static_assert(sizeof(Vec3d) == 3 * sizeof(double));

 public:
  VectorView() = default;
  /// Copies refer to the same memory.
  VectorView(const VectorView&) = default;
  /// Copies refer to the same memory.
  VectorView& operator=(const VectorView&) = default;

  /// Component c of vector i is at offset i·stride from the pointer to component c of the first vector; the stride counts numbers, and may be
  /// negative.
  VectorView(Number* x, Number* y, Number* z, std::size_t count, std::ptrdiff_t stride = 1)
      : first_{bytes(x), bytes(y), bytes(z)}, count_(count), stride_(stride * static_cast<std::ptrdiff_t>(sizeof(double))) {}
  /// The same for floats.
  VectorView(Single* x, Single* y, Single* z, std::size_t count, std::ptrdiff_t stride = 1)
      : first_{bytes(x), bytes(y), bytes(z)}, count_(count), stride_(stride * static_cast<std::ptrdiff_t>(sizeof(float))), single_(true) {}

  /// A contiguous range of Vec3d: a vector, an array, a span.
  template <std::ranges::contiguous_range Range>
  requires std::convertible_to<Range&, std::span<Vector>> VectorView(Range&& vectors) : count_(std::ranges::size(vectors)), stride_(sizeof(Vec3d)) {
    if (count_ == 0) return;
    Vector& first = *std::ranges::data(vectors);
    first_ = {bytes(&first.x), bytes(&first.y), bytes(&first.z)};
  }

  /// Doubles or floats x y z x y z. Throws InputError if their number is not a multiple of three.
  template <std::ranges::contiguous_range Range>
  requires std::convertible_to<Range&, std::span<Number>> VectorView(Range&& xyz)
      : VectorView(std::ranges::data(xyz), triples(std::ranges::size(xyz), "doubles")) {}
  /// The same for floats.
  template <std::ranges::contiguous_range Range>
  requires std::convertible_to<Range&, std::span<Single>> VectorView(Range&& xyz)
      : VectorView(std::ranges::data(xyz), triples(std::ranges::size(xyz), "floats")) {}

  /// A writable view converts to a read-only one.
  template <class Other>
  requires(is_const&& std::same_as<Other, double>) VectorView(const VectorView<Other>& view)
      : first_{view.first_[0], view.first_[1], view.first_[2]}, count_(view.count_), stride_(view.stride_), single_(view.single_) {}

  std::size_t size() const { return count_; }  ///< number of vectors
  bool is_single() const { return single_; }   ///< the numbers are floats
  /// Vector i, in double precision.
  Vec3d operator[](std::size_t i) const {
    return single_ ? Vec3d{*at<Single>(0, i), *at<Single>(1, i), *at<Single>(2, i)} : Vec3d{*at<Number>(0, i), *at<Number>(1, i), *at<Number>(2, i)};
  }
  /// Writes vector i, rounded where the memory has floats.
  void set(std::size_t i, const Vec3d& vector) const requires(!is_const) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (single_)
        *at<Single>(axis, i) = static_cast<float>(vector[axis]);
      else
        *at<Number>(axis, i) = vector[axis];
  }

 private:
  template <class Other>
  friend class VectorView;

  template <class One>
  VectorView(One* first, std::size_t count) : count_(count), stride_(3 * sizeof(One)), single_(sizeof(One) == sizeof(float)) {
    if (count > 0) first_ = {bytes(first), bytes(first + 1), bytes(first + 2)};
  }

  static std::size_t triples(std::size_t numbers, const char* what) {
    if (numbers % 3 != 0) throw InputError("vectors: " + std::to_string(numbers) + ' ' + what + " are not a multiple of three; give x, y and z of each.");
    return numbers / 3;
  }

  static Byte* bytes(Number* number) { return reinterpret_cast<Byte*>(number); }
  static Byte* bytes(Single* number) { return reinterpret_cast<Byte*>(number); }
  template <class One>
  One* at(std::size_t axis, std::size_t i) const {
    return reinterpret_cast<One*>(first_[axis] + static_cast<std::ptrdiff_t>(i) * stride_);
  }

  std::array<Byte*, 3> first_{};
  std::size_t count_ = 0;
  std::ptrdiff_t stride_ = 3 * sizeof(double);  // bytes
  bool single_ = false;
};

/// Writable vectors in the memory of the caller.
using Vectors = VectorView<double>;
/// Read-only vectors in the memory of the caller.
using ConstVectors = VectorView<const double>;

/// One number for all points, or one for each.
class Numbers {
 public:
  /// One number for all points.
  Numbers(double of_all) : of_all_(of_all) {}

  /// The number of point i is at offset i·stride from `first`; the stride counts numbers, and may be negative.
  Numbers(const double* first, std::size_t count, std::ptrdiff_t stride = 1)
      : first_(reinterpret_cast<const std::byte*>(first)), count_(count), stride_(stride * static_cast<std::ptrdiff_t>(sizeof(double))), each_(true) {}
  /// The same for floats.
  Numbers(const float* first, std::size_t count, std::ptrdiff_t stride = 1)
      : first_(reinterpret_cast<const std::byte*>(first)),
        count_(count),
        stride_(stride * static_cast<std::ptrdiff_t>(sizeof(float))),
        each_(true),
        single_(true) {}

  /// A contiguous range of doubles or floats: a vector, an array, a span.
  template <std::ranges::contiguous_range Range>
  requires(std::convertible_to<Range&, std::span<const double>> || std::convertible_to<Range&, std::span<const float>>) Numbers(Range&& of_each)
      : Numbers(std::ranges::data(of_each), std::ranges::size(of_each)) {}

  /// The number of point i.
  double operator[](std::size_t i) const {
    if (!each_) return of_all_;
    const std::byte* number = first_ + static_cast<std::ptrdiff_t>(i) * stride_;
    return single_ ? static_cast<double>(*reinterpret_cast<const float*>(number)) : *reinterpret_cast<const double*>(number);
  }
  bool of_each() const { return each_; }  ///< each point has its own number
  /// One for all, or exactly `count` numbers.
  bool are_for(std::size_t count) const { return !each_ || count_ == count; }

 private:
  double of_all_ = 0;
  const std::byte* first_ = nullptr;
  std::size_t count_ = 0;
  std::ptrdiff_t stride_ = sizeof(double);  // bytes
  bool each_ = false, single_ = false;
};

}  // namespace fccda
