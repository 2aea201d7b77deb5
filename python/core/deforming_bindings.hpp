#pragma once

#include "arrays.hpp"

namespace perimpact::python {

/// Surfaces whose vertices move, and their detector. The classes of bind_fccda must be bound before.
void bind_deforming(py::module_& module);

}  // namespace perimpact::python
