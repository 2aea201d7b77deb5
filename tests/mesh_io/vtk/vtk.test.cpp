#include "mesh_io/vtk/vtk.hpp"

#include <doctest/doctest.h>

#include <limits>
#include <random>

#include "base/error.hpp"
#include "fixtures/polygon_files.hpp"
#include "fixtures/read_or_refused.hpp"
#include "fixtures/tolerance.hpp"
#include "mesh/surface.hpp"
#include "mesh_io/obj.hpp"

using namespace fccda;
using fixtures::LegacyForm;
using fixtures::Mesh;
using fixtures::vtk_legacy;
using fixtures::with;

namespace {

Panels parse(const std::string& contents) { return panels_of(parse_vtk(contents, "hull.vtk"), "hull.vtk"); }
void check_refused(const std::string& contents, const char* sentence) { CHECK_THROWS_WITH_AS(parse(contents), sentence, InputError); }
void check_read_or_refused(const std::string& contents, std::size_t most_panels) {
  fixtures::check_read_or_refused("hull.vtk", most_panels, [&] { return parse(contents).panels.size(); });
}

std::vector<std::string> all_forms(const Mesh& mesh) {
  std::vector<std::string> forms;
  for (const bool is_grid : {false, true})
    for (const LegacyForm& form : fixtures::legacy_forms(is_grid)) forms.push_back(vtk_legacy(mesh, form));
  return forms;
}

/// A tetrahedron whose faces belong to two parts.
Mesh named_tetrahedron() {
  Mesh mesh = fixtures::mesh_of(fixtures::tetrahedron());
  mesh.array = "PartId";
  mesh.part = {3, 3, 12, 12};
  return mesh;
}

std::string header(const std::string& dataset) { return "# vtk DataFile Version 3.0\n\nASCII\nDATASET " + dataset + "\n"; }
const std::string points = "POINTS 4 float\n0 0 0 1 0 0 0 1 0\n0 0 1\n";

}  // namespace

TEST_CASE("vtk: every form is read back bitwise, with the panels that OBJ gives for the same polygons") {
  for (const Mesh& mesh : fixtures::polygon_meshes()) {
    const Panels expected = parse_obj(fixtures::obj_text(mesh), "oracle.obj");
    for (const std::string& contents : all_forms(mesh)) {
      const Panels panels = parse(contents);
      CHECK(panels.vertices == mesh.vertices);
      CHECK(panels.panels == expected.panels);
      CHECK(panels.part.empty());
    }
  }
}

TEST_CASE("vtk: in every form an integer cell array defines the parts, by rank of its name") {
  for (const std::string& contents : all_forms(named_tetrahedron())) {
    const Panels panels = parse(contents);
    CHECK(panels.part_names == std::vector<std::string>{"part 3", "part 12"});
    CHECK(panels.part == std::vector{0, 0, 1, 1});
  }
  const std::string text = vtk_legacy(named_tetrahedron(), {});
  const Panels panels = parse(text + "SCALARS medit:ref int\nLOOKUP_TABLE default\n1 1 1 1\nSCALARS part long 1\nLOOKUP_TABLE default\n7 8 8 8\n");
  CHECK(panels.part_names == std::vector<std::string>{"part 7", "part 8"});
  CHECK(parse(with(text, "PartId 1 4 int", "PartId 1 4 float")).part.empty());
  CHECK(parse(with(text, "CELL_DATA", "POINT_DATA")).part.empty());
  check_refused(with(text, "PartId 1 4 int\n3 ", "PartId 1 3 int\n"), "hull.vtk:13: the array `PartId` has 3 numbers for 4 cells; export the file again.");
}

TEST_CASE("vtk: solids contribute their boundary faces") {
  Mesh mesh;
  mesh.vertices = fixtures::unit_cube().vertices;
  mesh.cells = {{12, {0, 1, 3, 2, 4, 5, 7, 6}}, {3, {0, 1}}};
  for (const LegacyForm& form : fixtures::legacy_forms(true)) {
    const Surface surface(parse(vtk_legacy(mesh, form)));
    CHECK(surface.is_closed());
    CHECK(surface.report().volume == fixtures::relative(1, 1e-12));
  }
}

