#include "io/output/vtp.hpp"

#include <fmt/format.h>

#include <bit>
#include <limits>
#include <numeric>
#include <string_view>

#include "base/contract.hpp"
#include "io/output/appended.hpp"
#include "io/output/file.hpp"
#include "io/output/xml.hpp"

namespace perimpact::output {

namespace {

template <class Number>
constexpr std::string_view vtk_type() {
  if constexpr (std::is_same_v<Number, float>) return "Float32";
  if constexpr (std::is_same_v<Number, double>) return "Float64";
  if constexpr (std::is_same_v<Number, std::int32_t>) return "Int32";
  if constexpr (std::is_same_v<Number, std::uint8_t>) return "UInt8";
}

/// The XML element of an array; its bytes are added to `appended`.
std::string element(const VtpArray& array, Appended& appended) {
  const auto of = [&]<class Number>(std::span<const Number> span) {
    return fmt::format("        <DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"appended\" offset=\"{}\"/>\n", vtk_type<Number>(),
                       xml_attribute(array.name), array.components, appended.add(std::as_bytes(span)));
  };
  return std::visit(
      [&]<class Given>(const Given& given) {
        if constexpr (std::is_same_v<Given, MadeFloats>)
          return of(std::span<const float>(given.make()));
        else
          return of(given);
      },
      array.numbers);
}

std::string section(std::string_view name, std::span<const VtpArray> arrays, Appended& appended) {
  std::string text = fmt::format("      <{}>\n", name);
  for (const VtpArray& array : arrays) text += element(array, appended);
  return text + fmt::format("      </{}>\n", name);
}

/// Cell connectivity: point numbers of all cells, and the end of each cell's range.
struct Cells {
  std::vector<std::int32_t> connectivity, offsets;

  /// One vertex cell per particle, since ParaView's Threshold keeps or drops whole cells.
  static Cells particles(std::size_t count) {
    Cells cells{std::vector<std::int32_t>(count), std::vector<std::int32_t>(count)};
    std::iota(cells.connectivity.begin(), cells.connectivity.end(), 0);
    std::iota(cells.offsets.begin(), cells.offsets.end(), 1);
    return cells;
  }

  static Cells polygons(std::span<const std::array<int, 4>> panels) {
    Cells cells;
    for (const std::array<int, 4>& panel : panels) {
      cells.connectivity.insert(cells.connectivity.end(), panel.begin(), panel[3] < 0 ? panel.end() - 1 : panel.end());
      cells.offsets.push_back(static_cast<std::int32_t>(cells.connectivity.size()));
    }
    return cells;
  }
};

void expect_consistent([[maybe_unused]] const PolyData& data, [[maybe_unused]] std::size_t points, [[maybe_unused]] std::size_t cells) {
  EXPECTS(count_of(data.points) == 3 * points && points <= std::numeric_limits<std::int32_t>::max());
  for ([[maybe_unused]] const VtpArray& array : data.point_arrays) EXPECTS(count_of(array.numbers) == points * static_cast<std::size_t>(array.components));
  for ([[maybe_unused]] const VtpArray& array : data.cell_arrays) EXPECTS(count_of(array.numbers) == cells * static_cast<std::size_t>(array.components));
}

}  // namespace

std::size_t count_of(const Numbers& numbers) {
  return std::visit([](const auto& span) { return span.size(); }, numbers);
}

void write_vtp(const std::filesystem::path& path, const PolyData& data, Compression compression) {
  const std::size_t points = count_of(data.points) / 3, cell_count = data.panels.empty() ? points : data.panels.size();
  expect_consistent(data, points, cell_count);

  const VtpArray positions{"points", 3, data.points};
  Appended appended(compression);
  std::string arrays = section("PointData", data.point_arrays, appended);
  arrays += section("CellData", data.cell_arrays, appended);
  arrays += section("Points", {&positions, 1}, appended);
  const Cells cells = data.panels.empty() ? Cells::particles(points) : Cells::polygons(data.panels);
  const VtpArray topology[] = {{"connectivity", 1, std::span(cells.connectivity)}, {"offsets", 1, std::span(cells.offsets)}};
  arrays += section(data.panels.empty() ? "Verts" : "Polys", topology, appended);

  WholeFile file(path);
  file.write(fmt::format("<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"{}\" header_type=\"UInt64\"{}>\n  <PolyData>\n",
                         std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian",
                         compression == Compression::zlib ? " compressor=\"vtkZLibDataCompressor\"" : ""));
  if (data.time) {
    file.write(
        fmt::format("    <FieldData>\n      <DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">{}</DataArray>\n"
                    "    </FieldData>\n",
                    *data.time));
  }
  file.write(fmt::format("    <Piece NumberOfPoints=\"{}\" NumberOfVerts=\"{}\" NumberOfPolys=\"{}\">\n", points, data.panels.empty() ? cell_count : 0,
                         data.panels.empty() ? 0 : cell_count));
  file.write(arrays + "    </Piece>\n  </PolyData>\n  <AppendedData encoding=\"raw\">\n_");
  appended.write_to(file);
  file.write("\n  </AppendedData>\n</VTKFile>\n");
  file.finish();
}

Numbers coordinates(std::span<const fccda::Vec3d> vertices) {
  static_assert(sizeof(fccda::Vec3d) == 3 * sizeof(double));
  return std::span(vertices.empty() ? nullptr : &vertices.front().x, 3 * vertices.size());
}

}  // namespace perimpact::output
