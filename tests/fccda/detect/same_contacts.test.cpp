// Contact bounds that contain the surface change the cost of a step, never its result.
#include <doctest/doctest.h>

#include <cstring>

#include "fccda/contact_bounds/scenes.hpp"
#include "fccda/detect/scene.hpp"

using namespace fccda;

namespace {

bool same_bits(const Contact& a, const Contact& b) {
  const auto bits = [](const Vec3d& one, const Vec3d& other) { return std::memcmp(&one, &other, sizeof one) == 0; };
  return a.point == b.point && a.panel == b.panel && a.time_fraction == b.time_fraction && a.depth == b.depth && bits(a.hit, b.hit) &&
         bits(a.normal, b.normal) && bits(a.relocation, b.relocation) && bits(a.normal_t0, b.normal_t0);
}

/// All contacts of a propeller that rotates and advances through a cloud of points at rest.
std::vector<Contact> contacts_of(const std::shared_ptr<const Surface>& surface, const ContactBounds& region, double radius) {
  Swept detector(surface, region, radius);
  const Vec3d axis = normalised(Vec3d{0.3, -0.2, 1});
  const double turn = 0.04, advance = 0.004;
  const auto pose = [&](int step) { return Pose((step * advance - 0.6) * axis, Quaternion::from_rotation(step * turn * axis)); };
  fixtures::TestPoints points;
  std::mt19937_64 random(12);
  for (int k = 0; k < 1500; ++k) points.x1.push_back(fixtures::random_in_box(random, {-0.6, -0.6, -0.25}, {0.6, 0.6, 0.25}));
  std::vector<Contact> all;
  for (int step = 0; step < 150; ++step) {
    points.x0 = points.x1;
    const Motion motion{pose(step), pose(step + 1), 1};
    // chord and bulge of the turn about the origin of a surface within 0.6 of it
    const std::vector<Contact> found = fixtures::detect(detector, points, motion, advance + 0.6 * turn * (1 + turn));
    for (const Contact& contact : found) points.x1[contact.point] = contact.relocation;
    all.insert(all.end(), found.begin(), found.end());
  }
  return all;
}

}  // namespace

TEST_CASE("same contacts: a rotating propeller has bitwise identical contacts with all contact bounds that contain it") {
  const auto surface = fixtures::surface_of(fixtures::propeller({.skew = 0.3, .edge_length = 0.06}));
  for (const double radius : {0.0, 0.01}) {
    CAPTURE(radius);
    const std::vector<Contact> expected = contacts_of(surface, Unbounded{}, radius);
    CHECK(expected.size() > 1000);
    for (const fixtures::NamedRegion& region : fixtures::every_region(*surface)) {
      if (std::visit([](const auto& its) { return its.clips(); }, region.region)) continue;
      CAPTURE(region.name);
      const std::vector<Contact> found = contacts_of(surface, region.region, radius);
      REQUIRE(found.size() == expected.size());
      std::size_t same = 0;
      for (std::size_t k = 0; k < found.size(); ++k) same += same_bits(found[k], expected[k]) ? 1 : 0;
      CHECK(same == expected.size());
    }
  }
}
