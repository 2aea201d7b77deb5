/// What a body is made of before it is cut into particles: solids, what is united with them and taken out, cracks, clouds of points.
///
/// All places in a body are from its position, along its axes: a body that is moved or turned takes its holes, cracks and regions along.
#pragma once

#include <variant>

#include "perimpact/deck_model/file_surface.hpp"

namespace perimpact {

inline constexpr std::string_view axis_words[] = {"x", "y", "z"};

/// A box, centred on its position.
struct BoxSolid {
  static constexpr std::string_view name = "box";
  Vec3d size{};  ///< [m]
  static std::span<const Field<BoxSolid>> fields();
};

/// A cylinder, centred on its position.
struct CylinderSolid {
  static constexpr std::string_view name = "cylinder";
  double diameter{};  ///< [m]
  double height{};    ///< [m] along the axis
  Choice axis{axis_words, 2};
  static std::span<const Field<CylinderSolid>> fields();
};

/// A sphere, centred on its position.
struct SphereSolid {
  static constexpr std::string_view name = "sphere";
  double diameter{};  ///< [m]
  static std::span<const Field<SphereSolid>> fields();
};

/// What a closed surface in a file encloses; the file's origin is its position. `outside` of the base is of open surfaces and not used.
struct FileSolid : FileSurface {
  static std::span<const Field<FileSolid>> fields();
};

using SolidShape = std::variant<BoxSolid, CylinderSolid, SphereSolid, FileSolid>;

/// A solid with a place in a body.
struct SolidSetup {
  std::string name;
  SolidShape shape;
  Vec3d position{};  ///< [m] from the body's position
  Vec3d rotate{};    ///< [rad] about x, then y, then z, through the position
  static std::span<const Field<SolidSetup>> fields();
};

/// Bonds that cross a plane polygon are cut before the first step.
struct CrackSetup {
  std::string name;
  std::vector<Vec3d> polygon;  ///< [m] from the body's position; in a plane body the two ends of a line
  static std::span<const Field<CrackSetup>> fields();
};

/// Particles as a file lists them, each with its volume. The numbers of a CSV file are put here when the deck is read, those of a VTK file
/// (.vtk, .vtp, .vtu, with .gz behind it or not) are read when the body is filled.
struct PointsShape {
  static constexpr std::string_view name = "points";
  std::string file;
  std::optional<double> thickness;  ///< [m] of a plane body
  std::vector<Vec3d> points;        ///< [m] from the body's position
  std::vector<double> volumes;      ///< [m³]
  bool is_vtk() const;
  static std::span<const Field<PointsShape>> fields();
};

/// Particles in the middle of the cells of a mesh.
struct CellsShape {
  static constexpr std::string_view name = "cells";
  std::string file;
  std::vector<std::string> file_parts;  ///< of the file; all where empty
  double scale = 1;                     ///< multiplies the file's coordinates, so that they become metres
  std::optional<double> thickness;      ///< [m] of a plane body
  static std::span<const Field<CellsShape>> fields();
};

using BodyShape = std::variant<BoxSolid, CylinderSolid, SphereSolid, FileSolid, PointsShape, CellsShape>;

}  // namespace perimpact
