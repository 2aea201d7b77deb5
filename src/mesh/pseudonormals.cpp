#include "mesh/pseudonormals.hpp"

#include <cmath>

namespace fccda {
namespace {

/// A sum of normals shorter than this is rounding error, without a meaningful direction.
constexpr double cancelled = 1e-8;

double angle_between(const Vec3d& a, const Vec3d& b) { return std::atan2(norm(cross(a, b)), dot(a, b)); }

Vec3d edge_normal(const LinkedTriangles& surface, const std::vector<Vec3d>& faces, std::size_t t, std::size_t e) {
  const int beyond = surface.neighbours[t][e];
  if (beyond < 0) return faces[t];
  const Vec3d sum = faces[t] + faces[static_cast<std::size_t>(beyond)];
  if (norm(sum) > cancelled) return normalised(sum);
  return normalised(cross(surface.corner(t, (e + 1) % 3) - surface.corner(t, e), faces[t]));
}

}  // namespace

Pseudonormals pseudonormals(const LinkedTriangles& surface) {
  const std::size_t count = surface.triangles.size();
  Pseudonormals out;
  out.faces.resize(count);
  out.edges.resize(count);
  out.vertices.resize(surface.vertices.size());

  for (std::size_t t = 0; t < count; ++t) {
    out.faces[t] = normalised(cross(surface.corner(t, 1) - surface.corner(t, 0), surface.corner(t, 2) - surface.corner(t, 0)));
  }
  for (std::size_t t = 0; t < count; ++t) {
    for (std::size_t e = 0; e < 3; ++e) out.edges[t][e] = edge_normal(surface, out.faces, t, e);
  }
  std::vector<Vec3d> edge_sums(surface.vertices.size());  // for vertices whose faces cancel
  for (std::size_t t = 0; t < count; ++t) {
    for (std::size_t c = 0; c < 3; ++c) {
      const auto vertex = static_cast<std::size_t>(surface.triangles[t].vertex[c]);
      const Vec3d& corner = surface.corner(t, c);
      out.vertices[vertex] += angle_between(surface.corner(t, (c + 1) % 3) - corner, surface.corner(t, (c + 2) % 3) - corner) * out.faces[t];
      edge_sums[vertex] += out.edges[t][c] + out.edges[t][(c + 2) % 3];
    }
  }
  for (std::size_t v = 0; v < out.vertices.size(); ++v) out.vertices[v] = normalised(norm(out.vertices[v]) > cancelled ? out.vertices[v] : edge_sums[v]);
  return out;
}

}  // namespace fccda
