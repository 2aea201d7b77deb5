#include "mesh_io/vtk/vtp.hpp"

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
using fixtures::Mesh;
using fixtures::vtk_xml;
using fixtures::with;
using fixtures::XmlForm;
using Arrays = XmlForm::Arrays;

namespace {

Panels parse(const std::string& contents) { return panels_of(parse_vtp(contents, "hull.vtp"), "hull.vtp"); }
void check_refused(const std::string& contents, const char* sentence) { CHECK_THROWS_WITH_AS(parse(contents), sentence, InputError); }
void check_read_or_refused(const std::string& contents, std::size_t most_panels) {
  fixtures::check_read_or_refused("hull.vtp", most_panels, [&] { return parse(contents).panels.size(); });
}

std::vector<XmlForm> all_forms() {
  std::vector<XmlForm> forms = fixtures::xml_forms(false);
  for (const XmlForm& form : fixtures::xml_forms(true)) forms.push_back(form);
  return forms;
}

/// A tetrahedron whose faces belong to two parts.
Mesh named_tetrahedron() {
  Mesh mesh = fixtures::mesh_of(fixtures::tetrahedron());
  mesh.array = "PartId";
  mesh.part = {3, 3, 12, 12};
  return mesh;
}
std::string text() { return vtk_xml(named_tetrahedron(), {}); }

}  // namespace

TEST_CASE("vtp: every form is read back bitwise, with the panels that OBJ gives for the same polygons") {
  for (const Mesh& mesh : fixtures::polygon_meshes()) {
    const Panels expected = parse_obj(fixtures::obj_text(mesh), "oracle.obj");
    for (const XmlForm& form : all_forms()) {
      const Panels panels = parse(vtk_xml(mesh, form));
      CHECK(panels.vertices == mesh.vertices);
      CHECK(panels.panels == expected.panels);
      CHECK(panels.part.empty());
    }
  }
}

TEST_CASE("vtp: in every form an integer cell array defines the parts") {
  for (const XmlForm& form : all_forms()) {
    const Panels panels = parse(vtk_xml(named_tetrahedron(), form));
    CHECK(panels.part_names == std::vector<std::string>{"part 3", "part 12"});
    CHECK(panels.part == std::vector{0, 0, 1, 1});
  }
  const std::string one_more = "<CellData>\n<DataArray type=\"UInt8\" Name=\"part\">4 4 4 5</DataArray>";
  CHECK(parse(with(text(), "<CellData>", one_more)).part_names == std::vector<std::string>{"part 4", "part 5"});
  CHECK(parse(with(text(), "<CellData>", with(one_more, "part", "medit:ref"))).part_names == std::vector<std::string>{"part 3", "part 12"});
  CHECK(parse(with(text(), "Int32", "Float32")).part.empty());
  check_refused(with(text(), " 12\n", "\n"), "hull.vtp:7: CellData/PartId has 3 numbers, but needs 4; correct the file or export it again.");
}

TEST_CASE("vtp: solids contribute their boundary faces") {
  Mesh mesh;
  mesh.vertices = fixtures::unit_cube().vertices;
  mesh.cells = {{12, {0, 1, 3, 2, 4, 5, 7, 6}}, {3, {0, 1}}};
  for (const XmlForm& form : fixtures::xml_forms(true)) {
    const Surface surface(parse(vtk_xml(mesh, form)));
    CHECK(surface.is_closed());
    CHECK(surface.report().volume == fixtures::relative(1, 1e-12));
  }
}

TEST_CASE("vtp: pieces are concatenated, each with its own points") {
  const Panels panels = parse(vtk_xml(named_tetrahedron(), {.arrays = Arrays::appended_raw, .pieces = 3}));
  CHECK(panels.vertices.size() == 12);
  CHECK(panels.panels.size() == 12);
  CHECK(panels.panels[8] == std::array{8, 10, 9, -1});
  CHECK(panels.part_names == std::vector<std::string>{"part 3", "part 12"});
}

