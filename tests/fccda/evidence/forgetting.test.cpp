// Cached distances are not state: results are bitwise identical if they are lost at any time, on any number of threads.
#include <doctest/doctest.h>

#include <bit>

#include "fccda/evidence/swarm.hpp"
#include "fixtures/threads.hpp"

using namespace evidence;

namespace {

struct Run {
  std::uint64_t bits = 14695981039346656037u;  ///< of all contacts, points and the body in every step (FNV-1a)
  std::size_t contacts = 0, tested = 0;

  void take(double number) { bits = (bits ^ std::bit_cast<std::uint64_t>(number)) * 1099511628211u; }
  void take(const Vec3d& vector) { take(vector.x), take(vector.y), take(vector.z); }
};

/// `forgets`: how often in a hundred steps all is forgotten, at random.
Run run(const std::shared_ptr<const Surface>& surface, double radius, double friction, unsigned forgets, int threads) {
  const fixtures::Threads with_several(threads);
  Swarm swarm(surface, {.count = 500, .radius = radius, .friction = friction});
  std::mt19937_64 random(81);
  Run result;
  for (int step = 0; step < 600; ++step) {
    if (random() % 100 < forgets) swarm.detector.forget();
    if (random() % 100 < forgets) swarm.detector.moved(random() % swarm.points.size());
    swarm.step([&](const Contact& contact, const Vec3d& impulse) {
      ++result.contacts;
      result.take(static_cast<double>(contact.point)), result.take(static_cast<double>(contact.panel)), result.take(contact.time_fraction);
      result.take(contact.hit), result.take(contact.normal), result.take(contact.relocation), result.take(impulse);
    });
    for (std::size_t i = 0; i < swarm.points.size(); ++i) result.take(swarm.points.x1[i]), result.take(swarm.points.v[i]);
    result.take(swarm.body.position_of_com()), result.take(swarm.body.velocity()), result.take(swarm.body.angular_velocity());
  }
  result.tested = swarm.detector.effort().points_tested;
  return result;
}

}  // namespace

TEST_CASE("evidence: 600 steps of contact and response are bitwise identical when distances are forgotten at random steps, and for any number of threads") {
  const auto surface = fixtures::surface_of(fixtures::hull());
  for (const double radius : {0.0, 0.01}) {
    for (const double friction : {0.0, 0.3}) {
      const Run remembering = run(surface, radius, friction, 0, 1);
      CHECK(remembering.contacts > 10'000);
      for (const unsigned forgets : {20u, 100u}) {
        const Run forgetful = run(surface, radius, friction, forgets, forgets == 20 ? 2 : 4);
        CHECK(forgetful.bits == remembering.bits);
        CHECK(forgetful.contacts == remembering.contacts);
        CHECK(forgetful.tested > remembering.tested);
      }
    }
  }
}
