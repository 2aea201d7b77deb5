/// Paths with a known classification, each with motions that produce it as the relative path of a point and a body.
#pragma once

#include <cstdint>
#include <vector>

#include "base/parallel.hpp"
#include "fccda/evidence/truth.hpp"
#include "fixtures/larger.hpp"

namespace evidence {

/// Origin of the relative path: moving points, or points at rest and a body that translates, or rotates as well.
enum class Way { points_move, body_moves, body_turns };

/// A path relative to the surface offset by the contact radius r:
///   into     begins outside, ends inside
///   through  begins and ends outside, but comes nearer than r (r = 0: crosses) in between
///   past     stays outside
/// Ambiguous ones are excluded.
enum class Fate { into, through, past };

struct Passage {
  Path path;  ///< in the body frame
  Fate fate;
  bool is_contact() const { return fate != Fate::past; }
};

/// Passages of a body in one step from one pose.
struct Flight {
  Motion motion;
  double bulge = 0;  ///< [m] bound of the deviation of the points' relative paths from their chords
  std::vector<Passage> passages;

  /// Positions of the points in the world frame at the ends of the step.
  fixtures::TestPoints points(Way way) const {
    fixtures::TestPoints points;
    for (const Passage& passage : passages) {
      points.x0.push_back(motion.t0.to_world(passage.path.start));
      points.x1.push_back(way == Way::points_move ? motion.t1.to_world(passage.path.end) : points.x0.back());
    }
    return points;
  }
};

struct SizeRequest {
  double radius = 0;  ///< r [m]
  double step = 0;    ///< [m] about as long as the paths are
  Way way = Way::points_move;
  std::size_t contacts = 0, past = 0;  ///< how many of each
  std::uint64_t seed = 0;
};

/// Greatest depth of a path inside, at 16 points along it [m].
inline double depth(const Truth& truth, const Path& path) {
  double most = 0;
  for (int k = 1; k < 16; ++k)
    if (const Vec3d place = path.at(k / 16.0); truth.inside(place)) most = fixtures::larger(most, truth.distance(place));
  return most;
}

namespace detail {

/// A point outside, at most a step farther than r from the surface.
inline Vec3d place_outside(const Truth& truth, const SizeRequest& request, double blur, std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  for (;;) {
    const auto& t = truth.soup().triangles[random() % truth.soup().triangles.size()];
    const double u = unit(random), v = unit(random) * (1 - u), target = request.radius + request.step * unit(random);
    const Vec3d foot = t[0] + u * (t[1] - t[0]) + v * (t[2] - t[0]);
    Vec3d direction = fixtures::random_direction(random);
    if (dot(direction, cross(t[1] - t[0], t[2] - t[0])) < 0) direction = -direction;
    // along an oblique line the distance grows slower than the path: a few secant steps
    Vec3d place = foot + target * direction;
    double distance = truth.distance(place);
    for (int k = 0; k < 4 && request.radius > 0 && !(distance > request.radius + blur); ++k) {
      place += (target - distance + 0.1 * request.step) * direction;
      distance = truth.distance(place);
    }
    if (distance > request.radius + blur && distance < request.radius + 1.1 * request.step && !truth.inside(place)) return place;
  }
}

/// `bulge` [m]: bound of the distance of the true path from this one, its chord.
inline std::optional<Fate> fate_of(const Truth& truth, const Path& path, double radius, double blur, double bulge) {
  const double at_end = truth.distance(path.end);
  const bool inside = truth.inside(path.end);
  if (inside ? at_end > blur : at_end < radius - blur) return Fate::into;
  if (inside || !(at_end > radius + blur)) return {};
  const auto crossing = truth.first_crossing(path);
  const double least = crossing ? 0 : truth.distance(path);
  if (least > radius + blur + bulge) return Fate::past;
  if (least < radius - blur - bulge) return Fate::through;
  const bool clearly = crossing && radius == 0 && crossing->margin > 1e-6 && (bulge == 0 || depth(truth, path) > bulge);
  return clearly ? std::optional(Fate::through) : std::nullopt;
}

}  // namespace detail

/// One flight for each of the poses, which share the requested numbers evenly. All random numbers follow from the seed, for any number of threads.
inline std::vector<Flight> flights(const Truth& truth, const SizeRequest& request, const std::vector<Pose>& poses = fixtures::orientations()) {
  std::vector<Flight> all(poses.size());
  const auto share = [&](std::size_t count, std::size_t g) { return count * (g + 1) / poses.size() - count * g / poses.size(); };
  parallel_for_uneven(static_cast<std::ptrdiff_t>(poses.size()), [&](std::ptrdiff_t k) {
    const auto g = static_cast<std::size_t>(k);
    std::mt19937_64 random(request.seed * 1000 + g);
    Flight& flight = all[g];
    flight.motion = {poses[g], poses[g], 1};
    // The motion of a point at rest relative to the body: rotation by `turn` about the origin, then a shift.
    const Vec3d shift =
        request.way == Way::body_turns ? 0.5 * request.step * fixtures::random_direction(random) : request.step * fixtures::random_direction(random);
    const Vec3d turn = request.way == Way::body_turns ? 1.5 * request.step * fixtures::random_direction(random) : Vec3d{};
    if (request.way != Way::points_move) {
      const Quaternion back = Quaternion::from_rotation(-turn);
      const Pose seen({}, (poses[g].attitude() * back).normalised());
      flight.motion.t1 = Pose(poses[g].position() - seen.turn_to_world(shift), seen.attitude());
    }
    // Relative to a rotating body a path deviates from its chord by at most (ρ θ² + 2 θ w)/8, for a point ρ from its centre (0.7 is beyond
    // all shapes) and a path length w. Passages nearer to the limit than that are excluded.
    flight.bulge = (0.7 * dot(turn, turn) + 2 * norm(turn) * norm(shift)) / 8;
    const double blur = 1e-4 * request.step;
    std::size_t contacts = share(request.contacts, g), past = share(request.past, g);
    while (contacts > 0 || past > 0) {
      Path path;
      path.start = detail::place_outside(truth, request, blur, random);
      path.end = request.way == Way::points_move ? path.start + request.step * fixtures::random_direction(random) : turned(path.start, turn) + shift;
      const std::optional<Fate> fate = detail::fate_of(truth, path, request.radius, blur, flight.bulge);
      if (!fate) continue;
      std::size_t& wanted = *fate == Fate::past ? past : contacts;
      if (wanted == 0) continue;
      --wanted;
      flight.passages.push_back({path, *fate});
    }
  });
  return all;
}

}  // namespace evidence
