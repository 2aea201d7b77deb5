// Comparison with brute force over all panels and all points, in random scenes: random shapes, sizes, positions, rotations and speeds,
// several bodies, fast debris, over many steps with the detectors' caches.
#include <doctest/doctest.h>

#include "fccda/evidence/shapes.hpp"
#include "fccda/evidence/truth.hpp"

using namespace evidence;

namespace {

/// Coarse ones, of 80 to 320 triangles.
Panels any_shape(std::mt19937_64& random) {
  const Panels ball = make_sphere({.diameter = 1, .edge_length = 0.3});
  switch (random() % 7) {
    case 0:
      return make_cylinder({.diameter = 1, .height = 0.5, .axis = static_cast<Axis>(random() % 3), .edge_length = 0.25, .panels = PanelKind::quads});
    case 1:
      return ball;
    case 2:
      return fixtures::torus(0.4, 0.15, 16, 8);
    case 3:
      return fixtures::torus(0.4, 0.15, 20, 8, 1);
    case 4:
      return make_box({.size = {1, 0.6, 0.4}, .edge_length = 0.25});
    case 5:
      return fixtures::moved(ball, [](const Vec3d& p) { return Vec3d{p.x, 0.4 * p.y, 0.03 * p.z}; });
    default:
      return fixtures::moved(ball, [](const Vec3d& p) {
        const double bump = 1 + 0.15 * std::sin(9 * p.x) * std::cos(7 * p.y + 1) * std::cos(8 * p.z);
        return Vec3d{bump * p.x, 0.5 * bump * p.y, 0.4 * bump * p.z};
      });
  }
}

/// A body frame of the reference solution: three axes rotated by Rodrigues' formula.
struct Frame {
  Vec3d place;
  Vec3d axis[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  Vec3d seen(const Vec3d& point) const { return {dot(axis[0], point - place), dot(axis[1], point - place), dot(axis[2], point - place)}; }
  Vec3d there(const Vec3d& point) const { return place + point.x * axis[0] + point.y * axis[1] + point.z * axis[2]; }
};

enum class Answer { contact, none, undecided };

struct ContactResolver {
  ContactResolver(const Panels& panels, double radius)
      : surface(fixtures::surface_of(panels)), truth(*surface), detector(surface, Unbounded{}, radius), r(radius) {
    const Vec3d extent = surface->report().bounds.size();
    offset = 1e-12 * std::max({extent.x, extent.y, extent.z});
    reach = surface->radius_about({});
  }

  /// Translates by `shift` and rotates by `rotation` in a step.
  void advance(const Vec3d& shift, const Vec3d& rotation) {
    before = now;
    angle = norm(rotation);
    now.place += shift;
    for (Vec3d& axis : now.axis) axis = turned(axis, rotation);
    motion.t0 = motion.t1;
    motion.t1 = Pose(motion.t0.position() + shift, (Quaternion::from_rotation(rotation) * motion.t0.attitude()).normalised());
    motion.dt = 1;
  }

  double signed_distance(const Vec3d& seen) const { return truth.inside(seen) ? -truth.distance(seen) : truth.distance(seen); }

  /// Bound of the deviation of a point's curved path from its chord: (ρ θ² + 2 θ w)/8 for its distance ρ from the centre and its path
  /// length w, which is at most its chord plus the contribution of the rotation.
  double bulge_of(const Path& chord) const {
    const double furthest = std::max(norm(chord.start), norm(chord.end));
    return angle * (angle * furthest + 2 * (chord.length() + angle * furthest)) / 8;
  }

  /// Whether the path of a point is contact. Undecided within 1e-9 of it, but not where points rest, at r + offset: half the offset is far
  /// above the rounding of a few coordinates of order one. Relative to a rotating body the path is curved; then, between the ends, paths
  /// within the bulge are undecided.
  Answer judge(const Vec3d& x_t0, const Vec3d& x_t1) const {
    constexpr double blur = 1e-9;
    const Path path{before.seen(x_t0), now.seen(x_t1)};
    const double bent = bulge_of(path);
    if (norm(path.start) > reach + r + path.length() + bent + blur) return Answer::none;
    const double resting = r > 0 ? r - 0.5 * offset : 0;
    const double start = signed_distance(path.start);
    if (start > r + path.length() + bent + blur) return Answer::none;
    const double end = signed_distance(path.end);
    if (start < resting) return start < r - blur && end < r - blur ? Answer::contact : Answer::undecided;
    if (end < r - blur) return Answer::contact;
    if (end < resting) return Answer::undecided;
    const auto crossing = truth.first_crossing(path);
    if (bent > 0 || r > 0) {
      const double least = crossing ? 0 : truth.distance(path);
      if (least < r - bent - blur) return Answer::contact;
      return bent > 0 ? (least > r + bent + blur ? Answer::none : Answer::undecided) : least < resting ? Answer::undecided : Answer::none;
    }
    if (crossing) return crossing->margin > 1e-6 ? Answer::contact : Answer::undecided;
    return start > blur && end > blur && truth.distance(path) < blur ? Answer::undecided : Answer::none;
  }

