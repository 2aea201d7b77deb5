#pragma once

#include "arrays.hpp"

namespace perimpact::python {

void bind_simulation(py::module_& module);

}  // namespace perimpact::python