TEST_CASE("vtk: vertices and lines are skipped, and cell data count them first whatever their order in the file") {
  const Panels panels = parse(header("polydata") + points +
                              "TRIANGLE_STRIPS 1 5\n4 0 1 2 3\nPOLYGONS 1 4\n3 0 1 2\nLINES 1 3\n2 0 1\nVERTICES 2 4\n1 0 1 1\n\n"
                              "CELL_DATA 5\nSCALARS part int 1\nLOOKUP_TABLE default\n10 11 12 13 14\n");
  CHECK(panels.panels == std::vector<std::array<int, 4>>{{0, 1, 2, -1}, {0, 1, 2, -1}, {2, 1, 3, -1}});
  CHECK(panels.part_names == std::vector<std::string>{"part 13", "part 14"});
  CHECK(panels.part == std::vector{0, 1, 1});
}

TEST_CASE("vtk: all other data are skipped, in text") {
  const Panels panels =
      parse(header("POLYDATA") + "FIELD FieldData 3\nTIME 1 1 double\n0.5\nMETADATA\nINFORMATION 1\nNAME UNITS LOCATION vtkDataArray\nDATA s\n\n" +
            "NULL_ARRAY\nnames 1 2 string\nhello%20world\nCELL_DATA 9\n" + points + "METADATA\nCOMPONENT_NAMES\nx\n\nPOLYGONS 1 4\n3 0 1 2\n" +
            "POINT_DATA 4\nSCALARS p float 2\nLOOKUP_TABLE mine\n1 2 3 4 5 6 7 nan\nLOOKUP_TABLE mine 2\n1 1 1 1 0 0 0 1\nVECTORS v double\n" +
            "1 0 0 1 0 0 1 0 0 1 0 0\nNORMALS n float\n1 0 0 1 0 0 1 0 0 1 0 0\nTEXTURE_COORDINATES t 2 float\n0 0 0 1 1 0 1 1\n" +
            "CELL_DATA 1\nTENSORS s float\n1 2 3 4 5 6 7 8 9\nCOLOR_SCALARS c 3\n0.5 0.5 1\nGLOBAL_IDS g vtkIdType\n4\nFIELD f 1\nb 1 1 bit\n1\n" +
            "METADATA\nINFORMATION 0");
  CHECK(panels.vertices.size() == 4);
  CHECK(panels.panels.size() == 1);
  CHECK(panels.part.empty());
}

TEST_CASE("vtk: all other data are skipped, in binary by their size") {
  const auto big = std::endian::big;
  std::string contents = "# vtk DataFile Version 4.2\r\nmade\r\nBINARY\r\nDATASET POLYDATA\r\nFIELD FieldData 2\r\nTIME 1 1 double\r\n";
  fixtures::put_number(contents, 0.5, big);
  // lengths of strings: of one byte (3), two (2) and four (1), by the two highest bits
  contents +=
      "\nnames 1 3 string\n\xc5hello\x80\x64" + std::string(100, '\n') + std::string("\x40\x00\x40\x00", 4) + std::string(0x4000, 'x') + "\nPOINTS 3 float\n";
  for (const float x : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f}) fixtures::put_number(contents, x, big);
  contents += "\nPOLYGONS 1 4\n";
  for (const int v : {3, 0, 1, 2}) fixtures::put_number(contents, std::int32_t{v}, big);
  contents += "\nPOINT_DATA 3\nSCALARS s short 1\nLOOKUP_TABLE mine\n" + std::string(6, '\n') + "\nLOOKUP_TABLE mine 1\n\n\n\n\n\nCOLOR_SCALARS c 3\n" +
              std::string(9, 'C') + "\nVECTORS v float\n" + std::string(36, 'V') +
              "\nCELL_DATA 1\nFIELD f 3\nbits 9 1 bit\nbb\nMETADATA\nINFORMATION 0\n\nids 1 1 vtkIdType\n" + std::string(4, 'i') +
              "\npart 1 1 unsigned_char\n\x09\n";
  const Panels panels = parse(contents);
  CHECK(panels.vertices == std::vector<Vec3d>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  CHECK(panels.panels == std::vector<std::array<int, 4>>{{0, 1, 2, -1}});
  CHECK(panels.part_names == std::vector<std::string>{"part 9"});
}

