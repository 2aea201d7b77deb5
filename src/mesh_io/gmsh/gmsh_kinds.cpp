#include "mesh_io/gmsh/gmsh_kinds.hpp"

#include <algorithm>
#include <iterator>

namespace fccda {
namespace {

using Node = std::uint8_t;

constexpr Node as_it_is[] = {0, 1, 2, 3, 4, 5, 6, 7, 8};
constexpr std::span<const Node> first(std::size_t n) { return std::span(as_it_is).first(n); }

constexpr Node triangle_reversed[] = {0, 2, 1};
constexpr Node quad_reversed[] = {0, 3, 2, 1};
constexpr Node triangle_6_reversed[] = {0, 2, 1, 5, 4, 3};
constexpr Node quad_8_reversed[] = {0, 3, 2, 1, 7, 6, 5, 4};
constexpr Node quad_9_reversed[] = {0, 3, 2, 1, 7, 6, 5, 4, 8};

// after the corners: for each edge in the order of Elements, the index of its mid-side node in the file
// Gmsh: 01 12 20 03 23 13
constexpr Node tetrahedron_10[] = {0, 1, 2, 3, /*01*/ 4, /*12*/ 5, /*20*/ 6, /*03*/ 7, /*13*/ 9, /*23*/ 8};
// Gmsh: 01 03 04 12 14 23 24 34
constexpr Node pyramid_13[] = {0, 1, 2, 3, 4, /*01*/ 5, /*12*/ 8, /*23*/ 10, /*30*/ 6, /*04*/ 7, /*14*/ 9, /*24*/ 11, /*34*/ 12};
// Gmsh: 01 02 03 12 14 25 34 35 45
constexpr Node wedge_15[] = {0, 1, 2, 3, 4, 5, /*01*/ 6, /*12*/ 9, /*20*/ 7, /*34*/ 12, /*45*/ 14, /*53*/ 13, /*03*/ 8, /*14*/ 10, /*25*/ 11};
// Gmsh: 01 03 04 12 15 23 26 37 45 47 56 67
constexpr Node hexahedron_20[] = {0,         1,        2,         3,         4,         5,         6,         7,         /*01*/ 8,  /*12*/ 11,
                                  /*23*/ 13, /*30*/ 9, /*45*/ 16, /*56*/ 18, /*67*/ 19, /*74*/ 17, /*04*/ 10, /*15*/ 12, /*26*/ 14, /*37*/ 15};

using Kind = ElementKind;
constexpr GmshKind kinds[] = {
    {15, 0, 1, Kind::polygon, {}, {}},
    {1, 1, 2, Kind::polygon, {}, {}},
    {8, 1, 3, Kind::polygon, {}, {}},
    {2, 2, 3, Kind::polygon, first(3), triangle_reversed},
    {3, 2, 4, Kind::polygon, first(4), quad_reversed},
    {9, 2, 6, Kind::triangle_6, first(6), triangle_6_reversed},
    {16, 2, 8, Kind::quad_8, first(8), quad_8_reversed},
    {10, 2, 9, Kind::quad_9, first(9), quad_9_reversed},
    {4, 3, 4, Kind::tetrahedron, first(4), {}},
    {5, 3, 8, Kind::hexahedron, first(8), {}},
    {6, 3, 6, Kind::wedge, first(6), {}},
    {7, 3, 5, Kind::pyramid, first(5), {}},
    {11, 3, 10, Kind::tetrahedron_10, tetrahedron_10, {}},
    {17, 3, 20, Kind::hexahedron_20, hexahedron_20, {}},
    {12, 3, 27, Kind::hexahedron_20, hexahedron_20, {}},
    {18, 3, 15, Kind::wedge_15, wedge_15, {}},
    {13, 3, 18, Kind::wedge_15, wedge_15, {}},
    {19, 3, 13, Kind::pyramid_13, pyramid_13, {}},
    {14, 3, 14, Kind::pyramid_13, pyramid_13, {}},
};

}  // namespace

const GmshKind* gmsh_kind(int type) {
  const auto found = std::find_if(std::begin(kinds), std::end(kinds), [type](const GmshKind& kind) { return kind.type == type; });
  return found == std::end(kinds) ? nullptr : &*found;
}

}  // namespace fccda
