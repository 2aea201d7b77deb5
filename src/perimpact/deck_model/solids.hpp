/// Geometry of a body before discretisation: solids and their Boolean combination, cracks, point clouds.
///
/// Positions are relative to the body's position and in its axes, so that holes, cracks and particle sets move and rotate with the body.
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

/// Interior of a closed surface in a file; the file's origin is its position. `orientation` of the base applies to open surfaces and is not used.
struct FileSolid : FileSurface {
  static std::span<const Field<FileSolid>> fields();
};

using SolidShape = std::variant<BoxSolid, CylinderSolid, SphereSolid, FileSolid>;

/// Solid positioned in a body.
struct SolidSetup {
  std::string name;
  SolidShape shape;
  Vec3d position{};  ///< [m] from the body's position
  Vec3d rotate{};    ///< [rad] about x, then y, then z, through the position
  static std::span<const Field<SolidSetup>> fields();
};

/// Initial crack: bonds that cross a plane polygon are cut before the first step.
struct CrackSetup {
  std::string name;
  std::vector<Vec3d> polygon;  ///< [m] from the body's position; in a plane body the two ends of a line
  static std::span<const Field<CrackSetup>> fields();
};

/// Point cloud from a file, each particle with its volume. A CSV file is read with the deck; a VTK file (.vtk, .vtp, .vtu, also as .gz)
/// is read when the body is discretised.
struct PointsShape {
  static constexpr std::string_view name = "points";
  std::string file;
  std::optional<double> thickness;  ///< [m] of a plane body
  std::vector<Vec3d> points;        ///< [m] from the body's position
  std::vector<double> volumes;      ///< [m³]
  bool is_vtk() const;
  static std::span<const Field<PointsShape>> fields();
};

/// One particle per cell of an unstructured mesh, at the cell's centroid.
struct CellsShape {
  static constexpr std::string_view name = "cells";
  std::string file;
  std::vector<std::string> file_parts;  ///< of the file; all where empty
  double scale = 1;                     ///< converts the file's coordinates to metres
  std::optional<double> thickness;      ///< [m] of a plane body
  static std::span<const Field<CellsShape>> fields();
};

using BodyShape = std::variant<BoxSolid, CylinderSolid, SphereSolid, FileSolid, PointsShape, CellsShape>;

}  // namespace perimpact
