#include "fccda/surface/connect.hpp"

#include <algorithm>
#include <cstdint>
#include <span>
#include <sstream>
#include <vector>

#include "fccda/core/error.hpp"

namespace fccda {
namespace {

struct Side {
  std::uint64_t edge;  // lower vertex, higher vertex
  int triangle, e;
  friend bool operator<(const Side& a, const Side& b) { return a.edge != b.edge ? a.edge < b.edge : a.triangle < b.triangle; }
};

std::vector<Side> sorted_sides(const std::vector<Triangle>& triangles) {
  std::vector<Side> sides;
  sides.reserve(3 * triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (std::size_t e = 0; e < 3; ++e) {
      const auto [low, high] = std::minmax(triangles[t].vertex[e], triangles[t].vertex[(e + 1) % 3]);
      sides.push_back({static_cast<std::uint64_t>(low) << 32 | static_cast<std::uint64_t>(high), static_cast<int>(t), static_cast<int>(e)});
    }
  }
  std::sort(sides.begin(), sides.end());
  return sides;
}

[[noreturn]] void refuse(std::size_t edges, std::span<const Side> first, const LinkedTriangles& surface, const std::string& name) {
  const Vec3d& from = surface.vertices[first[0].edge >> 32];
  const Vec3d& to = surface.vertices[first[0].edge & 0xffffffffu];
  std::ostringstream sentence;
  sentence << name << ": the surface is non-manifold: " << edges << (edges == 1 ? " edge has" : " edges have") << " more than two panels, the first from ("
           << from.x << ", " << from.y << ", " << from.z << ") to (" << to.x << ", " << to.y << ", " << to.z << ") m with the panels ";
  constexpr std::size_t most = 6;  // so that a fan of thousands stays one sentence
  for (std::size_t s = 0; s < std::min(first.size(), most); ++s)
    sentence << (s > 0 ? ", " : "") << surface.triangles[static_cast<std::size_t>(first[s].triangle)].panel;
  sentence << (first.size() > most ? ", …" : "") << " (counted from 0); delete inner walls, and move apart parts that touch along an edge.";
  throw InputError(sentence.str());
}

}  // namespace

std::size_t connect(LinkedTriangles& surface, const std::string& name) {
  surface.neighbours.assign(surface.triangles.size(), {-1, -1, -1});
  const std::vector<Side> sides = sorted_sides(surface.triangles);
  std::size_t rim_edges = 0, crowded = 0;
  std::span<const Side> first_crowded;
  for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
    while (end < sides.size() && sides[end].edge == sides[begin].edge) ++end;
    const std::size_t count = end - begin;
    if (count == 1) {
      ++rim_edges;
    } else if (count == 2) {
      const Side& a = sides[begin];
      const Side& b = sides[begin + 1];
      surface.neighbours[static_cast<std::size_t>(a.triangle)][static_cast<std::size_t>(a.e)] = b.triangle;
      surface.neighbours[static_cast<std::size_t>(b.triangle)][static_cast<std::size_t>(b.e)] = a.triangle;
    } else if (crowded++ == 0) {
      first_crowded = std::span(sides).subspan(begin, count);
    }
  }
  if (crowded > 0) refuse(crowded, first_crowded, surface, name);
  return rim_edges;
}

}  // namespace fccda