TEST_CASE("vtp: vertices and lines are skipped but counted first in cell data, strips last, and other arrays have no effect") {
  const Panels panels = parse(
      "\xEF\xBB\xBF<VTKFile type=\"PolyData\">\n<PolyData><FieldData><DataArray type=\"String\" Name=\"Points\" format=\"odd\">7</DataArray></FieldData>"
      "<Piece NumberOfPoints='4' NumberOfVerts='1' NumberOfLines='1' NumberOfStrips='1' NumberOfPolys='1'>"
      "<PointData><DataArray type='Bit' Name='part' format='binary'>?</DataArray></PointData>"
      "<CellData><DataArray type='Float64' Name='part'>x</DataArray><DataArray type='Int8' Name='part'>1 2 3 4</DataArray></CellData>"
      "<Points><DataArray type='Float32' NumberOfComponents='3'>0 0 0 1 0 0 0 1 0 1 1 0<InformationKey name='L2'><Value>7</Value></InformationKey>\n"
      "</DataArray></Points><Verts><DataArray type='Int32' Name='connectivity'>x</DataArray></Verts>"
      "<Strips><DataArray type='Int32' Name='connectivity'>0 1 2 3</DataArray><DataArray type='Int32' Name='offsets'>4</DataArray></Strips>"
      "<Polys><DataArray type='Int32' Name='connectivity'>0 1 2</DataArray><DataArray type='Int32' Name='offsets'>3</DataArray></Polys>"
      "</Piece></PolyData></VTKFile>");
  CHECK(panels.vertices[3] == Vec3d{1, 1, 0});
  CHECK(panels.panels == std::vector<std::array<int, 4>>{{0, 1, 2, -1}, {0, 1, 2, -1}, {2, 1, 3, -1}});
  CHECK(panels.part_names == std::vector<std::string>{"part 3", "part 4"});
}

TEST_CASE("vtp: byte counts may be padded separately, as some programs encode them") {
  const Mesh mesh = fixtures::mesh_of(fixtures::tetrahedron());
  std::string coordinates, count;
  for (const Vec3d& v : mesh.vertices)
    for (std::size_t axis = 0; axis < 3; ++axis) fixtures::put_number(coordinates, v[axis], std::endian::little);
  fixtures::put_number(count, std::uint32_t{96}, std::endian::little);
  const std::string contents = vtk_xml(mesh, {.arrays = Arrays::base64, .has_wide_counts = false});
  CHECK(parse(with(contents, fixtures::base64(count + coordinates), fixtures::base64(count) + fixtures::base64(coordinates))).vertices == mesh.vertices);
}

TEST_CASE("vtp: a truncated file of any form is refused in one sentence, or read where only closing tags are missing") {
  const std::vector<XmlForm> forms = all_forms();
  for (std::size_t f = 0; f < forms.size(); f += 5) {  // 5 and the number of choices are coprime: every choice occurs
    const std::string whole = vtk_xml(named_tetrahedron(), forms[f]);
    const std::size_t closing = whole.find("\n</AppendedData>");
    const std::size_t needed = std::min(closing, whole.size() - 1);
    for (std::size_t length = 0; length < whole.size(); ++length) {
      check_read_or_refused(whole.substr(0, length), length < needed ? 0 : 4);
    }
  }
  check_refused(text().substr(0, text().find("</Polys>")), "hull.vtp:22: the file ends inside `Polys`; it is truncated: export it again.");
}

