#include "mesh/remesh/coarsen.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <tuple>

#include "base/contract.hpp"
#include "mesh/remesh/as_panels.hpp"
#include "mesh/remesh/clearance.hpp"
#include "mesh/remesh/collapsible.hpp"
#include "mesh/remesh/fan_shift.hpp"

namespace fccda {
namespace {

constexpr double least_shape = 0.05;  // height over longest edge; 0.87 where equilateral
constexpr double least_cosine = 0.5;  // between the normals of a triangle and of the one it replaces

constexpr double weight_of_shape = 0.1;  // against the share of the tolerance that a collapse uses: prefers better shapes among similar ones
using TriangleCorners = std::array<Vec3d, 3>;

Vec3d doubled_area(const TriangleCorners& t) { return cross(t[1] - t[0], t[2] - t[0]); }

/// Height over longest edge.
double shape(const TriangleCorners& t) {
  const double longest = std::max({squared_norm(t[1] - t[0]), squared_norm(t[2] - t[1]), squared_norm(t[0] - t[2])});
  return longest > 0 ? norm(doubled_area(t)) / longest : 0;
}

/// Vertices that coincide with another: sheets meet there. An edge between two of them could coincide with another after a collapse.
std::vector<bool> shared_vertices(const Surface& surface) {
  const auto vertices = surface.vertices();
  std::vector<std::size_t> order(vertices.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto key = [&](std::size_t v) { return std::tuple(vertices[v].x, vertices[v].y, vertices[v].z, v); };
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
  std::vector<bool> shared(vertices.size(), false);
  for (std::size_t k = 1; k < order.size(); ++k)
    if (vertices[order[k]] == vertices[order[k - 1]]) shared[order[k]] = shared[order[k - 1]] = true;
  return shared;
}

class Coarsener {
 public:
  Coarsener(const Surface& surface, const Coarsening& wanted)
      : surface_(surface),
        mesh_(surface),
        distance_(wanted.max_deviation),
        panel_(wanted.max_edge_length),
        moved_(surface.triangles().size(), 0.0),
        limits_(clearance(surface, wanted.max_deviation)),
        is_shared_(shared_vertices(surface)) {}

  /// Passes over the vertices whose surroundings changed in the previous pass. A pass skips vertices whose triangles it has already changed,
  /// so that panels grow evenly.
  void run() {
    std::vector<int> waiting(mesh_.vertex_count());
    std::iota(waiting.begin(), waiting.end(), 0);
    std::vector<int> changed_in_pass(mesh_.vertex_count(), 0);
    for (int pass = 1; !waiting.empty(); ++pass) {
      sort_by_shortest_edge(waiting);
      std::vector<int> changed;
      for (const int vertex : waiting) {
        if (!mesh_.has_vertex(vertex) || changed_in_pass[static_cast<std::size_t>(vertex)] == pass || !collapse(vertex)) continue;
        for (const int neighbour : ring_.link) {
          int& last = changed_in_pass[static_cast<std::size_t>(neighbour)];
          if (last != pass) changed.push_back(neighbour);
          last = pass;
        }
      }
      waiting = std::move(changed);
    }
  }

  Coarsened result() const {
    Coarsened out{empty_panels(surface_)};
    std::vector<int> number(mesh_.vertex_count(), -1);
    for (std::size_t v = 0; v < number.size(); ++v) {
      if (!mesh_.has_vertex(static_cast<int>(v))) continue;
      number[v] = static_cast<int>(out.panels.vertices.size());
      out.panels.vertices.push_back(mesh_.place(static_cast<int>(v)));
    }
    const Vec3d middle = surface_.report().bounds.centre();
    double volume = 0;
    for (std::size_t t = 0; t < mesh_.triangle_count(); ++t) {
      if (!mesh_.has_triangle(t)) continue;
      const auto [a, b, c] = mesh_.triangle(t).vertex;
      add_triangle_like(surface_, static_cast<int>(t),
                        {number[static_cast<std::size_t>(a)], number[static_cast<std::size_t>(b)], number[static_cast<std::size_t>(c)]}, out.panels);
      out.distance = std::max(out.distance, moved_[t]);
      volume += dot(mesh_.place(a) - middle, cross(mesh_.place(b) - middle, mesh_.place(c) - middle)) / 6;
    }
    out.volume_change = surface_.is_closed() ? volume - surface_.report().volume : 0;
    return out;
  }

 private:
  struct Candidate {
    std::size_t to;
    double moved;  // [m] bound for the new triangles
    double cost;
  };

  void sort_by_shortest_edge(std::vector<int>& vertices) {
    std::vector<std::pair<double, int>> order;
    order.reserve(vertices.size());
    for (const int vertex : vertices) {
      if (!mesh_.has_vertex(vertex)) continue;
      mesh_.ring_of(vertex, ring_);
      double shortest = std::numeric_limits<double>::infinity();
      for (const int other : ring_.link) shortest = std::min(shortest, squared_norm(mesh_.place(other) - mesh_.place(vertex)));
      order.emplace_back(shortest, vertex);
    }
    std::sort(order.begin(), order.end());
    vertices.clear();
    for (const auto& [length, vertex] : order) vertices.push_back(vertex);
  }

  int part_of(std::size_t triangle) const { return surface_.part_of_panel(mesh_.triangle(triangle).panel); }

  /// Positions in the link where a boundary or a border between parts continues from the vertex.
  void find_lines() {
    lines_.clear();
    if (!ring_.goes_round) lines_ = {0, ring_.link.size() - 1};
    for (std::size_t j = ring_.goes_round ? 0 : 1; j < ring_.triangles.size(); ++j)
      if (part_of(ring_.triangles[j]) != part_of(ring_.triangles[ring_.before(j)])) lines_.push_back(j);
  }

  /// Collapses the vertex into the neighbour that leaves the best triangles, if any is admissible. ring_ is that of the vertex.
  bool collapse(int vertex) {
    mesh_.ring_of(vertex, ring_);
    if (ring_.link.size() > Fan::max_links || ring_.triangles.size() < 2) return false;
    find_lines();
    if (lines_.size() != 0 && lines_.size() != 2) return false;
    link_.clear();
    old_normals_.clear();
    for (const int other : ring_.link) link_.push_back(mesh_.place(other));

    const Vec3d& place = mesh_.place(vertex);
    double moved = 0, most = std::numeric_limits<double>::infinity(), old_shape = least_shape;
    Vec3d direction{};
    for (std::size_t j = 0; j < ring_.triangles.size(); ++j) {
      const TriangleCorners corners{place, link_[j], link_[ring_.after(j)]};
      old_normals_.push_back(normalised(doubled_area(corners)));
      direction += old_normals_.back();
      old_shape = std::min(old_shape, shape(corners));
      moved = std::max(moved, moved_[ring_.triangles[j]]);
      most = std::min(most, limits_[ring_.triangles[j]]);
    }
    direction = normalised(direction);

    std::optional<Candidate> best;
    for (std::size_t to = 0; to < link_.size(); ++to) {
      if (!lines_.empty() && to != lines_[0] && to != lines_[1]) continue;
      const double new_shape = worst_new_shape(to);
      if (new_shape < old_shape) continue;
      const std::optional<double> by = displacement(place, to, direction);
      if (!by || moved + *by > most) continue;
      const double cost = (moved + *by) / distance_ - weight_of_shape * new_shape;
      if ((!best || cost < best->cost) && mesh_.may_collapse(vertex, ring_, to)) best = Candidate{to, moved + *by, cost};
    }
    if (!best) return false;
    for (const std::size_t t : ring_.triangles) moved_[t] = best->moved, limits_[t] = most;
    mesh_.collapse(vertex, ring_, best->to);
    return true;
  }

  bool are_joined(std::size_t j, std::size_t next) const { return ring_.after(j) == next && (next != 0 || ring_.goes_round); }

  /// Worst shape of the triangles that would replace those about the vertex; -1 if one is inadmissible: an edge that is too long or could
  /// coincide with another, or a flipped normal.
  double worst_new_shape(std::size_t to) const {
    const bool target_is_shared = is_shared_[static_cast<std::size_t>(ring_.link[to])];
    double worst = std::numeric_limits<double>::infinity();
    for (std::size_t j = 0; j < link_.size(); ++j) {
      if (j == to || are_joined(j, to) || are_joined(to, j)) continue;
      if (squared_norm(link_[j] - link_[to]) > panel_ * panel_) return -1;
      if (target_is_shared && is_shared_[static_cast<std::size_t>(ring_.link[j])]) return -1;
    }
    for (std::size_t j = 0; j < ring_.triangles.size(); ++j) {
      if (j == to || ring_.after(j) == to) continue;
      const TriangleCorners corners{link_[to], link_[j], link_[ring_.after(j)]};
      const Vec3d normal = doubled_area(corners);
      if (dot(normal, old_normals_[j]) < least_cosine * norm(normal)) return -1;
      worst = std::min(worst, shape(corners));
    }
    return worst;
  }

  /// [m] Displacement of the surface when link[to] takes the vertex. On a boundary or border the vertex is first moved onto the straight line
  /// that replaces its two edges there, so that both sides are filled within their own outlines.
  std::optional<double> displacement(const Vec3d& place, std::size_t to, const Vec3d& direction) const {
    Vec3d centre = place;
    if (!lines_.empty()) {
      const Vec3d& one = link_[to];
      const Vec3d along = link_[lines_[0] == to ? lines_[1] : lines_[0]] - one;
      centre = one + std::clamp(dot(place - one, along) / squared_norm(along), 0.0, 1.0) * along;
    }
    const std::optional<double> filled = shift({centre, link_, ring_.goes_round}, to, direction);
    if (!filled) return std::nullopt;
    return norm(centre - place) + *filled;
  }

  const Surface& surface_;
  CollapsibleTriangles mesh_;
  double distance_, panel_;      // [m]
  std::vector<double> moved_;    // [m] by triangle, bound of its distance to the given surface
  std::vector<double> limits_;   // [m] by triangle, the largest admissible value
  std::vector<bool> is_shared_;  // by vertex

  // of the current vertex
  Ring ring_;
  std::vector<std::size_t> lines_;
  std::vector<Vec3d> link_, old_normals_;
};

}  // namespace

Coarsened coarsen(const Surface& surface, const Coarsening& wanted) {
  EXPECTS(wanted.max_deviation > 0 && wanted.max_edge_length > 0);
  Coarsener coarsener(surface, wanted);
  coarsener.run();
  return coarsener.result();
}

}  // namespace fccda
