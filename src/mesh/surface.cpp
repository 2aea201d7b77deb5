#include "mesh/surface.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>

#include "base/contract.hpp"
#include "base/error.hpp"
#include "mesh/connect.hpp"
#include "mesh/defects.hpp"
#include "mesh/fans.hpp"
#include "mesh/mass_properties.hpp"
#include "mesh/overlaps.hpp"
#include "mesh/triangulate.hpp"
#include "mesh/weld.hpp"
#include "mesh/winding.hpp"

namespace fccda {
namespace {

void expect_distance(double distance, const std::string& name, const std::string& what) {
  if (distance >= 0 && std::isfinite(distance)) return;
  std::ostringstream sentence;
  sentence << name << ": the " << what << " is " << distance << ", but it must be a finite number of at least 0; 0 merges coincident vertices only.";
  throw InputError(sentence.str());
}

/// Rejects input that no later stage can process.
void expect_usable(const Panels& panels, const std::string& name) {
  if (panels.panels.empty()) throw InputError(name + ": the surface has no panels; check that the file or shape is the right one.");
  // Triangles, up to twice as many, have three sides each, which are numbered by int.
  if (panels.panels.size() > std::numeric_limits<int>::max() / 6) {
    throw InputError(name + ": " + std::to_string(panels.panels.size()) + " panels are too many; use larger ones.");
  }
  const auto vertex_count = static_cast<long long>(panels.vertices.size());
  for (std::size_t p = 0; p < panels.panels.size(); ++p) {
    for (std::size_t c = 0; c < 4; ++c) {
      const int vertex = panels.panels[p][c];
      if ((vertex >= 0 && vertex < vertex_count) || (c == 3 && vertex == -1)) continue;
      throw InputError(name + ": panel " + std::to_string(p) + " has the vertex " + std::to_string(vertex) + ", but there are only the vertices 0 to " +
                       std::to_string(vertex_count - 1) + "; correct the vertex numbers.");
    }
  }
  const bool has_parts = !panels.part.empty() || !panels.part_names.empty();
  if (has_parts && panels.part.size() != panels.panels.size()) {
    throw InputError(name + ": " + std::to_string(panels.part.size()) + " of the " + std::to_string(panels.panels.size()) +
                     " panels have a part; give one to each, or to none.");
  }
  const auto part_count = static_cast<long long>(panels.part_names.size());
  for (std::size_t p = 0; p < panels.part.size(); ++p) {
    if (panels.part[p] >= 0 && panels.part[p] < part_count) continue;
    throw InputError(name + ": panel " + std::to_string(p) + " belongs to part " + std::to_string(panels.part[p]) + ", but there are names of " +
                     std::to_string(part_count) + " parts only; correct the part numbers.");
  }
  // Inertia contains the fifth power of lengths, which must not overflow.
  constexpr double largest = 1e50;
  for (std::size_t v = 0; v < panels.vertices.size(); ++v) {
    if (is_finite(panels.vertices[v]) && largest_magnitude(panels.vertices[v]) < largest) continue;
    std::ostringstream place;  // at most six digits
    place << '(' << panels.vertices[v].x << ", " << panels.vertices[v].y << ", " << panels.vertices[v].z << ')';
    throw InputError(name + ": vertex " + std::to_string(v) + " (counted from 0) is at " + place.str() +
                     ", which is not finite or out of range; each coordinate must be a finite number of metres.");
  }
}

[[noreturn]] void refuse_non_manifold(const Unjoined& unjoined, const LinkedTriangles& surface, const std::string& name) {
  const std::vector<NonManifoldEdge>& non_manifold_edges = unjoined.edges;
  const Vec3d& from = surface.vertices[static_cast<std::size_t>(non_manifold_edges[0].vertices[0])];
  const Vec3d& to = surface.vertices[static_cast<std::size_t>(non_manifold_edges[0].vertices[1])];
  std::ostringstream sentence;
  sentence << name << ": the surface is non-manifold: " << non_manifold_edges.size() << (non_manifold_edges.size() == 1 ? " edge has" : " edges have")
           << " more than two panels, the first from (" << from.x << ", " << from.y << ", " << from.z << ") to (" << to.x << ", " << to.y << ", " << to.z
           << ") m with the panels ";
  const std::vector<int> first = panels_of(surface.triangles, non_manifold_edges[0].triangles);  // once, even if both halves of a quad end there
  constexpr std::size_t most = 6;                                                                // keeps the sentence readable for large fans
  for (std::size_t s = 0; s < std::min(first.size(), most); ++s) sentence << (s > 0 ? ", " : "") << first[s];
  sentence << (first.size() > most ? ", …" : "")
           << " (counted from 0), so their connection is ambiguous; delete inner walls, or use it as an open surface that is cut along these edges, {}.";
  throw SurfaceError(sentence.str(), {DefectKind::non_manifold, panels_of(surface.triangles, unjoined.triangles)}, Advice::cut_open);
}

Box bounds_of_used(const Panels& panels) {
  Box box;
  for (const auto& panel : panels.panels) {
    for (const int vertex : panel) {
      if (vertex >= 0) box.include(panels.vertices[static_cast<std::size_t>(vertex)]);
    }
  }
  return box;
}

void measure(const LinkedTriangles& surface, SurfaceReport& report) {
  double shortest = std::numeric_limits<double>::infinity(), longest = 0;  // squared
  Vec3d centroid{};
  for (const Vec3d& vertex : surface.vertices) report.bounds.include(vertex);
  const Vec3d middle = report.bounds.centre();
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const Vec3d a = surface.corner(t, 0) - middle, b = surface.corner(t, 1) - middle, c = surface.corner(t, 2) - middle;
    const double area = 0.5 * norm(cross(b - a, c - a));
    report.area += area;
    centroid += area / 3 * (a + b + c);
    for (const double side : {squared_norm(b - a), squared_norm(c - b), squared_norm(a - c)}) {
      shortest = std::min(shortest, side);
      longest = std::max(longest, side);
    }
  }
  report.shortest_edge = std::sqrt(shortest);
  report.longest_edge = std::sqrt(longest);
  report.centroid = middle + centroid / report.area;
  if (report.closure == Closure::open) return;
  const MassProperties mass = mass_properties(surface);
  report.volume = mass.volume;
  report.centroid = mass.centroid;
  report.inertia_diagonal = mass.inertia_diagonal;
  report.inertia_products = mass.inertia_products;
}

}  // namespace

