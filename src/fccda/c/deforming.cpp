#include "fccda/c/convert.hpp"
#include "fccda/c/detector_calls.hpp"
#include "fccda/c/guarded.hpp"
#include "fccda/c/handles.hpp"
#include "fccda/deforming/step_warnings.hpp"

using namespace fccda;
using namespace fccda::c_interface;

namespace {

std::vector<Vec3d> positions_of(const fccda_vectors* vertices) {
  const ConstVectors view = const_vectors_of(given(vertices, "vertices"), "vertices");
  std::vector<Vec3d> positions(view.size());
  for (std::size_t v = 0; v < view.size(); ++v) positions[v] = view[v];
  return positions;
}

}  // namespace

fccda_status fccda_deforming_surface_create(const fccda_surface* surface, fccda_deforming_surface** deforming) {
  return guarded([&] {
    fccda_deforming_surface*& out = given(deforming, "deforming");
    out = nullptr;
    out = new fccda_deforming_surface{std::make_shared<DeformingSurface>(given(surface, "surface").shared->surface())};
  });
}

fccda_status fccda_deforming_surface_move(fccda_deforming_surface* surface, const fccda_vectors* vertices) {
  return guarded([&] {
    DeformingSurface& moved = *given(surface, "surface").surface;
    moved.move(positions_of(vertices));
  });
}

fccda_status fccda_deforming_surface_place(fccda_deforming_surface* surface, const fccda_vectors* vertices) {
  return guarded([&] {
    DeformingSurface& placed = *given(surface, "surface").surface;
    placed.place(positions_of(vertices));
  });
}

fccda_status fccda_deforming_surface_warnings(fccda_deforming_surface* surface, const char** text) {
  return guarded([&] {
    fccda_deforming_surface& of = given(surface, "surface");
    const char*& out = given(text, "text");
    of.warnings.clear();
    for (const std::string& sentence : step_warnings(*of.surface)) of.warnings += sentence + '\n';
    out = of.warnings.c_str();
  });
}

void fccda_deforming_surface_destroy(fccda_deforming_surface* surface) { delete surface; }

fccda_status fccda_deforming_detector_create(const fccda_deforming_surface* surface, double radius, fccda_deforming_detector** detector) {
  return guarded([&] {
    fccda_deforming_detector*& out = given(detector, "detector");
    out = nullptr;
    out = new fccda_deforming_detector(given(surface, "surface").surface, radius);
  });
}

fccda_status fccda_deforming_detect(fccda_deforming_detector* detector, const fccda_points* points, size_t* count) {
  return guarded([&] {
    fccda_deforming_detector& with = given(detector, "detector");
    with.contacts.clear();  // none remain of an earlier step if this one fails
    const ConstVectors x_t0 = const_vectors_of(given(points, "points").x_t0, "x_t0"), x_t1 = const_vectors_of(points->x_t1, "x_t1");
    const bool own_radii = points->radius.type != FCCDA_UNSET;
    with.contacts = own_radii ? with.detector.detect(x_t0, x_t1, numbers_of(points->radius, "radius")) : with.detector.detect(x_t0, x_t1);
    write_if_wanted(count, with.contacts.size());
  });
}

fccda_status fccda_deforming_detector_contacts(fccda_deforming_detector* detector, const fccda_deforming_contact** contacts, size_t* count) {
  return return_contacts(detector, contacts, count);
}

fccda_status fccda_deforming_detector_keep(fccda_deforming_detector* detector, const int64_t* which, size_t count) {
  return keep_contacts(detector, which, count);
}

fccda_status fccda_deforming_respond(fccda_deforming_detector* detector, double dt, const fccda_points* points, double friction,
                                     const fccda_numbers* vertex_mass, const fccda_vectors* vertex_impulses, fccda_contact_sum* sum) {
  return guarded([&] {
    const fccda_deforming_detector& with = given(detector, "detector");
    const PointArrays arrays = point_arrays_of(given(points, "points"));
    const Numbers masses = numbers_of(given(vertex_mass, "vertex_mass"), "vertex_mass");
    const Vectors impulses = vectors_of(given(vertex_impulses, "vertex_impulses"), "vertex_impulses");
    write_if_wanted(sum, as_c(respond(with.contacts, dt, arrays, friction, masses, impulses)));
  });
}

fccda_status fccda_deforming_detector_moved(fccda_deforming_detector* detector, int64_t point) { return report_moved(detector, point); }

fccda_status fccda_deforming_detector_points_changed(fccda_deforming_detector* detector) { return report_points_changed(detector); }

fccda_status fccda_deforming_detector_points_inside(fccda_deforming_detector* detector, const fccda_vectors* x, const int64_t** points, size_t* count) {
  return guarded([&] {
    fccda_deforming_detector& with = given(detector, "detector");
    with.points_inside = as_c(with.detector.points_inside(const_vectors_of(given(x, "x"), "x")));
    return_list(with.points_inside, points, count);
  });
}

fccda_status fccda_deforming_detector_balls_inside(fccda_deforming_detector* detector, const fccda_vectors* x, const fccda_numbers* radius,
                                                   const int64_t** points, size_t* count) {
  return guarded([&] {
    fccda_deforming_detector& with = given(detector, "detector");
    const Numbers radii = numbers_of(given(radius, "radius"), "radius");
    with.points_inside = as_c(with.detector.points_inside(const_vectors_of(given(x, "x"), "x"), radii));
    return_list(with.points_inside, points, count);
  });
}

fccda_status fccda_deforming_detector_state(fccda_deforming_detector* detector, const int64_t** numbers, size_t* count) {
  return return_state(detector, numbers, count);
}

fccda_status fccda_deforming_detector_resume(fccda_deforming_detector* detector, const int64_t* numbers, size_t count) {
  return resume_from(detector, numbers, count);
}

void fccda_deforming_detector_destroy(fccda_deforming_detector* detector) { delete detector; }