TEST_CASE("vtk: a truncated file of any form is read or refused in one sentence") {
  for (const std::string& whole : all_forms(named_tetrahedron())) {
    for (std::size_t length = 0; length < whole.size(); ++length) {
      check_read_or_refused(whole.substr(0, length), length < whole.find("CELL_DATA") - 2 ? 0 : 4);
    }
  }
  const std::string text = vtk_legacy(named_tetrahedron(), {});
  check_refused(
      text.substr(0, text.find("POLYGONS") - 4),
      "hull.vtk:5: POINTS needs 12 numbers, more than the 22 bytes after it can hold; the file is truncated or the count is damaged: export it again.");
  check_refused(text.substr(0, text.find("POLYGONS") + 10), "hull.vtk:7: the file ends in POLYGONS; it is truncated: export it again.");
  const std::string binary = vtk_legacy(named_tetrahedron(), {.is_binary = true});
  check_refused(binary.substr(0, binary.find("POLYGONS") - 2),
                "hull.vtk: POINTS needs 12 numbers, more than the 95 bytes after it can hold; the file is truncated or the count is damaged: export it again.");
}

TEST_CASE("vtk: counts beyond the file size are refused without allocating memory") {
  const std::string text = vtk_legacy(named_tetrahedron(), {}), modern = vtk_legacy(named_tetrahedron(), {.has_offsets = true});
  const auto refused = [](const std::string& contents, const char* begin) {
    CHECK_THROWS_WITH_AS(parse(contents), doctest::Contains(begin), InputError);
    check_read_or_refused(contents, 0);
  };
  refused(with(text, "POINTS 4", "POINTS 4000000000"), "hull.vtk:5: POINTS states 4000000000, more than the 129 bytes after it can hold;");
  refused(with(text, "POINTS 4", "POINTS 99"), "hull.vtk:5: POINTS needs 297 numbers, more than the 129 bytes after it can hold;");
  refused(with(text, "POINTS 4", "POINTS -4"), "hull.vtk:5: POINTS has `-4` where a count is expected; correct the file or export it again.");
  refused(with(text, "POINTS 4", "POINTS"), "hull.vtk:5: POINTS has `double` where a count is expected; correct the file or export it again.");
  refused(with(text, "POLYGONS 4 16", "POLYGONS 4 9223372036854775807"), "hull.vtk:7: POLYGONS states 9223372036854775807, more than the ");
  refused(with(text, "POLYGONS 4 16", "POLYGONS 9223372036854775807 16"), "hull.vtk:7: POLYGONS states 9223372036854775807, more than the ");
  refused(with(text, "POLYGONS 4 16", "POLYGONS 5 16"),
          "hull.vtk:8: POLYGONS has a cell (number 4, counted from 0) with more points than the section; export the file again.");
  refused(with(text, "POLYGONS 4 16", "POLYGONS 3 16"), "hull.vtk:8: POLYGONS has more numbers than its cells; export the file again.");
  refused(with(text, "\n3 0 2 1", "\n9 0 2 1"),
          "hull.vtk:8: POLYGONS has a cell (number 3, counted from 0) with more points than the section; export the file again.");
  refused(with(text, "\n3 0 2 1", "\n-3 0 2 1"),
          "hull.vtk:8: POLYGONS has a cell (number 0, counted from 0) with more points than the section; export the file again.");
  refused(with(text, "PartId 1 4", "PartId 4000000000 4000000000"), "hull.vtk:11: the file ends in the array `PartId`; it is truncated: export it again.");
  refused(with(text, "FieldData 1", "FieldData 4000000000"), "hull.vtk:13: the file ends in FIELD; it is truncated: export it again.");
  refused(with(modern, "\n0 3 6", "\n1 3 6"), "hull.vtk:11: POLYGONS has OFFSETS that do not begin with 0; export the file again.");
  refused(with(modern, "\n0 3 6", "\n0 7 6"), "hull.vtk: cell 1 (counted from 0) has an offset that is out of order; correct the file or export it again.");
  refused(with(modern, "CONNECTIVITY", "CONECTIVITY"), "hull.vtk:9: POLYGONS has no CONNECTIVITY after its OFFSETS; it is truncated: export it again.");
  refused(with(modern, "OFFSETS vtktypeint64", "OFFSETS double"),
          "hull.vtk:8: POLYGONS has numbers of type float or double, where integers are expected; export the file again.");
}

