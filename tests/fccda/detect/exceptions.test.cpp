// Exceptions within the parallel loops of detection and response: no memory, or a program's points that throw.
#include <doctest/doctest.h>

#include <memory>
#include <new>
#include <vector>

#include "base/parallel.hpp"
#include "fccda/deforming/deforming.hpp"
#include "fccda/detect/analytic.hpp"
#include "fccda/detect/published.hpp"
#include "fccda/detect/scene.hpp"
#include "fccda/respond/respond.hpp"

using namespace fccda;

namespace {

/// 2000 points that fall on the face z = 0.5 of a box; one of them cannot be read once it is `lost`.
struct Falling : fixtures::TestPoints {
  std::size_t lost = static_cast<std::size_t>(-1);

  Falling() {
    for (int k = 0; k < 2000; ++k) x0.push_back({0.002 * k - 2, 0.1, 1}), x1.push_back({0.002 * k - 2, 0.1, 0.4});
    v.assign(x0.size(), {0, 0, -0.6}), m.assign(x0.size(), 1);
  }
  Vec3d position_t0(std::size_t i) const {
    if (i == lost) throw std::bad_alloc();
    return x0[i];
  }
};

}  // namespace

TEST_CASE("detectors: an exception in a parallel loop over points leaves the call, with one thread and with several, and the detector remains usable") {
  const Panels panels = make_box({.size = {10, 10, 1}});
  const Motion still = fixtures::at_rest();
  const int before = thread_count();
  for (const int threads : {1, 3}) {
    use_threads(threads);
    Falling points;
    std::vector<std::size_t> all(points.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
    const auto expect_thrown = [&](const auto& call) {
      points.lost = 777;
      CHECK_THROWS_AS(call(), std::bad_alloc);
      points.lost = static_cast<std::size_t>(-1);
    };
    std::vector<Contact> contacts;

    Swept swept(fixtures::surface_of(panels), Unbounded(), 0.1);
    expect_thrown([&] { swept.detect(points, still, 0, contacts); });
    expect_thrown([&] { swept.redetect(points, still, 0, 0, contacts); });
    expect_thrown([&] { swept.detect_again(points, still, 0, all, contacts); });
    swept.forget();
    contacts.clear();
    swept.detect(points, still, 0, contacts);
    CHECK(contacts.size() == points.size());

    RigidBody body({.mass = 1}, Pose(), {}, {}, {});
    Falling after = points;
    expect_thrown([&] {
      Falling copy = points;
      respond(copy, contacts, still, body, 0);
    });
    CHECK(respond(after, contacts, still, body, 0).contacts == points.size());

    const auto surface = std::make_shared<DeformingSurface>(Surface(panels));
    Deforming deforming(surface, 0.1);
    std::vector<DeformingContact> found;
    surface->move(panels.vertices);
    expect_thrown([&] { deforming.detect(points, found); });
    expect_thrown([&] { deforming.redetect(points, 0, found); });
    expect_thrown([&] { deforming.detect_again(points, all, found); });
    deforming.forget();
    found.clear();
    surface->move(panels.vertices);
    deforming.detect(points, found);
    CHECK(found.size() == points.size());

    Analytic analytic(Sphere{.radius = 0.5}, Unbounded(), 0.1);
    expect_thrown([&] { analytic.detect(points, still, 0, contacts); });
    expect_thrown([&] { analytic.detect_again(points, still, 0, all, contacts); });
  }
  use_threads(before);
}
