// Contact bounds of the C interface against those of C++.
#include <doctest/doctest.h>

#include <string>

#include "fccda/api/contact_detector.hpp"
#include "fccda/api/deforming_contact_detector.hpp"
#include "fccda/c/scenes.hpp"
#include "fccda/contact_bounds/fit_contact_bounds.hpp"
#include "fixtures/propeller.hpp"

using namespace c_scenes;

namespace {

const Panels blades = fixtures::propeller({.edge_length = 0.06});
constexpr double radius = 0.01;

/// Contacts of a cloud with the blades, which turn, by a handle of C and by a detector of C++.
std::size_t expect_same_contacts(fccda_detector* handle, ContactDetector detector) {
  Cloud<double> cloud(layouts()[0], {-0.6, -0.6, -0.1}, {0.6, 0.6, 0.2});
  const fccda_points points = cloud.c_points(false);
  std::size_t all = 0;
  for (int step = 0; step < 10; ++step) {
    cloud.move(5e-3);
    const Pose before({}, Quaternion::from_rotation({0, 0, 0.05 * step})), after({}, Quaternion::from_rotation({0, 0, 0.05 * (step + 1)}));
    const Motion motion{before, after, 5e-3};
    const Quaternion &p = before.attitude(), &q = after.attitude();
    const fccda_motion c_motion{{{0, 0, 0}, {p.w, p.x, p.y, p.z}}, {{0, 0, 0}, {q.w, q.x, q.y, q.z}}, {0, 0, 0}, 5e-3};
    const std::vector<Contact> expected = detector.detect(motion, cloud.vectors(cloud.layout.x_t0), cloud.vectors(cloud.layout.x_t1));
    std::size_t number = 0;
    const fccda_contact* first = nullptr;
    REQUIRE(fccda_detect(handle, &c_motion, &points, &number) == FCCDA_OK);
    REQUIRE(number == expected.size());
    CHECK(fccda_detector_contacts(handle, &first, &number) == FCCDA_OK);
    for (std::size_t k = 0; k < number; ++k) CHECK(c_scenes::same(expected[k], first[k]));
    CHECK(fccda_respond(handle, &c_motion, &points, 0, nullptr, nullptr) == FCCDA_OK);
    all += number;
  }
  fccda_detector_destroy(handle);
  return all;
}

}  // namespace

TEST_CASE("C interface: a detector within boxes, sectors or fitted contact bounds has the contacts of C++ within the same") {
  fccda_surface* surface = surface_of(blades);
  const auto shared = share(Surface(blades));
  fccda_detector* detector = nullptr;

  REQUIRE(fccda_detector_create(surface, radius, &detector) == FCCDA_OK);
  CHECK(std::string(fccda_detector_bounds(detector)) == "none");
  const std::size_t without = expect_same_contacts(detector, ContactDetector(shared, {.radius = radius}));
  REQUIRE(without > 20);

  // The halves of two blades; contact beyond is ignored.
  const fccda_box boxes[] = {{{0.4, 0.4, 0.4}, {0.35, 0, 0}}, {{0.4, 0.4, 0.4}, {0, 0.35, 0}}};
  const BoxUnion::Shape shapes[] = {{{0.4, 0.4, 0.4}, {0.35, 0, 0}}, {{0.4, 0.4, 0.4}, {0, 0.35, 0}}};
  REQUIRE(fccda_detector_create_in_boxes(surface, radius, boxes, 2, FCCDA_IGNORE_BEYOND, &detector) == FCCDA_OK);
  CHECK(std::string(fccda_detector_bounds(detector)).starts_with("2 boxes as given, of 0.127"));
  CHECK(std::string(fccda_detector_bounds(detector)).ends_with("contact beyond them is ignored"));
  const std::size_t in_boxes =
      expect_same_contacts(detector, ContactDetector(shared, {.radius = radius, .contact_bounds = BoxUnion(shapes, shared->surface(), Beyond::clip)}));
  CHECK(in_boxes > 0);
  CHECK(in_boxes < without);

  const fccda_sectors sectors{{0, 0, 2}, {0, 0, 0}, 0.51, 0.6, 0.13, 0.8, -0.4, 4, 0};
  const CylinderSectors::Shape fan{.radius = 0.51, .length = 0.6, .hub_radius = 0.13, .blades = 4, .sector_angle = 0.8, .start_angle = -0.4};
  REQUIRE(fccda_detector_create_in_sectors(surface, radius, &sectors, FCCDA_IGNORE_BEYOND, &detector) == FCCDA_OK);
  CHECK(std::string(fccda_detector_bounds(detector)).starts_with("a cylinder with sectors as given, of 0."));
  const std::size_t in_sectors =
      expect_same_contacts(detector, ContactDetector(shared, {.radius = radius, .contact_bounds = CylinderSectors(fan, shared->surface(), Beyond::clip)}));
  CHECK(in_sectors > 0);
  CHECK(in_sectors < without);

  fccda_sectors cylinder = sectors;
  cylinder.sector_angle = 0;
  REQUIRE(fccda_detector_create_in_sectors(surface, radius, &cylinder, FCCDA_REFUSE_BEYOND, &detector) == FCCDA_OK);
  CHECK(expect_same_contacts(detector, ContactDetector(shared, {.radius = radius})) == without);

  const FittedBounds fitted = fit_contact_bounds(shared->surface());
  REQUIRE(fccda_detector_create_in_fitted_bounds(surface, radius, &detector) == FCCDA_OK);
  CHECK(std::string(fccda_detector_bounds(detector)) == fitted.choice);
  CHECK(expect_same_contacts(detector, ContactDetector(shared, {.radius = radius, .contact_bounds = fitted.region})) == without);
  CHECK(fccda_detector_bounds(nullptr) == nullptr);
  fccda_surface_destroy(surface);
}

TEST_CASE("C interface: balls inside a deforming surface are those of C++, with a radius for each") {
  const Panels ring = fixtures::torus(1, 0.4, 16, 8, 1);
  fccda_surface* surface = surface_of(ring);
  fccda_deforming_surface* soft = nullptr;
  fccda_deforming_detector* detector = nullptr;
  REQUIRE(fccda_deforming_surface_create(surface, &soft) == FCCDA_OK);
  REQUIRE(fccda_deforming_detector_create(soft, 0.02, &detector) == FCCDA_OK);
  Cloud<double> cloud(layouts()[2], {-1.6, -1.6, -0.5}, {1.6, 1.6, 0.5});
  const fccda_vectors x = cloud.c_vectors(cloud.layout.x_t1);
  const fccda_numbers radii = cloud.c_numbers(cloud.layout.radius);
  const DeformingContactDetector expected(std::make_shared<DeformingSurface>(Surface(ring)), 0.02);
  const std::int64_t* first = nullptr;
  std::size_t number = 0;
  REQUIRE(fccda_deforming_detector_balls_inside(detector, &x, &radii, &first, &number) == FCCDA_OK);
  const std::vector<std::size_t> found(first, first + number);
  CHECK(found == expected.points_inside(cloud.vectors(cloud.layout.x_t1), cloud.of_each(cloud.layout.radius)));
  CHECK(found != expected.points_inside(cloud.vectors(cloud.layout.x_t1)));
  fccda_surface_destroy(surface), fccda_deforming_surface_destroy(soft), fccda_deforming_detector_destroy(detector);
}
