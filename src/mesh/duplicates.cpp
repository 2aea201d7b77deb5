#include "mesh/duplicates.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

namespace fccda {
namespace {

constexpr double largest_fin = 1e-3;  // as a fraction of the surface's area

struct Key {
  std::array<int, 3> sorted;
  int triangle;
  bool is_even;  // the permutation from `sorted`
  friend bool operator<(const Key& a, const Key& b) { return std::pair(a.sorted, a.triangle) < std::pair(b.sorted, b.triangle); }
};

std::vector<Key> sorted_keys(const std::vector<Triangle>& triangles) {
  std::vector<Key> keys(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const auto& v = triangles[t].vertex;
    const auto lowest = static_cast<std::size_t>(std::min_element(v.begin(), v.end()) - v.begin());
    const int second = v[(lowest + 1) % 3], third = v[(lowest + 2) % 3];
    keys[t] = {{v[lowest], std::min(second, third), std::max(second, third)}, static_cast<int>(t), second < third};
  }
  std::sort(keys.begin(), keys.end());
  return keys;
}

/// Two coincident triangles of opposite winding: the first and its partner.
struct Pair {
  int triangle, partner;
};

/// Decides which pairs are removed, by patches connected over edges.
class Patches {
 public:
  Patches(const std::vector<Triangle>& triangles, std::span<const Vec3d> vertices, const std::vector<std::uint8_t>& left_out, const std::vector<Pair>& pairs)
      : triangles_(triangles), vertices_(vertices), pairs_(pairs) {
    std::vector<bool> is_paired(triangles.size(), false);
    for (const Pair& pair : pairs) is_paired[index(pair.triangle)] = is_paired[index(pair.partner)] = true;
    for (std::size_t p = 0; p < pairs.size(); ++p) add_sides(pairs[p].triangle, static_cast<int>(p));
    std::sort(sides_.begin(), sides_.end());
    others_.assign(sides_.size(), 0);
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      if (left_out[t] != 0) continue;
      area_ += area(t);
      if (!is_paired[t]) note_others(t);
    }
  }

  /// For each pair, whether both triangles are removed.
  std::vector<bool> to_remove() const {
    std::vector<bool> removed(pairs_.size(), false), seen(pairs_.size(), false);
    for (std::size_t first = 0; first < pairs_.size(); ++first) {
      if (seen[first]) continue;
      std::vector<std::size_t> patch{first};
      seen[first] = true;
      bool has_free_end = false, is_connected = false, would_leave_a_hole = false;
      double patch_area = 0;
      for (std::size_t next = 0; next < patch.size(); ++next) {
        const Triangle& triangle = triangles_[index(pairs_[patch[next]].triangle)];
        patch_area += area(index(pairs_[patch[next]].triangle));
        for (std::size_t e = 0; e < 3; ++e) {
          const auto [begin, end] = sides_of(edge(triangle, e));
          is_connected |= others_[begin] > 0;
          would_leave_a_hole |= others_[begin] == 1;
          has_free_end |= others_[begin] == 0 && end - begin == 1;
          for (std::size_t s = begin; s < end; ++s) {
            const std::size_t pair = index(sides_[s].pair);
            if (seen[pair]) continue;
            seen[pair] = true;
            patch.push_back(pair);
          }
        }
      }
      if (!is_connected || would_leave_a_hole || (has_free_end && patch_area > largest_fin * area_)) continue;
      for (const std::size_t pair : patch) removed[pair] = true;
    }
    return removed;
  }

 private:
  using Edge = std::pair<int, int>;
  struct Side {
    Edge edge;
    int pair;
    friend auto operator<=>(const Side&, const Side&) = default;
  };

  static std::size_t index(int i) { return static_cast<std::size_t>(i); }
  static Edge edge(const Triangle& triangle, std::size_t e) { return std::minmax(triangle.vertex[e], triangle.vertex[(e + 1) % 3]); }

  double area(std::size_t t) const {
    const auto& v = triangles_[t].vertex;
    const Vec3d& a = vertices_[index(v[0])];
    return 0.5 * norm(cross(vertices_[index(v[1])] - a, vertices_[index(v[2])] - a));
  }

  void add_sides(int triangle, int pair) {
    for (std::size_t e = 0; e < 3; ++e) sides_.push_back({edge(triangles_[index(triangle)], e), pair});
  }

  std::pair<std::size_t, std::size_t> sides_of(const Edge& edge) const {
    const auto begin = std::lower_bound(sides_.begin(), sides_.end(), Side{edge, -1});
    auto end = begin;
    while (end != sides_.end() && end->edge == edge) ++end;
    return {static_cast<std::size_t>(begin - sides_.begin()), static_cast<std::size_t>(end - sides_.begin())};
  }

  void note_others(std::size_t t) {
    for (std::size_t e = 0; e < 3; ++e) {
      const auto [begin, end] = sides_of(edge(triangles_[t], e));
      if (begin != end) ++others_[begin];
    }
  }

  const std::vector<Triangle>& triangles_;
  std::span<const Vec3d> vertices_;
  const std::vector<Pair>& pairs_;
  std::vector<Side> sides_;  // of the pairs
  std::vector<int> others_;  // at the first side on each edge: how many triangles outside all pairs meet there
  double area_ = 0;
};

}  // namespace

Duplicates drop_duplicates(std::vector<Triangle>& triangles, std::span<const Vec3d> vertices) {
  const std::vector<Key> keys = sorted_keys(triangles);
  Duplicates out;
  std::vector<std::uint8_t> left_out(triangles.size(), 0);
  std::vector<Pair> pairs;
  for (std::size_t begin = 0, end = 0; begin < keys.size(); begin = end) {
    int partner = -1;
    for (end = begin + 1; end < keys.size() && keys[end].sorted == keys[begin].sorted; ++end) {
      if (partner < 0 && keys[end].is_even != keys[begin].is_even) {
        partner = keys[end].triangle;
      } else {
        left_out[static_cast<std::size_t>(keys[end].triangle)] = 1;
        ++out.repeated;
      }
    }
    if (partner >= 0) pairs.push_back({keys[begin].triangle, partner});
  }
  if (!pairs.empty()) {
    const std::vector<bool> removed = Patches(triangles, vertices, left_out, pairs).to_remove();
    for (std::size_t p = 0; p < pairs.size(); ++p) {
      left_out[static_cast<std::size_t>(pairs[p].partner)] = 1;
      if (removed[p]) left_out[static_cast<std::size_t>(pairs[p].triangle)] = 1;
      removed[p] ? out.back_to_back += 2 : ++out.repeated;
    }
  }
  std::size_t kept = 0;
  for (std::size_t t = 0; t < triangles.size(); ++t)
    if (left_out[t] == 0) triangles[kept++] = triangles[t];
  triangles.resize(kept);
  return out;
}

}  // namespace fccda
