#include "mesh_io/keyword/abaqus_types.hpp"

#include <algorithm>
#include <charconv>

namespace fccda {
namespace {

using Use = AbaqusType::Use;

/// Families whose name is followed by the number of nodes.
struct Family {
  std::string_view name;
  Use use;
};
constexpr Family families[] = {
    {"S", Use::surface},   {"DS", Use::surface},  {"M3D", Use::surface}, {"SFM3D", Use::surface}, {"R3D", Use::surface},  // surfaces
    {"CPS", Use::surface}, {"CPE", Use::surface}, {"CAX", Use::surface},  // plane elements, which mesh generators use for 3-D surfaces
    {"C3D", Use::solid},   {"DC3D", Use::solid},  {"AC3D", Use::solid},  {"EC3D", Use::solid},    {"Q3D", Use::solid},
    {"COH3D", Use::solid}, {"SC", Use::solid},    {"CSS", Use::solid}};

/// Prefixes of skipped types: lines, points, springs, connectors, particles.
constexpr std::string_view skipped[] = {"B2",      "B3",   "T2D",    "T3D",    "PIPE",     "ELBOW", "FRAME", "MASS",   "ROTARYI", "HEATCAP", "SPRING",
                                        "DASHPOT", "CONN", "GAPUNI", "GAPCYL", "GAPSPHER", "DGAP",  "DCOUP", "JOINTC", "JOINT2D", "JOINT3D", "RB2D",
                                        "RB3D",    "R2D",  "ITSUNI", "ITSCYL", "DC1D",     "AC1D",  "PC3D",  "PD3D",   "DCC1D",   "LS6",     "PSI"};
/// Plane and axisymmetric elements that mesh generators do not use for 3-D surfaces.
constexpr std::string_view plane[] = {"CPEG", "CGAX", "SAX",  "MAX",  "MGAX", "RAX",   "SFMAX", "SFMGAX",
                                      "DC2D", "DCAX", "DSAX", "AC2D", "ACAX", "COH2D", "COHAX", "WARP"};

AbaqusType surface_of(std::size_t nodes) {
  switch (nodes) {
    case 3:
    case 4:
      return {Use::surface, ElementKind::polygon, nodes};
    case 6:
      return {Use::surface, ElementKind::triangle_6, nodes};
    case 8:
      return {Use::surface, ElementKind::quad_8, nodes};
    case 9:
      return {Use::surface, ElementKind::quad_9, nodes};
    default:
      return {};
  }
}

AbaqusType solid_of(std::size_t nodes) {
  constexpr ElementKind kinds[] = {ElementKind::tetrahedron,    ElementKind::pyramid,    ElementKind::wedge,    ElementKind::hexahedron,
                                   ElementKind::tetrahedron_10, ElementKind::pyramid_13, ElementKind::wedge_15, ElementKind::hexahedron_20};
  const auto kind = std::find_if(std::begin(kinds), std::end(kinds), [&](ElementKind one) { return nodes_of(one) == nodes; });
  return kind == std::end(kinds) ? AbaqusType{} : AbaqusType{Use::solid, *kind, nodes};
}

bool begins_with_one_of(std::string_view name, std::span<const std::string_view> starts) {
  return std::any_of(starts.begin(), starts.end(), [&](std::string_view start) { return name.starts_with(start); });
}

}  // namespace

AbaqusType abaqus_type(std::string_view name) {
  if (name.starts_with("STRI65")) return surface_of(6);
  if (name.starts_with("STRI3")) return surface_of(3);
  for (const Family& family : families) {
    if (!name.starts_with(family.name)) continue;
    const std::string_view rest = name.substr(family.name.size());
    std::size_t nodes = 0;
    const auto [end, problem] = std::from_chars(rest.data(), rest.data() + rest.size(), nodes);
    if (problem != std::errc{}) continue;
    const std::string_view variant(end, static_cast<std::size_t>(rest.data() + rest.size() - end));
    if (family.use == Use::solid && variant.find('V') != std::string_view::npos) return {};  // C3D15V, C3D27V: variable number of nodes
    return family.use == Use::solid ? solid_of(nodes) : surface_of(nodes);
  }
  if (begins_with_one_of(name, skipped)) return {Use::skipped};
  return {begins_with_one_of(name, plane) ? Use::plane : Use::unknown};
}

}  // namespace fccda
