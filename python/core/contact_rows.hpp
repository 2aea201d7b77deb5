/// Contacts as records of NumPy, and back.
#pragma once

#include <cstddef>
#include <cstdint>

#include "arrays.hpp"
#include "fccda/detect/contact.hpp"

namespace perimpact::python {

/// fccda::Contact as a NumPy record.
struct ContactRow {
  std::int64_t point;
  std::int32_t panel;
  double time_fraction, depth, radius, offset;
  double hit[3], normal[3], relocation[3], normal_t0[3];
};

inline void put(double (&into)[3], const Vec3d& vector) { into[0] = vector.x, into[1] = vector.y, into[2] = vector.z; }
inline Vec3d vector_in(const double (&from)[3]) { return {from[0], from[1], from[2]}; }

ContactRow row_of(const fccda::Contact& contact);

/// `points`: how many there are. `sliding`: the detector, which moves points along the surface; null if it is not at hand, and then points do not
/// slide. Throws InputError if the contact is of no point.
fccda::Contact contact_of(const ContactRow& row, std::size_t points, const fccda::SlidingSurface* sliding);

/// Throws InputError for contacts in another shape than those of detect.
void expect_one_dimension(const py::array& rows);

}  // namespace perimpact::python
