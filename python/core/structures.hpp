/// Structures of Python: objects that move the surface of an impactor, such as a finite-element model.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "arrays.hpp"
#include "perimpact/impactor/impactor.hpp"
#include "user_calls.hpp"

namespace perimpact::python {

/// An object that moves the surface of the impactor of this name (docs/guide/python.md, "Structures").
struct StructureOfPython {
  std::string impactor;
  std::shared_ptr<py::object> object;  // kept()
};

/// The entries of {"impactor": object}; none for None.
std::vector<StructureOfPython> structures_of(const py::object& structures);

/// Gives the impactors these structures, to be called by `calls`. Needs the GIL. Throws InputError where an object lacks a member, or an impactor does not
/// exist.
void attach(const std::vector<StructureOfPython>& structures, std::span<Impactor> impactors, UserCalls& calls);

}  // namespace perimpact::python
