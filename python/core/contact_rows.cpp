#include "contact_rows.hpp"

#include <fmt/format.h>

#include "base/error.hpp"

namespace perimpact::python {

ContactRow row_of(const fccda::Contact& contact) {
  ContactRow row{.point = static_cast<std::int64_t>(contact.point),
                 .panel = contact.panel,
                 .time_fraction = contact.time_fraction,
                 .depth = contact.depth,
                 .radius = contact.radius,
                 .offset = contact.offset,
                 .hit = {},
                 .normal = {},
                 .relocation = {},
                 .normal_t0 = {}};
  put(row.hit, contact.hit), put(row.normal, contact.normal), put(row.relocation, contact.relocation), put(row.normal_t0, contact.normal_t0);
  return row;
}

fccda::Contact contact_of(const ContactRow& row, std::size_t points, const fccda::SlidingSurface* sliding) {
  if (row.point < 0 || static_cast<std::size_t>(row.point) >= points)
    throw fccda::InputError(fmt::format("contacts refers to point {}, but there are {}.", row.point, points));
  return {.point = static_cast<std::size_t>(row.point),
          .panel = row.panel,
          .time_fraction = row.time_fraction,
          .hit = vector_in(row.hit),
          .normal = vector_in(row.normal),
          .relocation = vector_in(row.relocation),
          .depth = row.depth,
          .radius = row.radius,
          .offset = row.offset,
          .normal_t0 = sliding ? vector_in(row.normal_t0) : Vec3d{},  // moves the point along the surface, which must be there
          .sliding = sliding};
}

void expect_one_dimension(const py::array& rows) {
  if (rows.ndim() == 1) return;
  throw fccda::InputError(fmt::format("contacts has the shape {}, but must be one-dimensional, as returned by detect.", shape_in_words(rows)));
}

}  // namespace perimpact::python
