#include "io/output/vtp.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numeric>
#include <random>

#include "base/parallel.hpp"
#include "fixtures/temporary_folder.hpp"
#include "fixtures/threads.hpp"
#include "fixtures/vtp_file.hpp"

using namespace perimpact::output;
using fixtures::TemporaryFolder;
using fixtures::text_of;
using fixtures::VtpFile;

namespace {

struct Particles {
  std::vector<float> points, displacement;
  std::vector<double> energy;
  std::vector<std::int32_t> number;
  std::vector<std::uint8_t> in_region;

  explicit Particles(std::size_t count) : points(3 * count), displacement(3 * count), energy(count), number(count), in_region(count) {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> any(-1, 1);
    for (float& x : points) x = any(random);
    for (float& u : displacement) u = 1e-3f * any(random);
    for (double& e : energy) e = any(random);
    std::iota(number.begin(), number.end(), 7);
    for (std::size_t i = 0; i < count; ++i) in_region[i] = i % 3 == 0;
  }

  PolyData frame() const {
    return {.points = std::span(points),
            .point_arrays = {{"displacement", 3, std::span(displacement)}, {"energy \"<&>\"", 1, std::span(energy)}, {"number", 1, std::span(number)}},
            .cell_arrays = {{"in_region", 1, std::span(in_region)}},
            .time = 1.0 / 3};
  }
};

}  // namespace

TEST_CASE("vtp: particles are read back bitwise, plain and compressed") {
  // 30 000 particles: 360 000 bytes of points, one whole compressed block of 2¹⁸ and a shorter one; 1: less than a block; 0: none;
  // 65 536: connectivity of exactly one block, points of exactly three
  for (const std::size_t count : {std::size_t{0}, std::size_t{1}, std::size_t{30'000}, std::size_t{65'536}}) {
    for (const Compression compression : {Compression::none, Compression::zlib}) {
      CAPTURE(count);
      const TemporaryFolder folder;
      const Particles particles(count);
      write_vtp(folder / "p.vtp", particles.frame(), compression);
      VtpFile file(text_of(folder / "p.vtp"));

      CHECK(file.arrays.size() == 7);
      CHECK(file.arrays["Points/points"].as<float>() == particles.points);
      CHECK(file.arrays["Points/points"].components == 3);
      CHECK(file.arrays["PointData/displacement"].type == "Float32");
      CHECK(file.arrays["PointData/displacement"].as<float>() == particles.displacement);
      CHECK(file.arrays["PointData/energy &quot;&lt;&amp;&gt;&quot;"].type == "Float64");
      CHECK(file.arrays["PointData/energy &quot;&lt;&amp;&gt;&quot;"].as<double>() == particles.energy);
      CHECK(file.arrays["PointData/number"].type == "Int32");
      CHECK(file.arrays["PointData/number"].as<std::int32_t>() == particles.number);
      CHECK(file.arrays["CellData/in_region"].type == "UInt8");
      CHECK(file.arrays["CellData/in_region"].as<std::uint8_t>() == particles.in_region);
      CHECK(file.xml.find(">0.3333333333333333</DataArray>") != std::string::npos);

      const auto connectivity = file.arrays["Verts/connectivity"].as<std::int32_t>(), offsets = file.arrays["Verts/offsets"].as<std::int32_t>();
      REQUIRE(connectivity.size() == count);
      REQUIRE(offsets.size() == count);
      for (std::size_t i = 0; i < count; ++i) {
        REQUIRE(connectivity[i] == static_cast<int>(i));
        REQUIRE(offsets[i] == static_cast<int>(i + 1));
      }
      const std::size_t piece = file.xml.find("<Piece");
      CHECK(fixtures::attribute(file.xml, piece, "NumberOfPoints") == std::to_string(count));
      CHECK(fixtures::attribute(file.xml, piece, "NumberOfVerts") == std::to_string(count));
      CHECK(fixtures::attribute(file.xml, piece, "NumberOfPolys") == "0");
    }
  }
}

TEST_CASE("vtp: triangles and quads are read back unchanged") {
  const TemporaryFolder folder;
  fccda::Panels panels;
  panels.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0.5, 1.0 / 3}};
  panels.add_quad(0, 1, 2, 3);
  panels.add_triangle(1, 4, 2);
  const std::vector<double> pressure = {2.5e6, -1};
  write_vtp(folder / "s.vtp", {.points = coordinates(panels.vertices), .panels = panels.panels, .cell_arrays = {{"pressure", 1, std::span(pressure)}}},
            Compression::zlib);
  VtpFile file(text_of(folder / "s.vtp"));
  CHECK(file.arrays["Polys/connectivity"].as<std::int32_t>() == std::vector<std::int32_t>{0, 1, 2, 3, 1, 4, 2});
  CHECK(file.arrays["Polys/offsets"].as<std::int32_t>() == std::vector<std::int32_t>{4, 7});
  CHECK(file.arrays["CellData/pressure"].as<double>() == pressure);
  CHECK(file.arrays["Points/points"].as<double>() == std::vector<double>{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 2, 0.5, 1.0 / 3});
  CHECK(file.xml.find("TimeValue") == std::string::npos);
  CHECK(fixtures::attribute(file.xml, file.xml.find("<Piece"), "NumberOfPolys") == "2");
}

TEST_CASE("vtp: the file is identical for any number of threads") {
  const TemporaryFolder folder;
  const Particles particles(200'000);
  for (const int count : {1, 3}) {
    const fixtures::Threads with_several(count);
    write_vtp(folder / std::to_string(count), particles.frame(), Compression::zlib);
  }
  CHECK(text_of(folder / "1") == text_of(folder / "3"));
}
