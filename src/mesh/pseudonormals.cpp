#include "mesh/pseudonormals.hpp"

#include <cmath>
#include <numeric>

namespace fccda {
namespace {

/// A sum of normals shorter than this is rounding error, without a meaningful direction.
constexpr double cancelled = 1e-8;

double angle_between(const Vec3d& a, const Vec3d& b) { return std::atan2(norm(cross(a, b)), dot(a, b)); }

Vec3d face_normal(const LinkedTriangles& surface, std::size_t t) {
  return normalised(cross(surface.corner(t, 1) - surface.corner(t, 0), surface.corner(t, 2) - surface.corner(t, 0)));
}

/// `face(t)`: the normal of triangle t.
template <class Face>
Vec3d edge_normal(const LinkedTriangles& surface, const Face& face, std::size_t t, std::size_t e) {
  const int beyond = surface.neighbours[t][e];
  const Vec3d own = face(t);
  if (beyond < 0) return own;
  const Vec3d sum = own + face(static_cast<std::size_t>(beyond));
  if (norm(sum) > cancelled) return normalised(sum);
  return normalised(cross(surface.corner(t, (e + 1) % 3) - surface.corner(t, e), own));
}

double angle_at(const LinkedTriangles& surface, std::size_t t, std::size_t c) {
  const Vec3d& corner = surface.corner(t, c);
  return angle_between(surface.corner(t, (c + 1) % 3) - corner, surface.corner(t, (c + 2) % 3) - corner);
}

/// `edges`: the sum over the edges, for vertices whose faces cancel.
Vec3d vertex_normal(const Vec3d& faces, const Vec3d& edges) { return normalised(norm(faces) > cancelled ? faces : edges); }

Vec3d vertex_normal(const LinkedTriangles& surface, const IncidentTriangles& incident, int vertex) {
  const auto face = [&](std::size_t t) { return face_normal(surface, t); };
  Vec3d faces{}, edges{};
  const auto v = static_cast<std::size_t>(vertex);
  for (std::int32_t k = incident.begin[v]; k < incident.begin[v + 1]; ++k) {
    const auto t = static_cast<std::size_t>(incident.triangles[static_cast<std::size_t>(k)]);
    for (std::size_t c = 0; c < 3; ++c) {
      if (surface.triangles[t].vertex[c] != vertex) continue;
      faces += angle_at(surface, t, c) * face(t);
      edges += edge_normal(surface, face, t, c) + edge_normal(surface, face, t, (c + 2) % 3);
    }
  }
  return vertex_normal(faces, edges);
}

}  // namespace

Pseudonormals pseudonormals(const LinkedTriangles& surface) {
  const std::size_t count = surface.triangles.size();
  Pseudonormals out;
  out.faces.resize(count);
  out.edges.resize(count);
  out.vertices.resize(surface.vertices.size());

  for (std::size_t t = 0; t < count; ++t) out.faces[t] = face_normal(surface, t);
  const auto face = [&](std::size_t t) { return out.faces[t]; };
  for (std::size_t t = 0; t < count; ++t) {
    for (std::size_t e = 0; e < 3; ++e) out.edges[t][e] = edge_normal(surface, face, t, e);
  }
  std::vector<Vec3d> edge_sums(surface.vertices.size());
  for (std::size_t t = 0; t < count; ++t) {
    for (std::size_t c = 0; c < 3; ++c) {
      const auto vertex = static_cast<std::size_t>(surface.triangles[t].vertex[c]);
      out.vertices[vertex] += angle_at(surface, t, c) * out.faces[t];
      edge_sums[vertex] += out.edges[t][c] + out.edges[t][(c + 2) % 3];
    }
  }
  for (std::size_t v = 0; v < out.vertices.size(); ++v) out.vertices[v] = vertex_normal(out.vertices[v], edge_sums[v]);
  return out;
}

IncidentTriangles incident_triangles(const LinkedTriangles& surface) {
  IncidentTriangles out;
  out.begin.assign(surface.vertices.size() + 1, 0);
  for (const Triangle& triangle : surface.triangles)
    for (const int vertex : triangle.vertex) ++out.begin[static_cast<std::size_t>(vertex) + 1];
  std::partial_sum(out.begin.begin(), out.begin.end(), out.begin.begin());
  out.triangles.resize(3 * surface.triangles.size());
  std::vector<std::int32_t> next(out.begin.begin(), out.begin.end() - 1);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    for (const int vertex : surface.triangles[t].vertex)
      out.triangles[static_cast<std::size_t>(next[static_cast<std::size_t>(vertex)]++)] = static_cast<std::int32_t>(t);
  return out;
}

Vec3d pseudonormal(const LinkedTriangles& surface, const IncidentTriangles& incident, std::size_t triangle, Feature feature) {
  const auto f = static_cast<std::size_t>(feature);
  if (feature == Feature::face) return face_normal(surface, triangle);
  if (feature > Feature::edge_2) return vertex_normal(surface, incident, surface.triangles[triangle].vertex[f - 4]);
  return edge_normal(
      surface, [&](std::size_t t) { return face_normal(surface, t); }, triangle, f - 1);
}

}  // namespace fccda
