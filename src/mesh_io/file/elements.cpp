#include "mesh_io/file/elements.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "base/contract.hpp"
#include "base/error.hpp"
#include "mesh/add_polygon.hpp"
#include "mesh/part_naming.hpp"

namespace fccda {
namespace {

constexpr int none = -1;
using Face = std::array<int, 4>;  // of three corners, or four
using Edge = std::array<int, 2>;

/// Topology of a solid by corner number: corners, edges with a mid-side node (in the order of those nodes) and faces.
struct Solid {
  std::size_t corners;
  std::span<const Edge> edges;
  std::span<const Face> faces;
};

constexpr Edge tetrahedron_edges[] = {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}};
constexpr Face tetrahedron_faces[] = {{0, 1, 2, none}, {0, 1, 3, none}, {1, 2, 3, none}, {2, 0, 3, none}};
constexpr Edge pyramid_edges[] = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 4}, {1, 4}, {2, 4}, {3, 4}};
constexpr Face pyramid_faces[] = {{0, 1, 2, 3}, {0, 1, 4, none}, {1, 2, 4, none}, {2, 3, 4, none}, {3, 0, 4, none}};
constexpr Edge wedge_edges[] = {{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {5, 3}, {0, 3}, {1, 4}, {2, 5}};
constexpr Face wedge_faces[] = {{0, 1, 2, none}, {3, 4, 5, none}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}};
constexpr Edge hexahedron_edges[] = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}};
constexpr Face hexahedron_faces[] = {{0, 1, 2, 3}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};

Solid solid_of(ElementKind kind) {
  switch (kind) {
    case ElementKind::tetrahedron:
      return {4, {}, tetrahedron_faces};
    case ElementKind::tetrahedron_10:
      return {4, tetrahedron_edges, tetrahedron_faces};
    case ElementKind::pyramid:
      return {5, {}, pyramid_faces};
    case ElementKind::pyramid_13:
      return {5, pyramid_edges, pyramid_faces};
    case ElementKind::wedge:
      return {6, {}, wedge_faces};
    case ElementKind::wedge_15:
      return {6, wedge_edges, wedge_faces};
    case ElementKind::hexahedron:
      return {8, {}, hexahedron_faces};
    default:
      return {8, hexahedron_edges, hexahedron_faces};
  }
}

std::size_t corners_of_surface(ElementKind kind, std::size_t nodes) {
  switch (kind) {
    case ElementKind::polygon:
      return nodes;
    case ElementKind::triangle_6:
      return 3;
    default:
      return 4;
  }
}

/// A face of a solid, or a surface element of three or four corners (`face` empty), identified by its corners in any order.
struct Cover {
  std::array<int, 4> sorted;
  std::size_t element;
  int face;
  friend auto operator<=>(const Cover&, const Cover&) = default;
};

Cover cover(std::span<const int> corners, std::size_t element, int face) {
  Cover out{{none, none, none, none}, element, face};
  std::copy(corners.begin(), corners.end(), out.sorted.begin());
  std::sort(out.sorted.begin(), out.sorted.end());
  return out;
}

class Skin {
 public:
  Skin(Elements elements, const std::string& file) : in_(std::move(elements)), file_(file) { out_.vertices = std::move(in_.vertices); }

  Panels panels() {
    const std::vector<Cover> kept = seen_from_outside();
    auto next = kept.begin();
    for (std::size_t e = 0; e < in_.size(); ++e) {
      if (e == 0 || in_.part[e] != in_.part[e - 1]) parts_.begin(in_.part_names[static_cast<std::size_t>(in_.part[e])]);
      if (is_solid(in_.kinds[e]) || takes_part(e)) {
        for (; next != kept.end() && next->element == e; ++next) next->face == none ? add_surface(e) : add_face(e, static_cast<std::size_t>(next->face));
      } else {
        add_surface(e);
      }
    }
    parts_.finish();
    return std::move(out_);
  }

