/// Python objects in C++ objects that other threads destroy.
#pragma once

#include <pybind11/pybind11.h>

#include <memory>

namespace perimpact::python {

/// An object that may be copied and destroyed without the GIL.
template <class Object>
std::shared_ptr<Object> kept(const Object& object) {
  return {new Object(object), [](Object* last) {
            const pybind11::gil_scoped_acquire acquire;
            delete last;
          }};
}

}  // namespace perimpact::python
