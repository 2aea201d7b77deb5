#include "fccda/modes/modes_file.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <numbers>
#include <random>

#include "base/error.hpp"
#include "fixtures/read_or_refused.hpp"
#include "fixtures/temporary_folder.hpp"
#include "fixtures/tolerance.hpp"

using namespace fccda;

namespace {

// Two points and two modes with stresses, in every format; all numbers are exact in binary.
const std::string csv =
    "frequency [Hz], 12.5, 50\n"
    "damping_ratio, 0.25, 0.5\n"
    "x [m], y [m], z [m], mode_1_x [1/sqrt(kg)], mode_1_y, mode_1_z, mode_2_x, mode_2_y, mode_2_z, stress_1_xx, stress_1_yy, stress_1_zz, stress_1_xy, "
    "stress_1_yz, stress_1_zx, stress_2_xx, stress_2_yy, stress_2_zz, stress_2_xy, stress_2_yz, stress_2_zx\n"
    "0, 1, 2, 0.5, 0, -1, 3, 4, 5, 1, 2, 3, 4, 5, 6, 10, 20, 30, 40, 50, 60\n"
    "+7, 8, 9, 0, 0.25, 2, 6, 7, 8, 7, 8, 9, 10, 11, 12, 70, 80, 90, 100, 110, 120\n";

const std::string vtu = R"(<?xml version="1.0"?>
<VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian" header_type="UInt64">
  <UnstructuredGrid>
    <FieldData>
      <DataArray type="Float64" Name="frequency [Hz]" NumberOfTuples="2" format="ascii">12.5 50</DataArray>
      <Array type="String" Name="program" NumberOfTuples="1" format="ascii">99 99 120 0</Array>
      <DataArray type="Float64" Name="damping_ratio" NumberOfTuples="2" format="ascii">0.25 0.5</DataArray>
    </FieldData>
    <Piece NumberOfPoints="2" NumberOfCells="0">
      <PointData>
        <DataArray type="Float64" Name="mode_2" NumberOfComponents="3" format="ascii">3 4 5 6 7 8</DataArray>
        <DataArray type="Float64" Name="mode_1" NumberOfComponents="3" format="ascii">0.5 0 -1 0 0.25 2</DataArray>
        <DataArray type="Float64" Name="stress_1" NumberOfComponents="6" format="ascii">1 2 3 4 5 6 7 8 9 10 11 12</DataArray>
        <DataArray type="Float64" Name="stress_2" NumberOfComponents="6" format="ascii">10 20 30 40 50 60 70 80 90 100 110 120</DataArray>
        <DataArray type="Float64" Name="temperature" format="ascii">1 2</DataArray>
      </PointData>
      <Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">0 1 2 7 8 9</DataArray></Points>
      <Cells/>
    </Piece>
  </UnstructuredGrid>
</VTKFile>
)";

const std::string vtk = R"(# vtk DataFile Version 4.2
modes
ASCII
DATASET UNSTRUCTURED_GRID
FIELD FieldData 2
frequency%20[Hz] 1 2 double
12.5 50
damping_ratio 1 2 double
0.25 0.5
POINTS 2 double
0 1 2 7 8 9
POINT_DATA 2
VECTORS mode_1 double
0.5 0 -1 0 0.25 2
TENSORS6 stress_1 double
1 2 3 4 5 6 7 8 9 10 11 12
FIELD FieldData 2
mode_2 3 2 double
3 4 5 6 7 8
stress_2 6 2 double
10 20 30 40 50 60 70 80 90 100 110 120
)";

/// The text with the first `old_text` replaced.
std::string changed(std::string text, const std::string& old_text, const std::string& new_text) {
  const std::size_t at = text.find(old_text);
  REQUIRE_MESSAGE(at != std::string::npos, "not in the file: " << old_text);
  return text.replace(at, old_text.size(), new_text);
}

ModesFile read(const std::string& text, const std::string& name) {
  const fixtures::TemporaryFolder folder;
  fixtures::put(folder / name, text);
  return read_modes(folder / name);
}

/// The message without the name of the folder; empty if the file is read.
std::string refusal(const std::string& text, const std::string& name) {
  const fixtures::TemporaryFolder folder;
  fixtures::put(folder / name, text);
  try {
    read_modes(folder / name);
  } catch (const InputError& error) {
    const std::string sentence = error.what();
    REQUIRE(sentence.starts_with(folder.path().string() + "/"));
    return sentence.substr(folder.path().string().size() + 1);
  }
  return "";
}

}  // namespace

