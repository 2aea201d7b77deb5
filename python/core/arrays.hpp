/// Conversion between NumPy arrays and the types of the libraries. A Vec3d is an array of shape (3,).
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "base/vec3.hpp"
#include "fccda/api/vectors.hpp"
#include "perimpact/particles/slot_array.hpp"

namespace pybind11::detail {

template <>
struct type_caster<fccda::Vec3d> {
  PYBIND11_TYPE_CASTER(fccda::Vec3d, const_name("numpy.ndarray"));
  bool load(handle source, bool convert) {
    if (!convert || !source || isinstance<str>(source)) return false;
    const auto numbers = array_t<double, array::c_style | array::forcecast>::ensure(source);
    if (!numbers || numbers.ndim() != 1 || numbers.shape(0) != 3) {
      PyErr_Clear();
      return false;
    }
    value = {numbers.at(0), numbers.at(1), numbers.at(2)};
    return true;
  }
  static handle cast(const fccda::Vec3d& vector, return_value_policy, handle) {
    array_t<double> numbers(3);
    for (ssize_t c = 0; c < 3; ++c) numbers.mutable_at(c) = vector[static_cast<std::size_t>(c)];
    return numbers.release();
  }
};

}  // namespace pybind11::detail

namespace perimpact::python {

namespace py = pybind11;
using fccda::Vec3d;

/// Any numbers convertible to doubles; a copy where they are not doubles.
using Numbers = py::array_t<double, py::array::forcecast>;

/// The shape as text: "(960, 2)".
std::string shape_in_words(const py::array& array);

/// What an array has one row or number for, in messages.
struct Each {
  const char* one = "point";
  const char* all = "points";
};
inline constexpr Each each_vertex{"vertex", "vertices"};

/// View of rows of three. `what`: name of the array in messages. Throws InputError for another shape. The array must outlive the view;
/// `array` becomes a copy where a view does not support its strides.
fccda::ConstVectors vectors_in(Numbers& array, const std::string& what);

/// The same for anything convertible to an array; float32 is viewed without conversion. `keep` owns the memory and must outlive the view.
fccda::ConstVectors vectors_in(const py::object& source, const std::string& what, py::array& keep, const Each& each = {});

/// One number, or one per point (or what else `each` says), from anything convertible to an array. Throws InputError for more than one dimension.
fccda::Numbers each_in(const py::object& source, const std::string& what, py::array& keep, const Each& each = {});

/// Writable view of rows of three. Also throws InputError where the array is not of float64 or float32, or is read-only.
fccda::Vectors writable_vectors_in(const py::array& array, const std::string& what, const Each& each = {});

/// A copy as an array of shape (vectors, 3).
py::array_t<double> array_of(std::span<const Vec3d> vectors);

/// A copy as an array of shape (3, 3).
py::array_t<double> array_of(const fccda::Mat3& matrix);

/// A copy of the vertex numbers of triangles as an array of shape (triangles, 3). `triangles`: of a Surface.
template <class Triangles>
py::array_t<int> vertex_numbers_of(const Triangles& triangles) {
  py::array_t<int> array({static_cast<py::ssize_t>(triangles.size()), py::ssize_t{3}});
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t c = 0; c < 3; ++c) array.mutable_at(static_cast<py::ssize_t>(t), static_cast<py::ssize_t>(c)) = triangles[t].vertex[c];
  return array;
}

/// A copy of the vertex numbers of panels as an array of shape (panels, 4).
py::array_t<int> array_of(std::span<const std::array<int, 4>> panels);

/// A copy of indices.
py::array_t<std::int64_t> array_of(std::span<const std::size_t> indices);

/// A read-only view of shape (slots, 3); it keeps `owner` alive.
py::array view_of(const VectorArray& vectors, const py::object& owner);

void forbid_writing(py::array& array);

}  // namespace perimpact::python
