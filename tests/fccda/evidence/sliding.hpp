/// Scenes in which points are pressed against a surface and slide on it with friction, and a reference test for points behind a panel.
/// Everything is random: the shape, the contact radius, friction, the motion of the body, the body force on the points.
///
/// The reference test follows each point along straight lines, from its position to its relocation and on to its position after friction, in
/// the body frame. A point is behind
///   - an open vessel if it is beyond one of its walls, each an infinite plane, unless it has left over the rim before;
///   - the surface of a closed body if it is inside by the winding number, or on a line through a triangle, in extended precision, from
///     either side.
#pragma once

#include <algorithm>

#include "fccda/api/contact_detector.hpp"
#include "fccda/api/respond_arrays.hpp"
#include "fccda/evidence/shapes.hpp"
#include "fccda/evidence/truth.hpp"

namespace evidence {

enum class Kind { wedge, tank, folded_sheet, closed_body };

inline const char* name_of(Kind kind) {
  constexpr std::array names{"wedge", "tank", "folded sheet", "closed body"};
  return names[static_cast<std::size_t>(kind)];
}

struct Lost {
  std::size_t scenes = 0, contacts = 0, shifted = 0;  ///< shifted: contacts that friction moved
  std::size_t behind = 0;                             ///< points that ended behind a panel
  std::size_t too_near = 0;                           ///< contacts that ended nearer than the contact radius
  std::uint64_t first_seed = 0;                       ///< of a scene with either
  double nearest = 0;                                 ///< [m] the least distance less the contact radius