 private:
  /// Whether a face of a solid can have the corners of this surface element.
  bool takes_part(std::size_t e) const { return has_solids_ && corners_of_surface(in_.kinds[e], in_.nodes_of_element(e).size()) <= 4; }

  /// The boundary faces: of all faces and surface elements with equal corners, those on the outer surface, in the order of the elements.
  std::vector<Cover> seen_from_outside() {
    has_solids_ = std::any_of(in_.kinds.begin(), in_.kinds.end(), is_solid);
    std::vector<Cover> covers;
    for (std::size_t e = 0; e < in_.size(); ++e) {
      const std::span<const int> nodes = in_.nodes_of_element(e);
      if (!is_solid(in_.kinds[e])) {
        if (takes_part(e)) covers.push_back(cover(nodes.first(corners_of_surface(in_.kinds[e], nodes.size())), e, none));
        continue;
      }
      const Solid solid = solid_of(in_.kinds[e]);
      for (std::size_t f = 0; f < solid.faces.size(); ++f) {
        const auto [corners, count] = corners_of(solid.faces[f], nodes);
        covers.push_back(cover(std::span(corners).first(count), e, static_cast<int>(f)));
      }
    }
    std::sort(covers.begin(), covers.end());
    auto kept = covers.begin();
    for (auto begin = covers.begin(), end = begin; begin != covers.end(); begin = end) {
      end = std::find_if(begin, covers.end(), [&](const Cover& c) { return c.sorted != begin->sorted; });
      const auto faces = std::count_if(begin, end, [](const Cover& c) { return c.face != none; });
      if (faces > 2) {
        throw InputError(file_ + ": " + std::to_string(faces) + " solid elements share one face, the first of them element " +
                         std::to_string(begin->element + 1) + " in file order; elements must not overlap, so repair the mesh.");
      }
      if (faces == 2) continue;
      const bool is_covered = faces < end - begin;
      kept = std::copy_if(begin, end, kept, [&](const Cover& c) { return c.face == none || !is_covered; });
    }
    covers.erase(kept, covers.end());
    std::sort(covers.begin(), covers.end(), [](const Cover& a, const Cover& b) { return std::pair(a.element, a.face) < std::pair(b.element, b.face); });
    return covers;
  }

  static std::pair<std::array<int, 4>, std::size_t> corners_of(const Face& face, std::span<const int> nodes) {
    std::array<int, 4> corners{none, none, none, none};
    std::size_t count = 0;
    for (const int corner : face)
      if (corner != none) corners[count++] = nodes[static_cast<std::size_t>(corner)];
    return {corners, count};
  }

  const Vec3d& at(int vertex) const { return out_.vertices[static_cast<std::size_t>(vertex)]; }

  void add_surface(std::size_t e) {
    const std::span<const int> n = in_.nodes_of_element(e);
    switch (in_.kinds[e]) {
      case ElementKind::triangle_6:
        return add_triangle_6({n[0], n[1], n[2]}, {n[3], n[4], n[5]});
      case ElementKind::quad_8:
        return add_quad_8({n[0], n[1], n[2], n[3]}, {n[4], n[5], n[6], n[7]});
      case ElementKind::quad_9:
        for (std::size_t k = 0; k < 4; ++k) out_.add_quad(n[k], n[4 + k], n[8], n[4 + (k + 3) % 4]);
        return;
      default:
        if (add_polygon(out_, n)) return;
        throw InputError(file_ + ": element " + std::to_string(e + 1) + " in file order, a polygon with " + std::to_string(n.size()) +
                         " corners, cannot be triangulated because its sides cross; triangulate the mesh before exporting it.");
    }
  }

  void add_triangle_6(const std::array<int, 3>& corners, const std::array<int, 3>& middles) {
    for (std::size_t k = 0; k < 3; ++k) out_.add_triangle(corners[k], middles[k], middles[(k + 2) % 3]);
    out_.add_triangle(middles[0], middles[1], middles[2]);
  }

