/// Arguments that are dicts of names, with sentences about others.
#pragma once

#include <pybind11/pybind11.h>

#include <string>

namespace perimpact::python {

namespace py = pybind11;

/// "of type int"
std::string type_in_words(const py::handle& value);

/// A dict or another mapping. `what`: the argument; `form`: an example. Throws InputError.
py::dict dict_in(const py::handle& value, const std::string& what, const std::string& form);

/// A key of such a dict. `names`: what its keys name, in the plural. Throws InputError where it is not a string.
std::string name_in(const py::handle& key, const std::string& what, const std::string& names);

}  // namespace perimpact::python