TEST_CASE("vtp: counts beyond the file size are refused without allocating memory") {
  check_refused(with(text(), "Points=\"4\"", "Points=\"4000000000\""),
                "hull.vtp:12: Points needs 12000000000 numbers, more than the file can hold; it is truncated or a count is damaged: export it again.");
  check_refused(with(text(), "Polys=\"4\"", "Polys=\"4000000000\""),
                "hull.vtp:7: CellData/PartId needs 4000000000 numbers, more than the file can hold; it is truncated or a count is damaged: export it again.");
  check_refused(with(text(), "Points=\"4\"", "Points=\"-4\""),
                "hull.vtp:5: NumberOfPoints is `-4`, where a count is expected; correct the file or export it again.");
  check_refused(with(text(), "Points=\"4\"", "Points=\"18446744073709551615\""),
                "hull.vtp:5: NumberOfPoints is `18446744073709551615`, where a count is expected; correct the file or export it again.");
  check_refused(with(text(), "Points=\"4\"", "Points=\"5\""), "hull.vtp:12: Points has 12 numbers, but needs 15; correct the file or export it again.");
  check_refused(with(text(), " 3 6 9 12", " 3 6 9 13"), "hull.vtp:17: Polys/connectivity has 12 numbers, but needs 13; correct the file or export it again.");
  check_refused(with(text(), " 3 6 9 12", " 3 6 9 -1"), "hull.vtp:20: Polys/offsets ends with a negative number; correct the file or export it again.");
  const std::string raw = vtk_xml(named_tetrahedron(), {.arrays = Arrays::appended_raw});
  check_refused(with(raw, "offset=\"0\"", "offset=\"4000000000\""), "hull.vtp:7: CellData/PartId is truncated or damaged; export the file again.");
  check_refused(with(raw, "Points=\"4\"", "Points=\"3\""), "hull.vtp:10: Points has 96 bytes, but needs 72; export the file again.");
}

TEST_CASE("vtp: compressed arrays with false sizes or damaged data are refused") {
  const std::string packed = vtk_xml(fixtures::mesh_of(fixtures::tetrahedron()), {.arrays = Arrays::appended_raw, .has_wide_counts = false, .is_packed = true});
  const std::size_t first = packed.find("\n_") + 2;  // blocks, bytes of a block, of the last, compressed bytes of each
  const auto damaged = [&](std::size_t number, const char* bytes) { return std::string(packed).replace(first + 4 * number, 4, bytes, 4); };
  const char* sum = "hull.vtp:7: Points is compressed in blocks whose sizes do not add up to 96 bytes; export the file again.";
  check_refused(damaged(0, "\xff\xff\xff\xff"), sum);
  check_refused(damaged(0, "\0\0\0\0"), sum);
  check_refused(damaged(1, "\0\0\0\0"), sum);
  check_refused(damaged(2, "\xff\xff\xff\xff"), sum);
  check_refused(damaged(3, "\xff\xff\xff\xff"), "hull.vtp:7: Points is truncated or damaged; export the file again.");
  check_refused(damaged(3, "\x09\0\0\0"), "hull.vtp:7: Points is damaged: block 1 of 1 does not decompress; export the file again.");
  check_refused(damaged(4, "\xff\xff\xff\xff"), "hull.vtp:7: Points is damaged: block 1 of 1 does not decompress; export the file again.");
}

