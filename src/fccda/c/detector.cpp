#include <numbers>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "fccda/c/convert.hpp"
#include "fccda/c/detector_calls.hpp"
#include "fccda/c/guarded.hpp"
#include "fccda/c/handles.hpp"
#include "fccda/contact_bounds/fit_contact_bounds.hpp"

using namespace fccda;
using namespace fccda::c_interface;

namespace {

/// Without a body that receives it, moments are about the centre of the motion.
ContactSum respond_alone(const std::vector<Contact>& contacts, const Motion& motion, const PointArrays& points, double friction) {
  const RigidBody stand_in({.mass = 1, .centre_of_mass = motion.centre}, motion.t1, {}, {}, {});
  return respond_without_body(contacts, motion, stand_in, points, friction);
}

/// Writes the handle of a detector within the contact bounds that `bounds(surface)` returns with their sentence.
template <class MakeBounds>
fccda_status create_within(const MakeBounds& bounds, const fccda_surface* surface, double radius, fccda_detector** detector) {
  return guarded([&] {
    fccda_detector*& out = given(detector, "detector");
    out = nullptr;
    const SharedSurface& shared = given(surface, "surface").shared;
    FittedBounds within = bounds(shared->surface());
    out = new fccda_detector(std::move(within.choice), shared, ContactDetector::Options{.radius = radius, .contact_bounds = std::move(within.region)});
  });
}

Beyond beyond_of(int32_t beyond) {
  if (beyond != FCCDA_REFUSE_BEYOND && beyond != FCCDA_IGNORE_BEYOND)
    throw InputError("contact bounds: the treatment of panels beyond them is " + std::to_string(beyond) +
                     ", but it must be FCCDA_REFUSE_BEYOND or FCCDA_IGNORE_BEYOND.");
  return beyond == FCCDA_IGNORE_BEYOND ? Beyond::clip : Beyond::error;
}

/// Contact bounds as given, with their sentence. `name`: "boxes".
template <class Bounds>
FittedBounds as_given(Bounds bounds, const std::string& name) {
  std::ostringstream sentence;
  sentence << name << " as given, of " << bounds.volume() << " m³" << (bounds.clips() ? "; contact beyond them is ignored" : "");
  return {std::move(bounds), sentence.str()};
}

}  // namespace

fccda_status fccda_detector_create(const fccda_surface* surface, double radius, fccda_detector** detector) {
  return create_within([](const Surface&) { return FittedBounds{Unbounded(), "none"}; }, surface, radius, detector);
}

fccda_status fccda_detector_create_in_boxes(const fccda_surface* surface, double radius, const fccda_box* boxes, size_t box_count, int32_t beyond,
                                            fccda_detector** detector) {
  const auto bounds = [&](const Surface& within) {
    std::vector<BoxUnion::Shape> shapes;
    for (std::size_t b = 0; b < box_count; ++b) {
      const fccda_box& box = (&given(boxes, "boxes"))[b];
      shapes.push_back({.size = vector_of(box.size), .centre = vector_of(box.centre)});
    }
    return as_given(BoxUnion(shapes, within, beyond_of(beyond)), box_count == 1 ? "one box" : std::to_string(box_count) + " boxes");
  };
  return create_within(bounds, surface, radius, detector);
}

fccda_status fccda_detector_create_in_sectors(const fccda_surface* surface, double radius, const fccda_sectors* sectors, int32_t beyond,
                                              fccda_detector** detector) {
  const auto bounds = [&](const Surface& within) {
    const fccda_sectors& from = given(sectors, "sectors");
    expect_reserved(from.reserved, "sectors");
    const CylinderSectors::Shape shape{.axis = vector_of(from.axis),
                                       .point = vector_of(from.point),
                                       .radius = from.radius,
                                       .length = from.length,
                                       .hub_radius = from.hub_radius,
                                       .blades = from.blades,
                                       .sector_angle = from.sector_angle == 0 ? 2 * std::numbers::pi : from.sector_angle,
                                       .start_angle = from.start_angle};
    return as_given(CylinderSectors(shape, within, beyond_of(beyond)), "a cylinder with sectors");
  };
  return create_within(bounds, surface, radius, detector);
}

fccda_status fccda_detector_create_in_fitted_bounds(const fccda_surface* surface, double radius, fccda_detector** detector) {
  return create_within(fit_contact_bounds, surface, radius, detector);
}

const char* fccda_detector_bounds(const fccda_detector* detector) { return detector == nullptr ? nullptr : detector->bounds.c_str(); }

fccda_status fccda_detect(fccda_detector* detector, const fccda_motion* motion, const fccda_points* points, size_t* count) {
  return guarded([&] {
    fccda_detector& with = given(detector, "detector");
    with.contacts.clear();  // none remain of an earlier step if this one fails
    const Motion of_body = motion_of(given(motion, "motion"));
    const ConstVectors x_t0 = const_vectors_of(given(points, "points").x_t0, "x_t0"), x_t1 = const_vectors_of(points->x_t1, "x_t1");
    with.contacts = points->radius.type == FCCDA_UNSET ? with.detector.detect(of_body, x_t0, x_t1)
                                                       : with.detector.detect(of_body, x_t0, x_t1, numbers_of(points->radius, "radius"));
    write_if_wanted(count, with.contacts.size());
  });
}

fccda_status fccda_detector_contacts(fccda_detector* detector, const fccda_contact** contacts, size_t* count) {
  return return_contacts(detector, contacts, count);
}

fccda_status fccda_detector_keep(fccda_detector* detector, const int64_t* which, size_t count) { return keep_contacts(detector, which, count); }

fccda_status fccda_respond(fccda_detector* detector, const fccda_motion* motion, const fccda_points* points, double friction, fccda_body* body,
                           fccda_contact_sum* sum) {
  return guarded([&] {
    const fccda_detector& with = given(detector, "detector");
    const Motion of_body = motion_of(given(motion, "motion"));
    const PointArrays arrays = point_arrays_of(given(points, "points"));
    const ContactSum received =
        body != nullptr ? respond(with.contacts, of_body, body->body, arrays, friction) : respond_alone(with.contacts, of_body, arrays, friction);
    write_if_wanted(sum, as_c(received));
  });
}

fccda_status fccda_detector_moved(fccda_detector* detector, int64_t point) { return report_moved(detector, point); }

fccda_status fccda_detector_points_changed(fccda_detector* detector) { return report_points_changed(detector); }

fccda_status fccda_detector_points_inside(fccda_detector* detector, const fccda_pose* pose, const fccda_vectors* x, const fccda_numbers* radius,
                                          const int64_t** points, size_t* count) {
  return guarded([&] {
    fccda_detector& with = given(detector, "detector");
    const Pose of_body = pose_of(given(pose, "pose"));
    const ConstVectors positions = const_vectors_of(given(x, "x"), "x");
    const bool has_own_radii = radius != nullptr && radius->type != FCCDA_UNSET;
    const std::vector<std::size_t> inside =
        has_own_radii ? with.detector.points_inside(of_body, positions, numbers_of(*radius, "radius")) : with.detector.points_inside(of_body, positions);
    with.points_inside = as_c(inside);
    return_list(with.points_inside, points, count);
  });
}

fccda_status fccda_detector_state(fccda_detector* detector, const int64_t** numbers, size_t* count) { return return_state(detector, numbers, count); }

fccda_status fccda_detector_resume(fccda_detector* detector, const int64_t* numbers, size_t count) { return resume_from(detector, numbers, count); }

void fccda_detector_destroy(fccda_detector* detector) { delete detector; }