TEST_CASE("vtk: undefined points and coordinates that are not finite are refused") {
  const std::string text = vtk_legacy(named_tetrahedron(), {});
  check_refused(with(text, "\n3 0 2 1", "\n3 0 2 4"),
                "hull.vtk: cell 0 (counted from 0) has point 4, but there are 4, counted from 0; correct the file or export it again.");
  check_refused(with(text, "\n3 0 2 1", "\n3 0 2 x"), "hull.vtk:8: POLYGONS has `x` where an integer is expected; correct the file or export it again.");
  Mesh bad = named_tetrahedron();
  bad.vertices[2].y = std::numeric_limits<double>::quiet_NaN();
  check_refused(vtk_legacy(bad, {}), "hull.vtk:6: POINTS has `nan` where a finite number is expected; correct the file or export it again.");
  bad.vertices[2].y = -std::numeric_limits<double>::infinity();
  check_refused(vtk_legacy(bad, {.is_binary = true}), "hull.vtk: POINTS has a number that is not finite; repair the mesh and export it again.");
}

TEST_CASE("vtk: binary declared as text and text declared as binary are refused") {
  check_refused(with(vtk_legacy(named_tetrahedron(), {.is_binary = true}), "BINARY", "ASCII"),
                "hull.vtk:6: POINTS has `????????????????????????…` where a finite number is expected; correct the file or export it again.");
  check_refused(with(vtk_legacy(named_tetrahedron(), {}), "ASCII", "BINARY"),
                "hull.vtk: `ata` appears where a section is expected; a count before it or the file is damaged: export it again.");
}

TEST_CASE("vtk: other formats, kinds of data and types of numbers are refused by name") {
  check_refused("", "hull.vtk:1: a legacy VTK file begins with `# vtk DataFile Version`; the contents do not match the file extension.");
  check_refused("<VTKFile>", "hull.vtk:1: a legacy VTK file begins with `# vtk DataFile Version`; the contents do not match the file extension.");
  check_refused("# vtk DataFile Version 3.0\nt\nTEXT\n", "hull.vtk:4: the third line has `TEXT`, but must be ASCII or BINARY; export the file again.");
  check_refused("# vtk DataFile Version 3.0\nt\nASCII\nPOINTS 3 float\n", "hull.vtk:4: the fourth line must name the DATASET; export the file again.");
  check_refused(
      header("STRUCTURED_POINTS"),
      "hull.vtk:4: the DATASET is `STRUCTURED_POINTS`, but surfaces are POLYDATA or UNSTRUCTURED_GRID; apply the filter Extract Surface in ParaView and "
      "save as .vtp.");
  check_refused(header("POLYDATA") + "POINTS 1 bit\n1 1 1\n",
                "hull.vtk:5: POINTS has numbers of type `bit`, which is not supported; export it as int, vtktypeint64, float or double.");
  check_refused(header("POLYDATA") + points + "POINT_DATA 4\nFIELD f 1\na 1 4 variant\n",
                "hull.vtk:10: the array `a` has values of type `variant`, which cannot be skipped; export the file without them.");
  check_refused(header("POLYDATA") + points + "CELLS 1 4\n3 0 1 2\n",
                "hull.vtk:8: `CELLS` appears where a section is expected; a count before it or the file is damaged: export it again.");
  check_refused(header("POLYDATA") + points + "POLYGONS 1 4\n3 0 1 2\nPOLYGONS 1 4\n3 0 1 2\n", "hull.vtk:10: POLYGONS is given twice; export the file again.");
  check_refused(header("UNSTRUCTURED_GRID") + points + "CELLS 1 4\n3 0 1 2\nCELL_TYPES 2\n5 5\n",
                "hull.vtk:12: CELL_TYPES has 2 types for 1 cells; export the file again.");
  CHECK(parse(header("POLYDATA") + "POINTS 0 float\nPOLYGONS 0 0\n").panels.empty());
}

TEST_CASE("vtk: thousands of damaged files are read or refused, never more") {
  std::mt19937_64 random(1);
  const std::vector<std::string> good = all_forms(named_tetrahedron());
  for (int trial = 0; trial < 4000; ++trial) check_read_or_refused(fixtures::damaged(good[random() % good.size()], random), 300);
}
