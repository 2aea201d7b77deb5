/// The border between C and C++: exceptions become a status and a sentence, and pointers are checked.
#pragma once

#include <string>

#include "base/error.hpp"
#include "fccda/fccda.h"

namespace fccda::c_interface {

/// Turns the exception in flight into a status, and keeps its sentence for fccda_last_error() of this thread.
fccda_status status_of_exception() noexcept;

/// Runs the body of a function of the C interface.
template <class Body>
fccda_status guarded(const Body& body) noexcept {
  try {
    body();
    return FCCDA_OK;
  } catch (...) {
    return status_of_exception();
  }
}

/// What an argument points to. Throws InputError if it is NULL. `name`: of the argument in fccda.h.
template <class T>
T& given(T* pointer, const char* name) {
  if (pointer == nullptr) throw InputError(std::string("fccda: the argument `") + name + "` is NULL, but it is needed; pass its address.");
  return *pointer;
}

/// Throws InputError if a member `reserved` is not 0: a later version of the interface may give it a meaning. `of`: argument or structure.
inline void expect_reserved(std::int32_t reserved, const char* of) {
  if (reserved != 0)
    throw InputError(std::string("fccda: the member `reserved` of `") + of + "` is " + std::to_string(reserved) +
                     ", but it must be 0; set the structure to zero before its members.");
}

/// Writes to where a result is wanted.
template <class T>
void write_if_wanted(T* place, const T& value) {
  if (place != nullptr) *place = value;
}

}  // namespace fccda::c_interface
