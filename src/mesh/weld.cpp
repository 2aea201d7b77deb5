#include "mesh/weld.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>

namespace fccda {
namespace {

/// The kept vertices in a hash table of cubic cells with open addressing. A cell is eight tolerances wide, so the ball about a vertex
/// intersects two cells on average. Kept vertices are at least a tolerance apart, so a cell contains some hundreds at most.
class Cells {
 public:
  Cells(std::size_t vertices, double tolerance)
      : slots_(std::bit_ceil(2 * vertices + 2), -1), tolerance_(tolerance), per_cell_(tolerance > 0 ? 0.125 / tolerance : 1) {}

  /// The nearest kept vertex that is nearer than the tolerance or coincident, or -1. Rounding is monotonic, so a vertex within the
  /// tolerance is always in the cells between both ends of the ball.
  int nearest(const Vec3d& point, std::span<const Vec3d> kept) const {
    const Vec3d reach{tolerance_, tolerance_, tolerance_};
    const Vec3d low = cell(point - reach), high = cell(point + reach);
    Nearest best{-1, tolerance_ * tolerance_};
    for (const double x : {low.x, high.x}) {
      for (const double y : {low.y, high.y}) {
        for (const double z : {low.z, high.z}) {
          search_cell({x, y, z}, point, kept, best);
          if (z == high.z) break;
        }
        if (y == high.y) break;
      }
      if (x == high.x) break;
    }
    return best.vertex;
  }

  void insert(const Vec3d& point, int vertex) {
    std::size_t slot = first_slot(cell(point));
    while (slots_[slot] >= 0) slot = (slot + 1) & (slots_.size() - 1);
    slots_[slot] = vertex;
  }

 private:
  struct Nearest {
    int vertex;
    double squared_distance;
  };

  // Cell numbers are doubles: far from the origin they would overflow an integer. Adding zero unifies -0 and 0.
  Vec3d cell(const Vec3d& p) const { return {std::floor(p.x * per_cell_) + 0.0, std::floor(p.y * per_cell_) + 0.0, std::floor(p.z * per_cell_) + 0.0}; }

  std::size_t first_slot(const Vec3d& cell) const {
    std::uint64_t hash = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      hash = (hash ^ std::bit_cast<std::uint64_t>(cell[axis])) * 0x9e3779b97f4a7c15u;  // 2^64 / golden ratio
      hash ^= hash >> 29;
    }
    return hash & (slots_.size() - 1);
  }

  // Other cells may share the chain; the distance rejects their vertices.
  void search_cell(const Vec3d& cell, const Vec3d& point, std::span<const Vec3d> kept, Nearest& best) const {
    for (std::size_t slot = first_slot(cell); slots_[slot] >= 0; slot = (slot + 1) & (slots_.size() - 1)) {
      const int vertex = slots_[slot];
      const double squared_distance = squared_norm(kept[static_cast<std::size_t>(vertex)] - point);
      const bool nearer = squared_distance < best.squared_distance || squared_distance == 0;
      const bool first_of_equals = squared_distance == best.squared_distance && best.vertex > vertex;
      if (nearer || first_of_equals) best = {vertex, squared_distance};
    }
  }

  std::vector<int> slots_;
  double tolerance_;
  double per_cell_;
};

}  // namespace

Welded weld(const Panels& panels, double tolerance) {
  constexpr int unused = -2, waiting = -1;
  std::vector<int> new_number(panels.vertices.size(), unused);
  for (const auto& panel : panels.panels) {
    for (const int vertex : panel) {
      if (vertex >= 0) new_number[static_cast<std::size_t>(vertex)] = waiting;
    }
  }

  Welded out;
  std::vector<Vec3d>& kept = out.panels.vertices;
  Cells cells(panels.vertices.size(), tolerance);
  for (std::size_t v = 0; v < panels.vertices.size(); ++v) {
    if (new_number[v] == unused) continue;
    const Vec3d& point = panels.vertices[v];
    new_number[v] = cells.nearest(point, kept);
    if (new_number[v] >= 0) {
      ++out.merged;
    } else {
      new_number[v] = static_cast<int>(kept.size());
      cells.insert(point, new_number[v]);
      kept.push_back(point);
    }
  }

  out.panels.panels = panels.panels;
  out.panels.part = panels.part;
  out.panels.part_names = panels.part_names;
  for (auto& panel : out.panels.panels) {
    for (int& vertex : panel) vertex = vertex >= 0 ? new_number[static_cast<std::size_t>(vertex)] : vertex;
  }
  out.new_number = std::move(new_number);
  return out;
}

}  // namespace fccda