Surface::Surface(const Panels& panels, const Options& options) : panels_(panels), part_names_(panels.part_names) {
  expect_usable(panels, options.name);
  expect_distance(options.weld_distance, options.name, "weld distance");
  expect_distance(options.weld_tolerance, options.name, "weld tolerance");
  const double tolerance = options.weld_tolerance * norm(bounds_of_used(panels).size());
  report_.panels = panels.panels.size();
  if (part_names_.empty()) part_names_.emplace_back();

  Welded welded = weld(panels, std::max(tolerance, options.weld_distance));
  report_.welded = welded.merged;

  Triangulation triangulation = triangulate(welded.panels, tolerance);
  report_.degenerate = triangulation.degenerate;
  report_.duplicate = triangulation.duplicate;
  report_.back_to_back = triangulation.back_to_back;
  if (triangulation.triangles.empty()) {
    throw InputError(options.name + ": none of the " + std::to_string(report_.panels) + " panels has an area; check the file's scale and its coordinates.");
  }
  linked_ = {std::move(welded.panels.vertices), std::move(triangulation.triangles), {}};

  const Components components = build_components(options);
  report_.components = components.count;

  const Outward outward = orient_outward(linked_, components, options.orientation, options.name);
  report_.flipped = outward.flipped;
  report_.cavities = outward.cavities;
  report_.may_overlap = components_that_may_overlap(linked_, components);
  std::vector<int> number(components.count, -1);  // of the solids, in the order of their components
  for (std::size_t c = 0; c < components.count; ++c)
    if (outward.solid_of_component[c] == static_cast<int>(c)) number[c] = static_cast<int>(report_.solids++);
  for (const int component : components.of_triangle)
    solid_of_.push_back(number[static_cast<std::size_t>(outward.solid_of_component[static_cast<std::size_t>(component)])]);

  FanVertices fans = separate_fans(linked_);
  boundary_vertices_ = std::move(fans.on_rim);
  welded_to_ = std::move(welded.new_number), welded_from_ = std::move(fans.former);
  report_.triangles = linked_.triangles.size();
  report_.vertices = linked_.vertices.size();

  normals_ = pseudonormals(linked_);
  measure(linked_, report_);
  measure_parts();
}

