#include "fccda/deforming/deforming_surface.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <utility>

#include "base/error.hpp"
#include "base/finite.hpp"
#include "base/parallel.hpp"

namespace fccda {

namespace {

constexpr double worn = 1.5;           // of the cost after construction: above it the tree is rebuilt
constexpr double together = 1e-6;      // of the size: how far merged vertices may part
constexpr double without_area = 1e-9;  // of the square of a triangle's longest side

/// Vertices or triangles that one thread processes at a time: the same for any number of threads, so that sums are.
constexpr std::size_t chunk = 4096;

/// Combines of(first, last) over chunks of [0, count) in their order, evaluated in parallel.
template <class Part, class Of, class Combine>
Part over_chunks(std::size_t count, const Of& of, const Combine& combine) {
  std::vector<Part> parts((count + chunk - 1) / chunk);
  parallel_for(static_cast<std::ptrdiff_t>(parts.size()), [&](std::ptrdiff_t k) {
    const std::size_t first = static_cast<std::size_t>(k) * chunk;
    parts[static_cast<std::size_t>(k)] = of(first, std::min(first + chunk, count));
  });
  Part all;
  for (const Part& part : parts) combine(all, part);
  return all;
}

std::size_t number(int index) { return static_cast<std::size_t>(index); }

}  // namespace

DeformingSurface::DeformingSurface(const Surface& surface) {
  if (surface.report().may_overlap > 0)
    throw InputError("deforming surface: " + std::to_string(surface.report().may_overlap) +
                     " of its closed parts may overlap, and the union of parts is evaluated for rigid surfaces only; give each part a surface of its own.");
  for (std::unique_ptr<End>& one : ends_) one = std::make_unique<End>(surface);
  size_ = largest_magnitude(surface.report().bounds.size());
  built_cost_ = bvh_t1().cost();
  positions_.assign(surface.vertices().begin(), surface.vertices().end());
  find_sources();
}

// A corner of a triangle is the corner of its panel that became it by welding, the nearest of several. Where a sliver gave the triangle its corner
// (slivers.hpp), the panel has none that did; the corner is then that of another triangle, or of the sliver itself.
void DeformingSurface::find_sources() {
  const Surface& surface = at_t1();
  const Panels& panels = surface.panels();
  source_.assign(surface.vertices().size(), -1);
  const auto find_in = [&](std::span<const int> corners, int vertex) {
    const Vec3d& place = surface.vertices()[number(vertex)];
    const auto apart = [&](int corner) {
      return corner >= 0 && surface.became(corner, vertex) ? norm(panels.vertices[number(corner)] - place) : std::numeric_limits<double>::infinity();
    };
    const int own = *std::min_element(corners.begin(), corners.end(), [&](int a, int b) { return apart(a) < apart(b); });
    return std::isfinite(apart(own)) ? own : -1;
  };
  for (std::size_t t = 0; t < surface.triangles().size(); ++t) {
    const Triangle& triangle = surface.triangles()[t];
    for (const int vertex : triangle.vertex) {
      const int own = find_in(panels.panels[number(triangle.panel)], vertex);
      int& source = source_[number(vertex)];
      if (own >= 0 && source < 0) source = own;
      if (own >= 0 && source != own) merged_.push_back({own, source, norm(panels.vertices[number(own)] - panels.vertices[number(source)])});
    }
  }
  if (std::ranges::find(source_, -1) != source_.end()) {  // of slivers only
    std::vector<int> all(panels.vertices.size());
    std::iota(all.begin(), all.end(), 0);
    for (std::size_t v = 0; v < source_.size(); ++v)
      if (source_[v] < 0) source_[v] = find_in(all, static_cast<int>(v));
  }
  const auto pair = [](const Merged& one) { return std::pair(one.vertex, one.with); };
  std::sort(merged_.begin(), merged_.end(), [&](const Merged& a, const Merged& b) { return pair(a) < pair(b); });
  merged_.erase(std::unique(merged_.begin(), merged_.end(), [&](const Merged& a, const Merged& b) { return pair(a) == pair(b); }), merged_.end());
}

std::array<int, 3> DeformingSurface::panel_vertices(std::size_t t) const {
  const std::array<int, 3>& vertex = at_t1().triangles()[t].vertex;
  return {source_[number(vertex[0])], source_[number(vertex[1])], source_[number(vertex[2])]};
}

void DeformingSurface::expect_usable(std::span<const Vec3d> from_vertices, std::span<const Vec3d> vertices) const {
  const std::size_t expected = at_t1().panels().vertices.size();
  if (vertices.size() != expected)
    throw InputError("deforming surface: there are positions of " + std::to_string(vertices.size()) + " vertices, but its panels have " +
                     std::to_string(expected) + "; give one for each.");
  for (std::size_t v = 0; v < source_.size(); ++v) {
    const int own = source_[v];
    const Vec3d &from = from_vertices[v], &to = vertices[number(own)];
    const double squared = squared_norm(to - from);
    if (squared <= longest_path * longest_path * size_ * size_) continue;
    const std::string sentence = "deforming surface: vertex " + std::to_string(own) + " goes from " + in_words(from) + " to " + in_words(to) + " in one step, ";
    if (!std::isfinite(squared)) throw RunError(sentence + "which is not finite; the solver has become unstable, use a shorter step.");
    throw RunError(sentence + "farther than " + in_words(longest_path * size_) +
                   " m, beyond which rounding hides contact; the solver has become unstable, use a shorter step.");
  }
  for (const Merged& pair : merged_) {
    if (norm(vertices[number(pair.vertex)] - vertices[number(pair.with)]) <= pair.distance + together * size_) continue;
    throw InputError("deforming surface: the vertices " + std::to_string(pair.vertex) + " and " + std::to_string(pair.with) +
                     " were merged at construction, but part from each other; move them together.");
  }
}

// Of positions_.
void DeformingSurface::expect_sound() const {
  struct Found {
    double volume = 0;  // six times that enclosed
    std::size_t flat = std::numeric_limits<std::size_t>::max();
  };
  const std::span<const Triangle> triangles = at_t1().triangles();
  const Vec3d origin = positions_[0];
  const Found found = over_chunks<Found>(
      triangles.size(),
      [&](std::size_t first, std::size_t last) {
        Found part;
        for (std::size_t t = first; t < last; ++t) {
          const std::array<int, 3>& v = triangles[t].vertex;
          const Vec3d a = positions_[number(v[0])] - origin, ab = positions_[number(v[1])] - origin - a, ac = positions_[number(v[2])] - origin - a;
          const Vec3d normal = cross(ab, ac);
          part.volume += dot(a, normal);
          const double side = std::max({squared_norm(ab), squared_norm(ac), squared_norm(ac - ab)});
          if (!(squared_norm(normal) > without_area * without_area * side * side)) part.flat = std::min(part.flat, t);
        }
        return part;
      },
      [](Found& all, const Found& part) { all.volume += part.volume, all.flat = std::min(all.flat, part.flat); });
  if (found.flat < triangles.size())
    throw InputError("deforming surface: panel " + std::to_string(triangles[found.flat].panel) +
                     " has no area at the end of the step, so it has no side; use a shorter step, or a finer mesh where it is compressed.");
  if (at_t1().is_closed() && !(found.volume > 0))
    throw InputError("deforming surface: it is closed, but encloses a volume of " + in_words(found.volume / 6) +
                     " m³ at the end of the step: it is turned inside out; use a shorter step.");
}

void DeformingSurface::measure_step() {
  const std::span<const Vec3d> from = at_t0().vertices(), to = at_t1().vertices();
  struct Measured {
    Box displacements;
    double squared = 0;
  };
  const auto measure = [&](const Vec3d& about) {
    return over_chunks<Measured>(
        from.size(),
        [&](std::size_t first, std::size_t last) {
          Measured part;
          for (std::size_t v = first; v < last; ++v) {
            const Vec3d displacement = to[v] - from[v];
            part.displacements.include(displacement);
            part.squared = std::max(part.squared, squared_norm(displacement - about));
          }
          return part;
        },
        [](Measured& all, const Measured& part) {
          all.displacements.include(part.displacements.low), all.displacements.include(part.displacements.high);
          all.squared = std::max(all.squared, part.squared);
        });
  };
  const Measured absolute = measure({});
  travel_ = std::sqrt(absolute.squared);
  mean_ = absolute.displacements.centre();
  spread_ = std::sqrt(measure(mean_).squared);
}

void DeformingSurface::update_tree() {
  End &now = *ends_[1], &before = *ends_[0];
  now.bvh.refit();
  if (now.bvh.cost() <= worn * built_cost_) return;
  now.bvh = Bvh(now.surface);
  before.bvh = Bvh(now.bvh, before.surface);
  built_cost_ = now.bvh.cost();
  ++rebuilds_;
}

// Sets positions_, or throws and changes nothing that the next move depends on.
void DeformingSurface::take(std::span<const Vec3d> from, std::span<const Vec3d> vertices) {
  expect_usable(from, vertices);
  for (std::size_t v = 0; v < source_.size(); ++v) positions_[v] = vertices[number(source_[v])];
  expect_sound();
}

void DeformingSurface::finish_move() {
  ends_[1]->surface.displace(positions_);
  update_tree();
  measure_step();
}

void DeformingSurface::move(std::span<const Vec3d> vertices) {
  take(at_t1().vertices(), vertices);
  std::swap(ends_[0], ends_[1]);
  finish_move();
  ++steps_;
}

double DeformingSurface::move_again(std::span<const Vec3d> vertices) {
  take(at_t0().vertices(), vertices);
  double furthest = 0;
  for (std::size_t v = 0; v < positions_.size(); ++v) furthest = std::max(furthest, squared_norm(positions_[v] - at_t1().vertices()[v]));
  finish_move();
  return std::sqrt(furthest);
}

void DeformingSurface::place(std::span<const Vec3d> vertices) {
  take(at_t1().vertices(), vertices);
  for (std::unique_ptr<End>& end : ends_) {
    end->surface.displace(positions_);
    end->bvh.refit();
  }
  update_tree();
  measure_step();
  ++steps_;  // detectors notice that a step of theirs is missing, and forget the distances from where the surface was
}

}  // namespace fccda
