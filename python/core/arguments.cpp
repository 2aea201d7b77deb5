#include "arguments.hpp"

#include <fmt/format.h>

#include "base/error.hpp"

namespace perimpact::python {

std::string type_in_words(const py::handle& value) { return fmt::format("of type {}", std::string(py::str(py::type::handle_of(value).attr("__name__")))); }

py::dict dict_in(const py::handle& value, const std::string& what, const std::string& form) {
  if (py::isinstance<py::dict>(value)) return py::reinterpret_borrow<py::dict>(value);
  if (py::hasattr(value, "keys")) return py::dict(py::reinterpret_borrow<py::object>(value));
  throw fccda::InputError(fmt::format("{} is {}, but it must be a dict {}.", what, type_in_words(value), form));
}

std::string name_in(const py::handle& key, const std::string& what, const std::string& names) {
  if (!py::isinstance<py::str>(key))
    throw fccda::InputError(fmt::format("{}: {} is a key, but keys are names of {}.", what, std::string(py::repr(key)), names));
  return py::cast<std::string>(key);
}

}  // namespace perimpact::python