TEST_CASE("vtp: many pieces that refer to the same compressed bytes are refused before they fill the memory") {
  Mesh mesh;
  mesh.vertices.resize(40'000);  // zeros, which compress well
  const std::string one = vtk_xml(mesh, {.arrays = Arrays::appended_raw, .is_packed = true});
  const std::size_t begin = one.find("<Piece"), end = one.find("</PolyData>");
  std::string many = one.substr(0, begin);
  for (int piece = 0; piece < 500; ++piece) many += one.substr(begin, end - begin);
  CHECK_THROWS_WITH_AS(parse(many + one.substr(end)), doctest::Contains("Points needs 120000 numbers, more than the file can hold;"), InputError);
}

TEST_CASE("vtp: invalid numbers, undefined points and missing arrays are refused") {
  Mesh bad = named_tetrahedron();
  bad.vertices[2].y = std::numeric_limits<double>::quiet_NaN();
  check_refused(vtk_xml(bad, {}), "hull.vtp:13: Points has `nan` where a finite number is expected; correct the file or export it again.");
  check_refused(vtk_xml(bad, {.arrays = Arrays::base64}), "hull.vtp:12: Points has a number that is not finite; repair the mesh and export it again.");
  check_refused(with(text(), " 0 2 1 0", " 0 2 4 0"),
                "hull.vtp: cell 0 (counted from 0) has point 4, but there are 4, counted from 0; correct the file or export it again.");
  check_refused(with(text(), " 0 2 1 0", " 0 2 1.5 0"),
                "hull.vtp:18: Polys/connectivity has `1.5` where an integer is expected; correct the file or export it again.");
  check_refused(with(text(), "\"offsets\"", "\"ends\""), "hull.vtp:5: the piece has no array `offsets` in `Polys`; export the file again.");
  check_refused(with(with(text(), "<Points>", "<Point>"), "</Points>", "</Point>"), "hull.vtp:5: the piece has no array in `Points`; export the file again.");
  check_refused(with(text(), "Components=\"3\"", "Components=\"2\""), "hull.vtp:12: the points have `2` components, but need 3; export the file again.");
  check_refused(with(text(), "\"Int64", "\"Float64"),
                "hull.vtp:17: Polys/connectivity has numbers of type Float32 or Float64, where integers are expected; export the file again.");
  check_refused(with(text(), "Float64", "Float16"), "hull.vtp:12: Points has numbers of type `Float16`, which is not supported; export the file again.");
}

TEST_CASE("vtp: other formats, data sets, compressors and forms are refused by name") {
  check_refused("", "hull.vtp:1: a VTK file in XML begins with `<VTKFile`; the contents do not match the file extension.");
  check_refused("<html>", "hull.vtp:1: a VTK file in XML begins with `<VTKFile`; the contents do not match the file extension.");
  check_refused(
      with(text(), "type=\"PolyData", "type=\"ImageData"),
      "hull.vtp:3: the file is of type `ImageData`, but surfaces are PolyData or UnstructuredGrid; apply the filter Extract Surface in ParaView and save "
      "as .vtp.");
  check_refused(with(text(), "<VTKFile", "<VTKFile compressor=\"vtkLZ4DataCompressor\""),
                "hull.vtp:3: compressor is `vtkLZ4DataCompressor`, but must be `vtkZLibDataCompressor`; export the file accordingly.");
  check_refused(with(text(), "UInt64", "UInt16"), "hull.vtp:3: header_type is `UInt16`, but must be `UInt32` or `UInt64`; export the file accordingly.");
  check_refused(with(text(), "LittleEndian", "Middle"),
                "hull.vtp:3: byte_order is `Middle`, but must be `LittleEndian` or `BigEndian`; export the file accordingly.");
  check_refused(with(text(), "ascii", "text"), "hull.vtp:7: format is `text`, but must be `ascii` or `binary` or `appended`; export the file accordingly.");
  const std::string raw = vtk_xml(named_tetrahedron(), {.arrays = Arrays::appended_raw});
  check_refused(with(raw, "\"raw\"", "\"hex\""), "hull.vtp:18: encoding is `hex`, but must be `raw` or `base64`; export the file accordingly.");
  check_refused(with(raw, "\n_", "\n"), "hull.vtp:18: the appended data do not begin with `_`; the file is damaged: export it again.");
  check_refused(with(text(), "</Polys>", "</Poly>"), "hull.vtp:23: `/Poly` does not match the open element `Polys`; the file is damaged: export it again.");
  // arrays nested in an array are ignored
  check_refused(
      "<VTKFile type='PolyData'><Piece NumberOfPoints='1' NumberOfPolys='1'><Points><DataArray type='Int8' NumberOfComponents='3'><Polys>"
      "<DataArray type='Int8' Name='offsets'/></Polys>0 0 0</DataArray></Points></Piece></VTKFile>",
      "hull.vtp:1: the piece has no array `offsets` in `Polys`; export the file again.");
  std::string deep = "<VTKFile type=\"PolyData\">";
  for (int k = 0; k < 100'000; ++k) deep += "<a>";
  check_refused(deep, "hull.vtp:1: elements are nested more deeply than in any VTK file; export the file again.");
}

TEST_CASE("vtp: thousands of damaged files are read or refused, never more") {
  std::mt19937_64 random(1);
  std::vector<std::string> good;
  for (const XmlForm& form : all_forms()) good.push_back(vtk_xml(named_tetrahedron(), form));
  for (int trial = 0; trial < 5000; ++trial) check_read_or_refused(fixtures::damaged(good[random() % good.size()], random), 300);
}
