/// What the detectors of rigid and of deforming surfaces have in common.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "fccda/c/convert.hpp"
#include "fccda/c/guarded.hpp"

namespace fccda::c_interface {

/// Returns a list that belongs to a handle.
template <class T>
void return_list(const std::vector<T>& list, const T** first, std::size_t* count) {
  given(first, "the list's address") = list.data();
  given(count, "count") = list.size();
}

/// fccda_…detector_contacts()
template <class Handle, class ContactOfC>
fccda_status return_contacts(Handle* handle, const ContactOfC** contacts, std::size_t* count) {
  return guarded([&] {
    Handle& from = given(handle, "detector");
    from.contacts_of_c.clear();
    from.contacts_of_c.reserve(from.contacts.size());
    for (const auto& contact : from.contacts) from.contacts_of_c.push_back(as_c(contact));
    return_list(from.contacts_of_c, contacts, count);
  });
}

/// fccda_…detector_keep()
template <class Handle>
fccda_status keep_contacts(Handle* handle, const std::int64_t* which, std::size_t count) {
  return guarded([&] {
    Handle& from = given(handle, "detector");
    if (count > 0) given(which, "which");
    keep_only(from.contacts, std::span(which, count));
  });
}

/// fccda_…detector_moved()
template <class Handle>
fccda_status report_moved(Handle* handle, std::int64_t point) {
  return guarded([&] { given(handle, "detector").detector.moved(index_of(point, "point")); });
}

/// fccda_…detector_points_changed()
template <class Handle>
fccda_status report_points_changed(Handle* handle) {
  return guarded([&] { given(handle, "detector").detector.points_changed(); });
}

/// fccda_…detector_state()
template <class Handle>
fccda_status return_state(Handle* handle, const std::int64_t** numbers, std::size_t* count) {
  return guarded([&] {
    Handle& from = given(handle, "detector");
    from.state = as_c(from.detector.state());
    return_list(from.state, numbers, count);
  });
}

/// fccda_…detector_resume()
template <class Handle>
fccda_status resume_from(Handle* handle, const std::int64_t* numbers, std::size_t count) {
  return guarded([&] {
    Handle& to = given(handle, "detector");
    if (count > 0) given(numbers, "numbers");
    to.detector.resume(state_of(std::span(numbers, count)));
  });
}

}  // namespace fccda::c_interface
