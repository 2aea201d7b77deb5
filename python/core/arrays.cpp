#include "arrays.hpp"

#include <fmt/format.h>

#include "base/error.hpp"

namespace perimpact::python {

namespace {

constexpr auto number_size = static_cast<py::ssize_t>(sizeof(double));

void expect_rows_of_three(const py::array& array, const std::string& what, const Each& each = {}) {
  if (array.ndim() == 2 && array.shape(1) == 3) return;
  throw fccda::InputError(fmt::format("{} has the shape {}, but must have one row x, y, z per {}: ({}, 3).", what, shape_in_words(array), each.one, each.all));
}

bool is_single(const py::array& array) { return py::isinstance<py::array_t<float>>(array); }

bool can_be_walked(const py::array& array) {
  const py::ssize_t size = array.itemsize();
  for (py::ssize_t d = 0; d < array.ndim(); ++d)
    if (array.strides(d) % size != 0) return false;
  return reinterpret_cast<std::uintptr_t>(array.data()) % static_cast<std::uintptr_t>(size) == 0;
}

template <class View, class Number>
View view(Number* first, const py::array& array) {
  const auto component = array.strides(1) / array.itemsize(), row = array.strides(0) / array.itemsize();
  return {first, first + component, first + 2 * component, static_cast<std::size_t>(array.shape(0)), row};
}

/// An array of floats or doubles with strides that a view supports; a copy where `source` is not such an array.
py::array floats_or_doubles(const py::object& source, const std::string& what) {
  py::array array = py::array::ensure(source);
  if (array && is_single(array)) return can_be_walked(array) ? array : py::array(py::array_t<float, py::array::c_style | py::array::forcecast>(array));
  array = Numbers::ensure(source);
  if (!array) throw py::type_error(fmt::format("{} is not an array of numbers.", what));  // ensure() has cleared NumPy's error
  return can_be_walked(array) ? array : py::array(py::array_t<double, py::array::c_style | py::array::forcecast>(array));
}

}  // namespace

std::string shape_in_words(const py::array& array) { return py::str(py::tuple(array.attr("shape"))); }

fccda::ConstVectors vectors_in(Numbers& array, const std::string& what) {
  expect_rows_of_three(array, what);
  if (!can_be_walked(array)) array = py::array_t<double, py::array::c_style | py::array::forcecast>(array);
  return view<fccda::ConstVectors>(static_cast<const double*>(array.data()), array);
}

fccda::ConstVectors vectors_in(const py::object& source, const std::string& what, py::array& keep, const Each& each) {
  keep = floats_or_doubles(source, what);
  expect_rows_of_three(keep, what, each);
  if (is_single(keep)) return view<fccda::ConstVectors>(static_cast<const float*>(keep.data()), keep);
  return view<fccda::ConstVectors>(static_cast<const double*>(keep.data()), keep);
}

fccda::Numbers each_in(const py::object& source, const std::string& what, py::array& keep, const Each& each) {
  keep = floats_or_doubles(source, what);
  if (keep.ndim() > 1)
    throw fccda::InputError(
        fmt::format("{} has the shape {}, but must be one number for all {} or one per {}.", what, shape_in_words(keep), each.all, each.one));
  const auto numbers = [&](const auto* first) {
    if (keep.ndim() == 0) return fccda::Numbers(static_cast<double>(*first));
    return fccda::Numbers(first, static_cast<std::size_t>(keep.shape(0)), keep.strides(0) / keep.itemsize());
  };
  return is_single(keep) ? numbers(static_cast<const float*>(keep.data())) : numbers(static_cast<const double*>(keep.data()));
}

fccda::Vectors writable_vectors_in(const py::array& array, const std::string& what, const Each& each) {
  if (!py::isinstance<py::array_t<double>>(array) && !is_single(array))
    throw fccda::InputError(fmt::format("{} is modified in place, so it must be an array of float64 or float32, not {}; create it with dtype=float.", what,
                                        std::string(py::str(array.dtype()))));
  if (!array.writeable()) throw fccda::InputError(fmt::format("{} is modified in place, but the array is read-only; pass a copy.", what));
  expect_rows_of_three(array, what, each);
  if (!can_be_walked(array))
    throw fccda::InputError(
        fmt::format("{} is modified in place, but its strides are not multiples of the item size; pass numpy.ascontiguousarray of it.", what));
  void* first = const_cast<void*>(array.data());
  return is_single(array) ? view<fccda::Vectors>(static_cast<float*>(first), array) : view<fccda::Vectors>(static_cast<double*>(first), array);
}

py::array_t<double> array_of(std::span<const Vec3d> vectors) {
  static_assert(sizeof(Vec3d) == 3 * sizeof(double));
  py::array_t<double> array({static_cast<py::ssize_t>(vectors.size()), py::ssize_t{3}});
  std::copy_n(reinterpret_cast<const double*>(vectors.data()), 3 * vectors.size(), array.mutable_data());
  return array;
}

py::array_t<double> array_of(const fccda::Mat3& matrix) {
  py::array_t<double> array({3, 3});
  for (py::ssize_t i = 0; i < 3; ++i)
    for (py::ssize_t j = 0; j < 3; ++j) array.mutable_at(i, j) = matrix.row[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
  return array;
}

py::array_t<int> array_of(std::span<const std::array<int, 4>> panels) {
  py::array_t<int> array({static_cast<py::ssize_t>(panels.size()), py::ssize_t{4}});
  std::copy_n(reinterpret_cast<const int*>(panels.data()), 4 * panels.size(), array.mutable_data());
  return array;
}

py::array_t<std::int64_t> array_of(std::span<const std::size_t> indices) {
  py::array_t<std::int64_t> array(static_cast<py::ssize_t>(indices.size()));
  std::copy(indices.begin(), indices.end(), array.mutable_data());
  return array;
}

py::array view_of(const VectorArray& vectors, const py::object& owner) {
  const auto between_components = static_cast<py::ssize_t>(vectors.component(1) - vectors.component(0)) * number_size;
  py::array_t<double> array({static_cast<py::ssize_t>(vectors.slots()), py::ssize_t{3}}, {number_size, between_components}, vectors.component(0), owner);
  forbid_writing(array);
  return array;
}

void forbid_writing(py::array& array) { py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_; }

}  // namespace perimpact::python
