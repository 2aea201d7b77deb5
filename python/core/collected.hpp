/// Classes whose objects refer to objects of Python, so that the garbage collector finds cycles through them.
#pragma once

#include <pybind11/pybind11.h>

namespace perimpact::python {

/// The C++ object, or null while it is not yet constructed.
template <class Type>
Type* constructed(PyObject* self) {
  auto* const instance = reinterpret_cast<pybind11::detail::instance*>(self);
  if (!instance->simple_layout && !instance->nonsimple.status) return nullptr;  // just allocated
  pybind11::detail::value_and_holder held = instance->get_value_and_holder();
  return held.holder_constructed() ? static_cast<Type*>(held.value_ptr()) : nullptr;
}

/// `Type` has `int traverse(visitproc, void*) const`, which visits what the object refers to, and `void release()`, which drops these references.
template <class Type>
pybind11::custom_type_setup collected() {
  return pybind11::custom_type_setup([](PyHeapTypeObject* heap_type) {
    PyTypeObject& type = heap_type->ht_type;
    type.tp_flags |= Py_TPFLAGS_HAVE_GC;
    type.tp_traverse = [](PyObject* self, visitproc visit, void* arg) {
      Py_VISIT(Py_TYPE(self));
      const Type* const object = constructed<Type>(self);
      return object ? object->traverse(visit, arg) : 0;
    };
    type.tp_clear = [](PyObject* self) {
      if (Type* const object = constructed<Type>(self)) object->release();
      return 0;
    };
    type.tp_dealloc = [](PyObject* self) {
      PyObject_GC_UnTrack(self);  // the collector must not meet it half destroyed
      pybind11::detail::pybind11_object_dealloc(self);
    };
  });
}

}  // namespace perimpact::python
