/// Writer of VTK XML PolyData (.vtp) for ParaView, without dependency on VTK. Arrays are appended as raw bytes with 64-bit sizes, plain or in
/// zlib blocks (vtkZLibDataCompressor), in native byte order, which the file states.
///
/// Format: VTK File Formats, https://docs.vtk.org/en/latest/design_documents/VTKFileFormats.html
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "base/vec3.hpp"
#include "mesh/panels.hpp"

namespace perimpact::output {

/// Numbers that exist only while they are compressed, so that the arrays of a frame are not in memory together.
struct MadeFloats {
  std::size_t count;
  std::function<std::vector<float>()> make;

  std::size_t size() const { return count; }
};

using Numbers = std::variant<std::span<const float>, std::span<const double>, std::span<const std::int32_t>, std::span<const std::uint8_t>, MadeFloats>;

std::size_t count_of(const Numbers& numbers);

/// A named array with `components` numbers per point or cell. The caller owns the numbers.
struct VtpArray {
  std::string name;  ///< in SI units: displacement [m], velocity [m/s], damage [-]
  int components = 1;
  Numbers numbers;
  bool is_constant = false;  ///< the same in every frame of a series: VTKHDF stores it once
};

/// Contents of a file. Without panels each point is a vertex cell (a particle).
struct PolyData {
  Numbers points;                                   ///< x y z of each point [m]; float or double
  std::span<const std::array<int, 4>> panels = {};  ///< as in fccda::Panels
  std::vector<VtpArray> point_arrays = {};
  std::vector<VtpArray> cell_arrays = {};
  std::optional<double> time = {};  ///< [s]
  bool varies = false;              ///< the number of points changes from frame to frame; without panels
};

/// Measured with 180 000 particles (position, displacement, velocity, damage as float) on two cores: plain 8.6 MB in 8 ms,
/// zlib 5.6 MB in 92 ms.
enum class Compression { none, zlib };

/// Writes the file atomically (WholeFile). MadeFloats need compression. Throws RunError where it cannot be written.
void write_vtp(const std::filesystem::path& path, const PolyData& data, Compression compression);

/// Vertex coordinates of a surface, without a copy. `vertices` may be those of fccda::Panels, or these transformed with the body.
Numbers coordinates(std::span<const fccda::Vec3d> vertices);

}  // namespace perimpact::output