TEST_CASE("modes file: points, shapes, stresses, frequencies and damping are those of the file, in VTU, VTK and CSV") {
  for (const auto& [name, text] : {std::pair{"panel.csv", csv}, std::pair{"panel.vtu", vtu}, std::pair{"panel.vtk", vtk}}) {
    CAPTURE(name);
    const ModesFile file = read(text, name);
    CHECK(file.points == std::vector<Vec3d>{{0, 1, 2}, {7, 8, 9}});
    REQUIRE(file.modes.size() == 2);
    CHECK(file.modes[0].shape == std::vector<Vec3d>{{0.5, 0, -1}, {0, 0.25, 2}});
    CHECK(file.modes[1].shape == std::vector<Vec3d>{{3, 4, 5}, {6, 7, 8}});
    CHECK(file.modes[0].stress == std::vector<SymmetricTensor>{{1, 2, 3, 4, 5, 6}, {7, 8, 9, 10, 11, 12}});
    CHECK(file.modes[1].stress == std::vector<SymmetricTensor>{{10, 20, 30, 40, 50, 60}, {70, 80, 90, 100, 110, 120}});
    CHECK(file.modes[0].angular_frequency == fixtures::relative(25 * std::numbers::pi, 1e-15));  // rounding of a product
    CHECK(file.modes[1].angular_frequency == fixtures::relative(100 * std::numbers::pi, 1e-15));
    CHECK(file.modes[0].damping_ratio == 0.25);
    CHECK(file.modes[1].damping_ratio == 0.5);
  }
}

TEST_CASE("modes file: damping and stresses are optional, and one damping ratio is that of all modes") {
  CHECK(read(changed(csv, "damping_ratio, 0.25, 0.5\n", ""), "panel.csv").modes[1].damping_ratio == 0);
  CHECK(read(changed(csv, "0.25, 0.5\n", "0.125\n"), "panel.csv").modes[1].damping_ratio == 0.125);
  const ModesFile bare = read("frequency [Hz], 3\nx [m], y [m], z [m], mode_1_x, mode_1_y, mode_1_z\r\n\n0, 0, 0, 1, 2, 3\n", "bare.csv");
  CHECK(bare.modes.front().stress.empty());
  CHECK(bare.modes.front().shape == std::vector<Vec3d>{{1, 2, 3}});
}

TEST_CASE("modes file: modes, frequencies, damping and stresses that do not fit each other are refused") {
  const auto of = [](const std::string& old_text, const std::string& new_text) { return refusal(changed(vtu, old_text, new_text), "panel.vtu"); };
  CHECK(of("\"mode_1\" N", "\"mode_3\" N") == "panel.vtu: there is mode_2, but no mode_1; number the modes from 1 without gaps.");
  CHECK(of("\"mode_1\" N", "\"mode_02\" N") == "panel.vtu: mode_02 has the number of an array before it; number the arrays from 1.");
  CHECK(refusal(changed(changed(vtu, "\"mode_1\"", "\"u1\""), "\"mode_2\"", "\"u2\""), "panel.vtu") ==
        "panel.vtu: there are no modes; give point arrays mode_1, mode_2 and so on, with three components each.");
  CHECK(of("\"mode_1\" NumberOfComponents=\"3\" format=\"ascii\">0.5 0", "\"mode_1\" NumberOfComponents=\"2\" format=\"ascii\">") ==
        "panel.vtu: mode_1 has 2 components, but needs 3, x, y and z.");
  CHECK(of("\"stress_2\" NumberOfComponents=\"6\" format=\"ascii\">10 20 30 40 50 60 70", "\"stress_2\" NumberOfComponents=\"3\" format=\"ascii\">70") ==
        "panel.vtu: stress_2 has 3 components, but needs 6, xx, yy, zz, xy, yz and zx.");
  CHECK(of("\"stress_2\"", "\"stress\"") == "panel.vtu: there is no stress_2; give the stresses of all modes, or of none.");
  CHECK(of("\"stress_2\"", "\"stress_5\"") == "panel.vtu: there is stress_5, but no mode of this number; give its shape, or remove it.");
  CHECK(of("frequency [Hz]", "frequency") == "panel.vtu: there is no field data `frequency [Hz]`; give the frequency of each mode.");
  CHECK(of("NumberOfTuples=\"2\" format=\"ascii\">12.5 50", "NumberOfTuples=\"3\" format=\"ascii\">12.5 50 60") ==
        "panel.vtu: `frequency [Hz]` has 3 values for 2 modes; give one for each mode, in their order.");
  const std::string rigid = " Hz, but that of an elastic mode is positive; leave out rigid-body modes, because the impactor has its rigid motion without them.";
  CHECK(of(">12.5 50", ">12.5 0") == "panel.vtu: mode_2 has a frequency of 0" + rigid);
  CHECK(of(">12.5 50", ">-12.5 50") == "panel.vtu: mode_1 has a frequency of -12.5" + rigid);
  CHECK(of(">0.25 0.5", ">0.25 1") == "panel.vtu: mode_2 has a damping ratio of 1, but it must be at least 0 and below 1.");
  CHECK(of(">0.25 0.5", ">-0.25 0.5") == "panel.vtu: mode_1 has a damping ratio of -0.25, but it must be at least 0 and below 1.");
}

