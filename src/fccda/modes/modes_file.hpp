/// Files of vibration modes: points of a finite-element model with the mode shapes, frequencies and stresses of an eigenvalue analysis.
///
/// VTU, VTP and legacy VTK files have the point arrays
///   mode_1, mode_2, …      [1/√kg] three components, normalised to unit modal mass
///   stress_1, stress_2, …  [Pa/(m √kg)] six components xx, yy, zz, xy, yz, zx at unit modal coordinate; of all modes or none
/// and the field data
///   frequency [Hz]         one for each mode
///   damping_ratio          one for each mode, or one for all; 0 where absent
///
/// CSV files have the field data as rows before the table, and a column for each component:
///   frequency [Hz], 12.5, 43.1
///   damping_ratio, 0.02, 0.02
///   x [m], y [m], z [m], mode_1_x, mode_1_y, mode_1_z, mode_2_x, …, stress_1_xx, stress_1_yy, stress_1_zz, stress_1_xy, stress_1_yz, stress_1_zx, …
///   0, 0, 0, …
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/vec3.hpp"
#include "fccda/elastic/modes.hpp"
#include "mesh_io/vtk/point_values.hpp"

namespace fccda {

/// Modes on the points of their file.
struct ModesFile {
  std::string file;           ///< its name, for messages
  std::vector<Vec3d> points;  ///< [m]
  Modes modes;                ///< on the points, in the order of their numbers
};

/// Reads a file of modes (.vtu, .vtp, .vtk or .csv, followed by `.gz` where compressed). Throws InputError where the file does not exist or is damaged; where
/// modes are missing or have a wrong number of components; where the numbers of frequencies or damping ratios differ from that of the modes; where a frequency
/// is not positive, or a damping ratio not at least 0 and below 1.
ModesFile read_modes(const std::filesystem::path& path);

/// The arrays of such a file in CSV.
PointData parse_modes_csv(std::string_view contents, const std::string& file);

}  // namespace fccda
