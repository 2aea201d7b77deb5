/// Unstructured finite-element mesh: nodes and elements of many kinds. One rule for all formats decides which become panels: surface
/// elements, and the boundary faces of solids.
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

/// Surface elements, then solids. Corner nodes come first, then the mid-side nodes in the order of VTK and Abaqus:
///
///   triangle_6       01 12 20               tetrahedron_10   01 12 20 03 13 23
///   quad_8           01 12 23 30            wedge_15         01 12 20 34 45 53 03 14 25
///   quad_9           plus the centre        pyramid_13       01 12 23 30 04 14 24 34
///                                           hexahedron_20    01 12 23 30 45 56 67 74 04 15 26 37
///
/// In a hexahedron 4567 lie over 0123, in a wedge 345 over 012, in a pyramid 4 over 0123. A solid may also be inverted: its boundary faces are
/// oriented outward relative to its centre.
enum class ElementKind : std::uint8_t {
  polygon,  ///< three or more corners
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

/// Number of nodes of this kind of element; 0 for polygons.
std::size_t nodes_of(ElementKind kind);

/// True for tetrahedra, pyramids, wedges and hexahedra.
bool is_solid(ElementKind kind);

/// Number of corner nodes, which come first. `nodes`: all nodes of the element.
std::size_t corners_of(ElementKind kind, std::size_t nodes);

/// The faces of a solid by corner number, with a fourth corner of -1 for triangles. For the node order above, the first face is oriented
/// inward and the others outward.
std::span<const std::array<int, 4>> faces_of(ElementKind kind);

/// The elements of a file, in its order.
struct Elements {
  std::vector<Vec3d> vertices;          ///< node coordinates, in the file's unit
  std::vector<ElementKind> kinds;       ///< one per element
  std::vector<std::size_t> ends;        ///< one per element: end of its range in `nodes`
  std::vector<int> nodes;               ///< vertex numbers
  std::vector<int> part;                ///< one per element: index into `part_names`
  std::vector<std::string> part_names;  ///< names of the parts

  /// Appends an element with the node count of its kind. `part_of_element`: a number from part_number().
  void add(ElementKind kind, std::span<const int> element_nodes, int part_of_element);

  /// The number of the part with that name; adds a part for a new name.
  int part_number(const std::string& name);

  std::size_t size() const { return kinds.size(); }  ///< number of elements
  /// Vertex numbers of one element.
  std::span<const int> nodes_of_element(std::size_t element) const {
    const std::size_t begin = element == 0 ? 0 : ends[element - 1];
    return std::span(nodes).subspan(begin, ends[element] - begin);
  }

 private:
  std::unordered_map<std::string, int> numbers_;
};

/// The outer surface of the elements: surface elements, and faces that belong to a single solid (boundary faces) unless a surface element
/// covers them. A surface element between two solids is internal and omitted. Quadratic faces are split into triangles (and quads) over
/// their mid-side nodes. A panel keeps the part of its element; parts without panels are dropped. Throws InputError with the file name where a
/// polygon cannot be triangulated or three solids share a face.
Panels panels_of(Elements elements, const std::string& file);

}  // namespace fccda
