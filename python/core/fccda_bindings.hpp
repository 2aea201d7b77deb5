#pragma once

#include "arrays.hpp"

namespace perimpact::python {

void bind_fccda(py::module_& module);

}  // namespace perimpact::python