  std::shared_ptr<const Surface> surface;
  Truth truth;
  Swept detector;
  double r, offset, reach, angle = 0;
  Motion motion;
  Frame before, now;
};

struct Count {
  std::size_t judged = 0, contacts = 0, wrong = 0, undecided = 0;
  std::size_t relocated_inside = 0, too_far = 0, tested = 0;
  std::uint64_t first_wrong_seed = 0;
};

void play(std::uint64_t seed, Count& count) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  const double r = random() % 2 == 0 ? 0 : 0.05 * unit(random);
  std::vector<ContactResolver> resolvers;
  const std::size_t bodies = 1 + random() % 3;
  const double turns = random() % 2 == 0 ? 0 : 0.1;  // [rad] per step at most
  for (std::size_t b = 0; b < bodies; ++b) {
    const double scale = 0.4 + 1.2 * unit(random);
    const Vec3d off = 0.5 * fixtures::random_direction(random);
    resolvers.emplace_back(fixtures::moved(any_shape(random), [&](const Vec3d& p) { return scale * p + off; }), r);
    resolvers[b].advance(Vec3d{0.8 * static_cast<double>(b), 0, 0} + 0.3 * fixtures::random_direction(random), 3 * fixtures::random_direction(random));
  }
  fixtures::TestPoints points;
  points.block = 8;
  while (points.x1.size() < 48) {
    // near one of the bodies, moving in a random direction, preferably towards the body
    const ContactResolver& aim = resolvers[random() % bodies];
    const auto& t = aim.truth.soup().triangles[random() % aim.truth.soup().triangles.size()];
    const Vec3d place = aim.now.there(t[random() % 3] + 0.5 * unit(random) * fixtures::random_direction(random));
    if (std::any_of(resolvers.begin(), resolvers.end(), [&](const ContactResolver& s) { return s.signed_distance(s.now.seen(place)) < r + 1e-6; })) continue;
    points.x1.push_back(place);
    const Vec3d heading = fixtures::random_direction(random) + 0.5 * normalised(aim.now.place - place);
    points.v.push_back((random() % 100 == 0 ? 0.8 : 0.08) * unit(random) * heading);
  }
  for (int step = 0; step < 6; ++step) {
    points.x0 = points.x1;
    for (std::size_t i = 0; i < points.size(); ++i) points.x1[i] += points.v[i];
    const double pace = unit(random);  // the speed of bodies varies
    for (std::size_t b = 0; b < bodies; ++b) {
      ContactResolver& resolver = resolvers[b];
      resolver.advance(0.08 * pace * fixtures::random_direction(random), turns * pace * fixtures::random_direction(random));
      std::vector<Answer> truth;
      for (std::size_t i = 0; i < points.size(); ++i) truth.push_back(resolver.judge(points.x0[i], points.x1[i]));
      const std::vector<Contact> contacts = fixtures::detect(resolver.detector, points, resolver.motion, travel_bound(resolver.motion, {}, resolver.reach));
      std::vector<bool> found(points.size(), false);
      for (const Contact& contact : contacts) found[contact.point] = true;
      for (std::size_t i = 0; i < points.size(); ++i) {
        ++count.judged;
        if (truth[i] == Answer::undecided) {
          ++count.undecided;
        } else {
          count.contacts += truth[i] == Answer::contact;
          if (found[i] != (truth[i] == Answer::contact)) {
            if (count.wrong++ == 0) count.first_wrong_seed = seed;
          }
        }
      }
      for (const Contact& contact : contacts) {
        const std::size_t i = contact.point;
        const double place = resolver.signed_distance(resolver.now.seen(contact.relocation)), end = resolver.signed_distance(resolver.now.seen(points.x1[i]));
        count.relocated_inside += place < r;
        // where the path ended too near, the point is relocated to the contact radius; after a relocation about the first contact it is
        // farther off by the tolerance of the advancement
        count.too_far += end < r && place > r + 2 * resolver.offset + 1e-6;
        points.v[i] += contact.relocation - points.x1[i];
        points.x1[i] = contact.relocation;
        for (std::size_t other = 0; other < bodies; ++other)
          if (other != b) resolvers[other].detector.moved(i);
      }
    }
  }
  for (const ContactResolver& resolver : resolvers) count.tested += resolver.detector.effort().points_tested;
}

}  // namespace

TEST_CASE("evidence: in 1000 random scenes the contacts are those of brute force over all panels and points") {
  Count count;
  for (std::uint64_t seed = 1; seed <= 1000; ++seed) play(seed, count);
  CHECK(count.contacts > 10'000);
  CAPTURE(count.first_wrong_seed);
  CHECK(count.wrong == 0);
  CHECK(count.relocated_inside == 0);
  CHECK(count.too_far == 0);
  CHECK(count.undecided < count.judged / 50);  // mostly points at rest on rotating bodies
  CHECK(count.tested < count.judged / 2);      // so the cache of distances was exercised
}
