#include "fccda/detect/swept.hpp"

#include <doctest/doctest.h>

#include "scene.hpp"

using namespace fccda;
using fixtures::detect;

namespace {

std::vector<bool> struck(const std::vector<Contact>& contacts, std::size_t points) {
  std::vector<bool> is(points, false);
  for (const Contact& contact : contacts) is[contact.point] = true;
  return is;
}

}  // namespace

TEST_CASE("swept: every true crossing is found and none invented, on every body, in 24 orientations, for points and for balls") {
  std::size_t true_contacts = 0;
  for (const fixtures::Body& body : fixtures::bodies()) {
    CAPTURE(body.name);
    const auto surface = fixtures::surface_of(body.panels);
    const fixtures::Soup soup(*surface);
    for (const double r : {0.0, 0.02}) {
      CAPTURE(r);
      const fixtures::Shots shots(soup, r, 0.05, 400, 1);
      for (const Pose& pose : fixtures::orientations()) {
        Swept detector(surface, Unbounded{}, r);
        const std::vector<Contact> contacts = detect(detector, fixtures::points_on(shots.paths, {pose, pose, 1}), {pose, pose, 1});
        const std::vector<bool> found = struck(contacts, shots.paths.size());
        CHECK(found == shots.touches);  // exact: no tolerance
        true_contacts += contacts.size();
      }
    }
  }
  CHECK(true_contacts > 24 * 6 * 2 * 100);  // the scenes are not empty
}

TEST_CASE("swept: relocated points are outside, at the contact radius from the surface, and reached without crossing it") {
  for (const fixtures::Body& body : fixtures::bodies()) {
    CAPTURE(body.name);
    const auto surface = fixtures::surface_of(body.panels);
    const fixtures::Soup soup(*surface);
    for (const double r : {0.0, 0.02}) {
      CAPTURE(r);
      const fixtures::Shots shots(soup, r, 0.05, 400, 2);
      Swept detector(surface, Unbounded{}, r);
      for (const Contact& contact : detect(detector, fixtures::points_on(shots.paths))) {
        const double distance = soup.distance(contact.relocation);
        CHECK(distance > r - 2e-12);  // the offset of 1e-12 of the size
        CHECK_FALSE(soup.inside(contact.relocation + 1e-6 * contact.normal));
        CHECK(std::fabs(norm(contact.normal) - 1) < 1e-12);
        const Path way{shots.paths[contact.point].start, contact.relocation};
        CHECK((r == 0 || soup.distance(way) > 1e-9));  // for r = 0 it ends at the surface
        CHECK(contact.depth <= 2 * 0.05 + 2 * r);      // no further than the path is long, there and back
      }
    }
  }
}
