#include "perimpact/impactor/contact_ledger.hpp"

#include <doctest/doctest.h>

#include "fccda/respond/nested_areas.hpp"
#include "fixtures/tolerance.hpp"
#include "mesh/shapes/box.hpp"

using namespace perimpact;
using fccda::Vec3d;

namespace {

/// A cube of 1 m in panels of 0.1 m; panel 0 lies on some face.
fccda::Surface cube() { return fccda::Surface(fccda::make_box({.size = {1, 1, 1}, .edge_length = 0.1, .panels = fccda::PanelKind::quads})); }

/// A contact of that particle on a panel, and the impulse that pushes it in.
void push(ContactRecord& record, std::size_t body, std::size_t particle, int panel, double impulse) {
  const Vec3d normal = record.panels().faces()[static_cast<std::size_t>(panel)].normal;
  record.add(body, {.point = particle, .panel = panel, .normal = normal}, -impulse * normal);
  record.count_in_contact(body, 1);
}

}  // namespace

TEST_CASE("contact record: a known patch of two bodies gives its area, force and mean pressure, each particle counted once") {
  ContactRecord record(cube(), std::vector<double>{0.01, 0.0025});
  for (int step = 0; step < 4; ++step) {
    record.begin_step();
    push(record, 0, 17, 0, 0.5);                  // in every step
    if (step < 2) push(record, 0, 18, 1, 1);      // in half of them
    if (step == 3) push(record, 1, 17, 1, 0.25);  // another particle with the same number
  }
  record.end_interval(0.2, 0.2);
  const ContactRecord::Interval& interval = record.interval();
  CHECK(interval.time == 0.2);
  CHECK(interval.contact_area == fixtures::relative(2 * 0.01 + 0.0025, 1e-14));             // sums of three
  CHECK(interval.mean_contact_area == fixtures::relative((6 * 0.01 + 0.0025) / 4, 1e-14));  // seven contacts in four steps
  CHECK(interval.normal_force == fixtures::relative((4 * 0.5 + 2 * 1 + 0.25) / 0.2, 1e-14));
  CHECK(interval.mean_pressure() == fixtures::relative(21.25 / 0.0225, 1e-14));
  record.begin_step();
  record.end_interval(0.3, 0.1);
  CHECK((record.interval().contact_area == 0 && record.interval().normal_force == 0 && record.interval().mean_pressure() == 0));
}

TEST_CASE("contact record: the peak keeps time and pressures of the load interval of the largest force, not of the largest impulse") {
  ContactRecord record(cube(), std::vector<double>{0.01});
  CHECK(record.peak().panel_pressure.empty());
  const auto interval = [&](double end, double duration, int panel, double impulse) {
    record.begin_step();
    push(record, 0, 3, panel, impulse);
    record.end_interval(end - duration / 2, duration / 2);  // rows of the history change nothing
    record.end_load_interval(end, duration);
  };
  interval(1, 1, 5, 2);
  interval(1.1, 0.1, 6, 1);  // 10 N
  interval(2.1, 1, 7, 4);
  CHECK(record.peak().time == 1.1);
  CHECK(record.peak().normal_force == fixtures::relative(10, 1e-14));
  CHECK(record.peak().panel_pressure[6] == fixtures::relative(10 / 0.01, 1e-12));  // a panel's area is a sum of products
  CHECK(record.peak().panel_pressure[7] == 0);
}

TEST_CASE("contact record: it records which bodies were ever in contact") {
  ContactRecord record(cube(), std::vector<double>{0.1, 0.1, 0.1});
  CHECK_FALSE(record.was_in_contact());
  push(record, 1, 0, 0, 1);
  record.end_interval(1, 1);
  record.end_interval(2, 1);
  CHECK(record.was_in_contact());
  CHECK((!record.was_in_contact(0) && record.was_in_contact(1) && !record.was_in_contact(2)));
}
