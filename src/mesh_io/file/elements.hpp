/// A mesh as finite-element programs write it: nodes, and elements of many kinds. What becomes panels is decided here, once for all
/// formats: surface elements, and the skin of the solid ones.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "mesh/panels.hpp"

namespace fccda {

/// Surface elements, then solids. Corners come first, then the nodes in the middle of edges in the order that VTK and Abaqus have:
///
///   triangle_6       01 12 20               tetrahedron_10   01 12 20 03 13 23
///   quad_8           01 12 23 30            wedge_15         01 12 20 34 45 53 03 14 25
///   quad_9           and the centre         pyramid_13       01 12 23 30 04 14 24 34
///                                           hexahedron_20    01 12 23 30 45 56 67 74 04 15 26 37
///
/// In a hexahedron 4567 lie over 0123, in a wedge 345 over 012, in a pyramid 4 over 0123. Whether the solid is so wound, or inside out, does
/// not matter: the skin is turned outward by the solid's own centre.
enum class ElementKind : std::uint8_t {
  polygon,  ///< any number of corners, from three
  triangle_6,
  quad_8,
  quad_9,
  tetrahedron,
  tetrahedron_10,
  pyramid,
  pyramid_13,
  wedge,
  wedge_15,
  hexahedron,
  hexahedron_20
};

/// How many nodes an element of this kind has; 0 for polygons.
std::size_t nodes_of(ElementKind kind);

bool is_solid(ElementKind kind);

/// How many of an element's nodes, the first ones, are corners. `nodes`: all it has.
std::size_t corners_of(ElementKind kind, std::size_t nodes);

/// The faces of a solid by corner number, the fourth -1 where there are three. The first face is seen from within, the others from outside,
/// where the nodes are in the order above.
std::span<const std::array<int, 4>> faces_of(ElementKind kind);

struct Elements {
  std::vector<Vec3d> vertices;     ///< of the nodes, in the file's unit
  std::vector<ElementKind> kinds;  ///< of each element
  std::vector<std::size_t> ends;   ///< where its nodes end in `nodes`
  std::vector<int> nodes;          ///< vertex numbers
  std::vector<int> part;           ///< of each element, in `part_names`
  std::vector<std::string> part_names;

  /// `nodes` must be as many as the kind has. `part`: a number from part_number().
  void add(ElementKind kind, std::span<const int> element_nodes, int part_of_element);

  /// The number of the part of that name, which is new where the name is.
  int part_number(const std::string& name);

  std::size_t size() const { return kinds.size(); }
  std::span<const int> nodes_of_element(std::size_t element) const {
    const std::size_t begin = element == 0 ? 0 : ends[element - 1];
    return std::span(nodes).subspan(begin, ends[element] - begin);
  }

 private:
  std::unordered_map<std::string, int> numbers_;
};

/// The surface of the elements: surface elements as they are, and faces of solids that belong to one solid only, unless a surface element
/// lies on them. A surface element that lies between two solids is inside and left out. Quadratic faces become triangles (and quads) over
/// their middle nodes. A panel's part is that of its element; a part that has no panel is none. Throws InputError that names the file
/// where a polygon cannot be cut into triangles, or three solids share a face.
Panels panels_of(Elements elements, const std::string& file);

}  // namespace fccda
