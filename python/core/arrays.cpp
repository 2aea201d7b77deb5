#include "arrays.hpp"

#include <fmt/format.h>

#include "fccda/core/error.hpp"

namespace perimpact::python {

namespace {

constexpr auto number_size = static_cast<py::ssize_t>(sizeof(double));

void expect_rows_of_three(const py::array& array, const std::string& what) {
  if (array.ndim() == 2 && array.shape(1) == 3) return;
  throw fccda::InputError(fmt::format("{} has the shape {}, but one row x, y, z a point is needed: (points, 3).", what, shape_in_words(array)));
}

bool can_be_walked(const py::array& array) {
  const auto is_whole = [](py::ssize_t stride) { return stride >= 0 && stride % number_size == 0; };
  return is_whole(array.strides(0)) && is_whole(array.strides(1)) && reinterpret_cast<std::uintptr_t>(array.data()) % alignof(double) == 0;
}

template <class Number>
fccda::VectorView<Number> view(Number* first, const py::array& array) {
  const auto component = array.strides(1) / number_size, row = array.strides(0) / number_size;
  return {first, first + component, first + 2 * component, static_cast<std::size_t>(array.shape(0)), static_cast<std::size_t>(row)};
}

}  // namespace

std::string shape_in_words(const py::array& array) { return py::str(py::tuple(array.attr("shape"))); }

fccda::ConstVectors vectors_in(Numbers& array, const std::string& what) {
  expect_rows_of_three(array, what);
  if (!can_be_walked(array)) array = py::array_t<double, py::array::c_style | py::array::forcecast>(array);
  return view(static_cast<const double*>(array.data()), array);
}

fccda::Vectors writable_vectors_in(const py::array& array, const std::string& what) {
  if (!py::isinstance<py::array_t<double>>(array))
    throw fccda::InputError(fmt::format("{} is written to, so it must be an array of float64, but it is one of {}; make it with dtype=float.", what,
                                        std::string(py::str(array.dtype()))));
  if (!array.writeable()) throw fccda::InputError(fmt::format("{} is written to, but NumPy says that it may only be read; pass a copy.", what));
  expect_rows_of_three(array, what);
  if (!can_be_walked(array))
    throw fccda::InputError(fmt::format("{} is written to, but its rows do not lie one behind the other; pass numpy.ascontiguousarray of it.", what));
  return view(static_cast<double*>(const_cast<void*>(array.data())), array);
}

py::array_t<double> array_of(std::span<const Vec3d> vectors) {
  static_assert(sizeof(Vec3d) == 3 * sizeof(double));
  py::array_t<double> array({static_cast<py::ssize_t>(vectors.size()), py::ssize_t{3}});
  std::copy_n(reinterpret_cast<const double*>(vectors.data()), 3 * vectors.size(), array.mutable_data());
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