Components Surface::build_components(const Options& options) {
  const Connection connection = connect(linked_);
  report_.boundary_edges = connection.boundary_edges;
  report_.non_manifold_edge_count = connection.non_manifold_edges.size();
  Components components = orient_consistently(linked_, options.name);
  report_.rewound = components.rewound;
  if (!connection.non_manifold_edges.empty()) {
    const Unjoined cut = join_non_manifold(linked_, connection.non_manifold_edges, options.orientation == Orientation::reversed);
    if (!cut.edges.empty() && options.orientation == Orientation::undeclared) refuse_non_manifold(cut, linked_, options.name);
    report_.cut_edges = cut.edges.size();
    report_.boundary_edges += cut.triangles.size();
    components = orient_consistently(linked_, options.name);
  }
  report_.closure = report_.boundary_edges > 0 ? Closure::open : Closure::closed;
  return components;
}

void Surface::measure_parts() {
  for (const std::string& part : part_names_) report_.parts.push_back({.name = part});
  const auto of_panel = [&](std::size_t panel) -> PartReport& { return report_.parts[static_cast<std::size_t>(part_of_panel(static_cast<int>(panel)))]; };
  for (std::size_t p = 0; p < panels_.panels.size(); ++p) ++of_panel(p).panels;
  for (std::size_t t = 0; t < linked_.triangles.size(); ++t) {
    const Vec3d& a = corner(t, 0);
    of_panel(static_cast<std::size_t>(linked_.triangles[t].panel)).area += 0.5 * norm(cross(corner(t, 1) - a, corner(t, 2) - a));
  }
}

Vec3d Surface::pseudonormal(std::size_t triangle, Feature feature) const {
  EXPECTS(triangle < linked_.triangles.size());
  if (normals_.faces.empty()) return fccda::pseudonormal(linked_, incident_, triangle, feature);
  const auto f = static_cast<std::size_t>(feature);
  if (feature == Feature::face) return normals_.faces[triangle];
  if (feature <= Feature::edge_2) return normals_.edges[triangle][f - 1];
  return normals_.vertices[static_cast<std::size_t>(linked_.triangles[triangle].vertex[f - 4])];
}

bool Surface::is_boundary_edge(std::size_t triangle, Feature feature) const {
  EXPECTS(triangle < linked_.triangles.size());
  const auto f = static_cast<std::size_t>(feature);
  if (feature == Feature::face) return false;
  if (feature <= Feature::edge_2) return linked_.neighbours[triangle][f - 1] < 0;
  return boundary_vertices_[static_cast<std::size_t>(linked_.triangles[triangle].vertex[f - 4])];
}

void Surface::displace(std::span<const Vec3d> vertices) {
  EXPECTS(vertices.size() == linked_.vertices.size());
  if (incident_.begin.empty()) incident_ = incident_triangles(linked_);
  normals_ = {};
  std::copy(vertices.begin(), vertices.end(), linked_.vertices.begin());
  report_.bounds = {};
  for (const Vec3d& vertex : vertices) report_.bounds.include(vertex);
}

double Surface::radius_about(const Vec3d& point) const {
  double squared = 0;
  for (const Vec3d& vertex : linked_.vertices) squared = std::max(squared, squared_norm(vertex - point));
  return std::sqrt(squared);
}

}  // namespace fccda