TEST_CASE("modes file: numbers that are not finite, missing values and unknown formats are refused with their place") {
  CHECK(refusal(changed(vtu, ">3 4 5", ">nan 4 5"), "panel.vtu") ==
        "panel.vtu:11: PointData/mode_2 has `nan` where a finite number is expected; "
        "correct the file or export it again.");
  CHECK(refusal(changed(vtu, ">3 4 5", ">4 5"), "panel.vtu") ==
        "panel.vtu:11: PointData/mode_2 has 5 numbers, but needs 6; correct the file or export it again.");
  CHECK(refusal(csv, "panel.txt") == "panel.txt: `.txt` is not a supported format of modes; the formats are .vtu, .vtp, .vtk and .csv.");
  CHECK(refusal(changed(csv, ", 12, 70", ", inf, 70"), "panel.csv") == "panel.csv:5: `inf` is not a finite number; correct it or export the file again.");
  CHECK(refusal(changed(csv, ", 120\n", "\n"), "panel.csv") == "panel.csv:5: the row has 20 numbers for 21 columns; correct it or export the file again.");
  CHECK(refusal(changed(csv, "mode_1_y, mode_1_z", "mode_1_z, mode_1_y"), "panel.csv") ==
        "panel.csv:3: the column `mode_1_z` is out of order; columns are mode_1_x, mode_1_y, mode_1_z and so on, and stress_1_xx, stress_1_yy, stress_1_zz, "
        "stress_1_xy, stress_1_yz, stress_1_zx.");
  CHECK(refusal(changed(csv, "x [m], y [m]", "x [mm], y [mm]"), "panel.csv") ==
        "panel.csv:3: this line is neither `frequency [Hz]` nor `damping_ratio` with their numbers, nor the column names, which begin with `x [m], y [m], z "
        "[m]`; correct it.");
  CHECK(refusal("frequency [Hz], 3\n", "panel.csv") ==
        "panel.csv:1: there is no line of column names, `x [m], y [m], z [m], mode_1_x, mode_1_y, mode_1_z` and so on; add it.");
  CHECK(refusal(changed(vtk, "VECTORS mode_1 double\n", "FIELD FieldData 1\nmode_1 3 1 double\n"), "panel.vtk").starts_with("panel.vtk:"));
}

TEST_CASE("modes file: pieces are joined, and must have the same arrays") {
  const std::size_t begin = vtu.find("    <Piece"), end = vtu.find("  </UnstructuredGrid>");
  const std::string piece = vtu.substr(begin, end - begin);
  const ModesFile file = read(changed(vtu, piece, piece + piece), "panel.vtu");
  CHECK(file.points.size() == 4);
  CHECK(file.modes[1].shape == std::vector<Vec3d>{{3, 4, 5}, {6, 7, 8}, {3, 4, 5}, {6, 7, 8}});
  CHECK(refusal(changed(vtu, piece, piece + changed(piece, "\"stress_1\"", "\"s\"")), "panel.vtu") ==
        "panel.vtu:20: the piece lacks the point array `stress_1` that the pieces before it have; merge the pieces and export the file again.");
}

TEST_CASE("modes file: a file cut off or damaged anywhere is read or refused in one sentence") {
  const fixtures::TemporaryFolder folder;
  std::mt19937 random(7);
  for (const auto& [name, text] : {std::pair{"panel.csv", csv}, std::pair{"panel.vtu", vtu}, std::pair{"panel.vtk", vtk}}) {
    const auto check = [&, file = folder / name](const std::string& contents) {
      fixtures::put(file, contents);
      fixtures::check_read_or_refused(file.string(), text.size(), [&] { return read_modes(file).points.size(); });
    };
    for (std::size_t length = 1; length < text.size(); length += 7) check(text.substr(0, length));
    for (int trial = 0; trial < 200; ++trial) {
      std::string damaged = text;
      damaged[random() % damaged.size()] = static_cast<char>(random() % 256);
      check(damaged);
    }
  }
}