  Lost& operator+=(const Lost& b) {
    if (first_seed == 0) first_seed = b.first_seed;
    scenes += b.scenes, contacts += b.contacts, shifted += b.shifted, behind += b.behind, too_near += b.too_near;
    nearest = std::min(nearest, b.nearest);
    return *this;
  }
};

/// A plane of the body frame; in front is normal·x > least.
struct Wall {
  Vec3d normal;
  double least;
  double height(const Vec3d& x) const { return dot(normal, x) - least; }
};

inline Wall wall_through(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  const Vec3d normal = normalised(cross(b - a, c - a));
  return {normal, dot(normal, a)};
}

struct SlidingScene {
  Panels panels;
  bool open = false;
  std::vector<Wall> walls;  ///< of an open vessel
  std::vector<Wall> rim;    ///< in front of one of these: left over the rim
  Vec3d down{0, 0, -1};     ///< into the vessel, or against the body
};

/// Rotates everything at random, so that nothing is axis-aligned.
inline void tilt(SlidingScene& scene, std::mt19937_64& random) {
  const Vec3d rotation = 3 * fixtures::random_direction(random);
  for (Vec3d& v : scene.panels.vertices) v = turned(v, rotation);
  for (std::vector<Wall>* planes : {&scene.walls, &scene.rim})
    for (Wall& wall : *planes) wall.normal = turned(wall.normal, rotation);
  scene.down = turned(scene.down, rotation);
}

/// A V of two panels, or a funnel of three to seven, open at the top. Opening from 1° to 150°.
inline SlidingScene wedge(std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  SlidingScene scene{.open = true};
  const double half = 0.5 * std::numbers::pi / 180 * std::pow(150.0, unit(random));
  const double top = std::cos(half), wide = std::sin(half);
  auto& v = scene.panels.vertices;
  if (random() % 2 == 0) {
    v = {{-wide, -1, top}, {0, -1, 0}, {0, 1, 0}, {-wide, 1, top}, {wide, -1, top}, {wide, 1, top}};
    scene.panels.add_quad(0, 1, 2, 3);
    scene.panels.add_quad(1, 4, 5, 2);
    scene.walls = {wall_through(v[0], v[1], v[2]), wall_through(v[1], v[4], v[5])};
    scene.rim = {{{0, 0, 1}, top}, {{0, 1, 0}, 1}, {{0, -1, 0}, 1}};
  } else {
    const int sides = 3 + static_cast<int>(random() % 5);
    v.push_back({});
    for (int k = 0; k < sides; ++k) {
      const double angle = 2 * std::numbers::pi * (k + 0.3 * unit(random)) / sides;
      v.push_back({wide * std::cos(angle), wide * std::sin(angle), top});
    }
    for (int k = 0; k < sides; ++k) {
      const int a = 1 + k, b = 1 + (k + 1) % sides;
      scene.panels.add_triangle(0, a, b);
      scene.walls.push_back(wall_through({}, v[static_cast<std::size_t>(a)], v[static_cast<std::size_t>(b)]));
    }
    scene.rim = {{{0, 0, 1}, top}};
  }
  return scene;
}

/// Floor and four walls, upright or leaning in or out, open at the top, of one panel each or many.
inline SlidingScene tank(std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  SlidingScene scene{.open = true};
  const double x = 0.1 + unit(random), y = 0.1 + unit(random), height = 0.3 + 0.7 * unit(random), lean = random() % 3 == 0 ? 1 : 0.4 + 1.2 * unit(random);
  const int cut = 1 + static_cast<int>(random() % 4);
  const Vec3d low[4] = {{-x, -y, 0}, {x, -y, 0}, {x, y, 0}, {-x, y, 0}};
  const auto add = [&](const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d) {  // a grid on the quad, front where it turns left
    const int first = static_cast<int>(scene.panels.vertices.size());
    for (int i = 0; i <= cut; ++i)
      for (int j = 0; j <= cut; ++j) {
        const double s = double(i) / cut, t = double(j) / cut;
        scene.panels.vertices.push_back((1 - s) * ((1 - t) * a + t * d) + s * ((1 - t) * b + t * c));
      }
    for (int i = 0; i < cut; ++i)
      for (int j = 0; j < cut; ++j) {
        const int at = first + i * (cut + 1) + j;
        scene.panels.add_quad(at, at + cut + 1, at + cut + 2, at + 1);
      }
    scene.walls.push_back(wall_through(a, b, c));
  };
  const auto up = [&](int k) { return Vec3d{lean * low[k].x, lean * low[k].y, height}; };
  add(low[0], low[1], low[2], low[3]);
  for (int k = 0; k < 4; ++k) add(low[k], up(k), up((k + 1) % 4), low[(k + 1) % 4]);
  for (Wall& wall : scene.walls)
    if (wall.height({0, 0, 0.5 * height}) < 0) throw std::logic_error("a wall of the tank faces outward");
  scene.rim = {{{0, 0, 1}, height}};
  return scene;
}

/// A closed prism of a profile in the x–z plane, which turns left seen from -y, cut into pieces along y.
inline Panels prism(const std::vector<std::array<double, 2>>& left, const std::vector<std::array<double, 2>>& right) {
  Panels panels;  // a strip between two lines of equally many points, closed all round
  const int n = static_cast<int>(left.size());
  for (const double y : {-0.5, 0.5}) {
    for (const auto& p : left) panels.vertices.push_back({p[0], y, p[1]});
    for (const auto& p : right) panels.vertices.push_back({p[0], y, p[1]});
  }
  const int back = 2 * n;
  for (int k = 0; k + 1 < n; ++k) {
    panels.add_quad(k, k + 1, back + k + 1, back + k);
    panels.add_quad(n + k, back + n + k, back + n + k + 1, n + k + 1);
    panels.add_quad(k, n + k, n + k + 1, k + 1);
    panels.add_quad(back + k, back + k + 1, back + n + k + 1, back + n + k);
  }
  panels.add_quad(0, back, back + n, n);
  panels.add_quad(n - 1, 2 * n - 1, back + 2 * n - 1, back + n - 1);
  return panels;
}

/// A thin sheet with two to six folds, 1e-5 to 1e-2 thick.
inline SlidingScene folded_sheet(std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  const int folds = 2 + static_cast<int>(random() % 5);
  const double thickness = std::pow(10.0, -2 - 3 * unit(random)), steep = 0.1 + 3 * unit(random);
  std::vector<std::array<double, 2>> low, high;
  for (int k = 0; k <= folds; ++k) {
    const double x = double(k) / folds - 0.5, z = (k % 2 == 0 ? 0.5 : -0.5) * steep / folds * (0.6 + 0.4 * unit(random));
    low.push_back({x, z - 0.5 * thickness});
    high.push_back({x, z + 0.5 * thickness});
  }
  return {.panels = prism(low, high)};
}

/// Convex and concave, thick and thin.
inline SlidingScene closed_body(std::mt19937_64& random) {
  const auto any = [&]() -> Panels {
    const Panels ball = make_sphere({.diameter = 1, .edge_length = 0.3});
    switch (random() % 7) {
      case 0:
        return make_box({.size = {1, 0.6, 0.4}, .edge_length = 0.5});
      case 1:
        return fixtures::torus(0.4, 0.15, 12, 6);
      case 2:  // a blade
        return fixtures::moved(ball, [](const Vec3d& p) { return Vec3d{p.x, 0.4 * p.y, 0.01 * p.z}; });
      case 3:
        return fixtures::moved(ball, [](const Vec3d& p) {
          const double bump = 1 + 0.3 * std::sin(9 * p.x) * std::cos(7 * p.y + 1) * std::cos(8 * p.z);
          return Vec3d{bump * p.x, 0.5 * bump * p.y, 0.4 * bump * p.z};
        });
      case 4: {  // a wedge cut into a block
        const double half = 0.01 + 0.3 * std::uniform_real_distribution<double>(0, 1)(random);
        return prism({{-0.5, -0.5}, {0, -0.5}, {0.5, -0.5}}, {{-0.5, 0.5}, {0, 0.5 - half}, {0.5, 0.5}});
      }
      case 5: {  // a channel
        return prism({{-0.5, 0.5}, {-0.5, -0.1}, {0.5, -0.1}, {0.5, 0.5}}, {{-0.4, 0.5}, {-0.4, 0}, {0.4, 0}, {0.4, 0.5}});
      }
      default:
        return make_cylinder({.diameter = 1, .height = 0.5, .axis = Axis::z, .edge_length = 0.3, .panels = PanelKind::quads});
    }
  };
  return {.panels = any()};
}

inline SlidingScene scene_of(Kind kind, std::mt19937_64& random) {
  SlidingScene scene = kind == Kind::wedge          ? wedge(random)
                       : kind == Kind::tank         ? tank(random)
                       : kind == Kind::folded_sheet ? folded_sheet(random)
                                                    : closed_body(random);
  tilt(scene, random);
  return scene;
}

/// Whether the line goes through a triangle, from either side, clearly inside it.
inline bool goes_through(const Vec3d& from, const Vec3d& to, const std::vector<std::array<Vec3d, 3>>& triangles) {
  struct Long {
    long double x, y, z;
    explicit Long(const Vec3d& v) : x(v.x), y(v.y), z(v.z) {}
    Long(long double a, long double b, long double c) : x(a), y(b), z(c) {}
    Long operator-(const Long& b) const { return {x - b.x, y - b.y, z - b.z}; }
    Long operator^(const Long& b) const { return {y * b.z - z * b.y, z * b.x - x * b.z, x * b.y - y * b.x}; }
    long double operator*(const Long& b) const { return x * b.x + y * b.y + z * b.z; }
  };
  const Vec3d low = min(from, to), high = max(from, to);
  for (const auto& t : triangles) {
    bool apart = false;
    for (std::size_t k = 0; k < 3; ++k) apart |= std::max({t[0][k], t[1][k], t[2][k]}) < low[k] || std::min({t[0][k], t[1][k], t[2][k]}) > high[k];
    if (apart) continue;
    const Long a(t[0]), b(t[1]), c(t[2]), p(from), q(to), normal = (b - a) ^ (c - a);
    const long double before = (p - a) * normal, after = (q - a) * normal;
    if ((before > 0) == (after > 0) || before == 0 || after == 0) continue;
    const Long way = q - p;
    const long double u = way * ((b - p) ^ (c - p)), v = way * ((c - p) ^ (a - p)), w = way * ((a - p) ^ (b - p));
    const long double least = 1e-9L * std::fabs(u + v + w);  // 80 bits are too few for paths along the panel, an offset off it
    if ((u > least && v > least && w > least) || (u < -least && v < -least && w < -least)) return true;
  }
  return false;
}

inline Lost play_sliding(Kind kind, std::uint64_t seed) {
  std::mt19937_64 random(1000 * seed + static_cast<std::uint64_t>(kind));
  std::uniform_real_distribution<double> unit(0, 1);
  const SlidingScene scene = scene_of(kind, random);
  const double r = random() % 2 == 0 ? 0 : std::pow(10.0, -1 - 3 * unit(random)), friction = random() % 4 == 0 ? 0 : unit(random);
  const Surface surface(scene.panels, {.orientation = scene.open ? Orientation::normals : Orientation::undeclared});
  const fixtures::Soup soup(surface);
  ContactDetector detector(surface, {.radius = r});
  const Vec3d extent = surface.report().bounds.size();
  const double offset = 1e-12 * std::max({extent.x, extent.y, extent.z});

  // Rest, uniform translation or uniform rotation.
  const std::uint64_t motion_kind = random() % 3;
  const double dt = std::pow(10.0, -3 + 2 * unit(random));
  RigidBody body({.mass = 1}, Pose(fixtures::random_direction(random), Quaternion::from_rotation(fixtures::random_direction(random)).normalised()),
                 motion_kind == 0 ? Vec3d{} : unit(random) * fixtures::random_direction(random),
                 motion_kind == 2 ? 0.05 * unit(random) / dt * fixtures::random_direction(random) : Vec3d{}, {});

  const double angle = dt * norm(body.angular_velocity());

  // Points outside, with clearance for the ball.
  const Vec3d middle = surface.report().bounds.centre();
  const auto height = [&](const Vec3d& seen) {
    double least = 1e300;
    for (const Wall& wall : scene.walls) least = std::min(least, wall.height(seen));
    return least;
  };
  const auto over_rim = [&](const Vec3d& seen, double margin) {
    return std::any_of(scene.rim.begin(), scene.rim.end(), [&](const Wall& wall) { return wall.height(seen) > -margin; });
  };
  constexpr std::size_t wanted = 10;
  std::vector<Vec3d> x_t0, x, v;
  for (int trial = 0; trial < 4000 && x.size() < wanted; ++trial) {
    const Vec3d seen = middle + 0.75 * Vec3d{extent.x * (2 * unit(random) - 1), extent.y * (2 * unit(random) - 1), extent.z * (2 * unit(random) - 1)};
    if (!(soup.distance(seen) > r + 1e-9)) continue;
    if (scene.open ? !(height(seen) > r) || over_rim(seen, r) : soup.inside(seen)) continue;
    x.push_back(body.pose().to_world(seen));
    v.push_back(body.velocity() + unit(random) * fixtures::random_direction(random));
  }
  const Vec3d aside = fixtures::random_direction(random);
  const double pull = 0.3 * unit(random) / dt;
  std::vector<bool> followed(x.size(), true), held(x.size(), true);  // held: has never been where only the centre counts, beside the rim

  Lost lost{.scenes = 1};
  for (int step = 0; step < 60; ++step) {
    x_t0 = x;
    const Vec3d tangential = 0.5 * turned(aside, {0.05 * step, 0.02 * step, 0});
    std::vector<Vec3d> seen_t0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      const Vec3d seen = body.pose().to_body(x[i]);
      seen_t0.push_back(seen);
      const Vec3d down = scene.open ? scene.down : normalised(middle - seen);
      v[i] += pull * dt * body.pose().turn_to_world(down + tangential);
      x[i] += dt * v[i];
    }
    const Motion motion = body.advance(dt);
    const std::vector<Contact> contacts = detector.detect(motion, x_t0, x);
    respond(contacts, motion, body, {.x_t0 = x_t0, .x_t1 = x, .velocity = v, .mass = 1.0}, friction);
    std::vector<const Contact*> of(x.size(), nullptr);
    for (const Contact& contact : contacts) of[contact.point] = &contact;
    for (std::size_t i = 0; i < x.size(); ++i) {
      if (!followed[i]) continue;
      const Vec3d place = body.pose().to_body(x[i]);
      const auto print_error = [&](std::size_t& count) {
        ++count;
        if (lost.first_seed == 0) lost.first_seed = seed;
      };
      if (scene.open) {
        // Relative to a rotating body the path is curved, and may go over the rim in between.
        const double bulge = angle * (2 * angle + 2 * norm(place - seen_t0[i])) / 8;
        if (over_rim(place, bulge) || (of[i] && over_rim(body.pose().to_body(of[i]->relocation), 0))) {
          followed[i] = false;
          continue;
        }
        if (over_rim(place, 1.1 * r)) held[i] = false;
      }
      bool behind;
      if (scene.open) {
        behind = height(place) < 0;
      } else {
        const Vec3d relocated = of[i] ? body.pose().to_body(of[i]->relocation) : place;
        // Relative to a rotating body the path is curved: a path round a bulge is not a crossing, so only its end and the friction part count.
        behind = (motion_kind != 2 && goes_through(seen_t0[i], relocated, soup.triangles)) || goes_through(relocated, place, soup.triangles) ||
                 ((of[i] || step % 10 == 9) && soup.inside(place));
      }
      if (behind) {
        print_error(lost.behind);
        followed[i] = false;
        continue;
      }
      if (!of[i]) continue;
      ++lost.contacts;
      lost.shifted += x[i] != of[i]->relocation;
      const double gap = (scene.open ? height(place) : soup.distance(place)) - r;
      if (!held[i] || gap >= 0.25 * offset) continue;
      lost.nearest = std::min(lost.nearest, gap);
      print_error(lost.too_near);
    }
  }
  return lost;
}

/// `count` scenes of the kind, on all threads.
inline Lost play_sliding_scenes(Kind kind, std::uint64_t first, std::uint64_t count) {
  std::vector<Lost> each(count);
  parallel_for_uneven(static_cast<std::ptrdiff_t>(count), [&](std::ptrdiff_t k) {
    const auto n = static_cast<std::size_t>(k);
    each[n] = play_sliding(kind, first + n);
  });
  Lost total;
  for (const Lost& lost : each) total += lost;
  return total;
}

}  // namespace evidence