  void add_quad_8(const std::array<int, 4>& corners, const std::array<int, 4>& middles) {
    for (std::size_t k = 0; k < 4; ++k) out_.add_triangle(corners[k], middles[k], middles[(k + 3) % 4]);
    out_.add_quad(middles[0], middles[1], middles[2], middles[3]);
  }

  void add_face(std::size_t e, std::size_t f) {
    const Solid solid = solid_of(in_.kinds[e]);
    const std::span<const int> nodes = in_.nodes_of_element(e);
    Face face = solid.faces[f];
    const std::size_t count = face[3] == none ? 3 : 4;
    if (faces_inward(nodes.first(solid.corners), face, count)) std::reverse(face.begin(), face.begin() + static_cast<std::ptrdiff_t>(count));
    const std::array<int, 4> corners = corners_of(face, nodes).first;
    if (solid.edges.empty())
      return count == 3 ? out_.add_triangle(corners[0], corners[1], corners[2]) : out_.add_quad(corners[0], corners[1], corners[2], corners[3]);
    std::array<int, 4> middles{};
    for (std::size_t k = 0; k < count; ++k) {
      const int from = face[k], to = face[(k + 1) % count];
      const auto edge = std::find_if(solid.edges.begin(), solid.edges.end(), [&](const Edge& one) { return one == Edge{from, to} || one == Edge{to, from}; });
      middles[k] = nodes[solid.corners + static_cast<std::size_t>(edge - solid.edges.begin())];
    }
    count == 3 ? add_triangle_6({corners[0], corners[1], corners[2]}, {middles[0], middles[1], middles[2]}) : add_quad_8(corners, middles);
  }

  bool faces_inward(std::span<const int> corners, const Face& face, std::size_t count) const {
    const auto corner = [&](std::size_t k) -> const Vec3d& { return at(corners[static_cast<std::size_t>(face[k % count])]); };
    Vec3d centre{}, middle{}, normal{};
    for (const int c : corners) centre += at(c) / static_cast<double>(corners.size());
    for (std::size_t k = 0; k < count; ++k) middle += corner(k) / static_cast<double>(count);
    for (std::size_t k = 0; k < count; ++k) normal += cross(corner(k) - middle, corner(k + 1) - middle);
    return dot(normal, middle - centre) < 0;
  }

  Elements in_;
  const std::string& file_;
  Panels out_;
  PartNaming parts_{out_};
  bool has_solids_ = false;
};

}  // namespace

bool is_solid(ElementKind kind) { return kind >= ElementKind::tetrahedron; }

std::size_t corners_of(ElementKind kind, std::size_t nodes) { return is_solid(kind) ? solid_of(kind).corners : corners_of_surface(kind, nodes); }

std::span<const std::array<int, 4>> faces_of(ElementKind kind) { return solid_of(kind).faces; }

std::size_t nodes_of(ElementKind kind) {
  switch (kind) {
    case ElementKind::polygon:
      return 0;
    case ElementKind::triangle_6:
      return 6;
    case ElementKind::quad_8:
      return 8;
    case ElementKind::quad_9:
      return 9;
    default: {
      const Solid solid = solid_of(kind);
      return solid.corners + solid.edges.size();
    }
  }
}

void Elements::add(ElementKind kind, std::span<const int> element_nodes, int part_of_element) {
  EXPECTS(kind == ElementKind::polygon || element_nodes.size() == nodes_of(kind));
  kinds.push_back(kind);
  nodes.insert(nodes.end(), element_nodes.begin(), element_nodes.end());
  ends.push_back(nodes.size());
  part.push_back(part_of_element);
}

int Elements::part_number(const std::string& name) {
  const auto [entry, is_new] = numbers_.try_emplace(name, static_cast<int>(part_names.size()));
  if (is_new) part_names.push_back(name);
  return entry->second;
}

Panels panels_of(Elements elements, const std::string& file) { return Skin(std::move(elements), file).panels(); }

}  // namespace fccda
