#include "mesh_io/ply.hpp"

#include <doctest/doctest.h>

#include <limits>
#include <random>

#include "base/error.hpp"
#include "fixtures/polygon_files.hpp"
#include "fixtures/read_or_refused.hpp"
#include "mesh_io/obj.hpp"

using namespace fccda;
using fixtures::Mesh;
using fixtures::with;

namespace {

Panels parse(const std::string& contents) { return parse_ply(contents, "hull.ply"); }
void check_refused(const std::string& contents, const char* sentence) { CHECK_THROWS_WITH_AS(parse(contents), sentence, InputError); }
void check_read_or_refused(const std::string& contents, std::size_t most_panels) {
  fixtures::check_read_or_refused("hull.ply", most_panels, [&] { return parse(contents).panels.size(); });
}

std::vector<std::string> all_forms(const Mesh& mesh) {
  return {fixtures::ply_text(mesh), fixtures::ply_binary(mesh, std::endian::little), fixtures::ply_binary(mesh, std::endian::big)};
}

const std::string two_vertices_header = "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty float z\nend_header\n";

}  // namespace

TEST_CASE("ply: text and both binary forms are read back bitwise, with the panels that OBJ gives for the same polygons") {
  for (const Mesh& mesh : fixtures::polygon_meshes()) {
    const Panels expected = parse_obj(fixtures::obj_text(mesh), "oracle.obj");
    REQUIRE(expected.vertices == mesh.vertices);
    for (const std::string& contents : all_forms(mesh)) {
      const Panels panels = parse(contents);
      CHECK(panels.vertices == mesh.vertices);
      CHECK(panels.panels == expected.panels);
      CHECK(panels.part.empty());
    }
  }
}

TEST_CASE("ply: properties and elements may come in any order, of any type, with others between them") {
  const Panels panels = parse(
      "ply\r\nformat ascii 1.0\r\ncomment by hand\r\nobj_info none\r\nelement material 1\r\nproperty list uchar float shades\r\nelement face 2\r\n"
      "property uchar red\r\nproperty list ushort uint vertex_index\r\nproperty list int double texcoord\r\nelement vertex 4\r\nproperty float nx\r\n"
      "property int16 z\r\nproperty list uchar int neighbours\r\nproperty float32 x\r\nproperty uint8 y\r\nelement edge 1\r\nproperty int vertex1\r\n"
      "property int vertex2\r\nelement nothing 4000000000\r\nend_header\r\n"
      "2 0.5 nan\r\n255 3 0 1 2 0\r\n255 3 0 2 3 2 0.5 0.5\r\nnan -5 1 7 0 0\r\n0 -5 0 1 0\r\n0 -5 2 1 2 1 1\r\n0 -5 0 0.125 1\r\n0 1\r\n\r\n");
  CHECK(panels.vertices == std::vector<Vec3d>{{0, 0, -5}, {1, 0, -5}, {1, 1, -5}, {0.125, 1, -5}});
  CHECK(panels.panels == std::vector<std::array<int, 4>>{{0, 1, 2, -1}, {0, 2, 3, -1}});
}

TEST_CASE("ply: binary properties of every type are skipped by their size") {
  const auto little = std::endian::little;
  std::string contents =
      "ply\nformat binary_little_endian 1.0\nelement other 2\nproperty short a\nproperty list int double b\nelement vertex 3\nproperty char c\n"
      "property float x\nproperty uint d\nproperty double y\nproperty list ushort short e\nproperty int z\nelement face 1\nproperty double quality\n"
      "property list uint ushort vertex_indices\nproperty uchar red\nend_header\n";
  for (const int length : {0, 3}) {
    fixtures::put_number(contents, std::int16_t{1}, little);
    fixtures::put_number(contents, std::int32_t{length}, little);
    for (int k = 0; k < length; ++k) fixtures::put_number(contents, std::numeric_limits<double>::quiet_NaN(), little);
  }
  for (int v = 0; v < 3; ++v) {
    contents += 'c';
    fixtures::put_number(contents, 0.5f * static_cast<float>(v), little);
    fixtures::put_number(contents, std::uint32_t{7}, little);
    fixtures::put_number(contents, v * v + 0.25, little);
    fixtures::put_number(contents, std::uint16_t{1}, little);
    fixtures::put_number(contents, std::int16_t{9}, little);
    fixtures::put_number(contents, std::int32_t{-v}, little);
  }
  fixtures::put_number(contents, 1.0, little);
  fixtures::put_number(contents, std::uint32_t{3}, little);
  for (const int v : {2, 0, 1}) fixtures::put_number(contents, static_cast<std::uint16_t>(v), little);
  contents += 'r';
  const Panels panels = parse(contents);
  CHECK(panels.vertices == std::vector<Vec3d>{{0, 0.25, 0}, {0.5, 1.25, -1}, {1, 4.25, -2}});
  CHECK(panels.panels == std::vector<std::array<int, 4>>{{2, 0, 1, -1}});
}

TEST_CASE("ply: a truncated file of any form is refused in one sentence") {
  for (const std::string& whole : all_forms(fixtures::mesh_of(fixtures::tetrahedron()))) {
    const std::size_t last_number = whole.find_last_not_of('\n');
    for (std::size_t length = 0; length < last_number; ++length) {
      CHECK_THROWS_AS(parse(whole.substr(0, length)), InputError);
      check_read_or_refused(whole.substr(0, length), 0);
    }
  }
  const std::string text = fixtures::ply_text(fixtures::mesh_of(fixtures::tetrahedron()));
  check_refused(text.substr(0, text.find("property")), "hull.ply:5: the file ends in its header, before `end_header`; it is truncated: export it again.");
  check_refused(text.substr(0, text.find("3 2 0 3")) + "3 0",
                "hull.ply:18: the file ends in face 4 of 4; it is truncated or a count is damaged: export it again.");
  const std::string binary = fixtures::ply_binary(fixtures::mesh_of(fixtures::tetrahedron()), std::endian::big);
  check_refused(binary.substr(0, binary.size() - 1), "hull.ply: the file ends in face 4 of 4; it is truncated or a count is damaged: export it again.");
}

TEST_CASE("ply: counts beyond the file size are refused without allocating memory") {
  const std::string text = fixtures::ply_text(fixtures::mesh_of(fixtures::tetrahedron()));
  check_refused(with(text, "vertex 4", "vertex 4000000000"),
                "hull.ply:11: the header states 4000000000 of `vertex`, more than the 56 bytes after it can hold; the file is truncated or the count is "
                "damaged: export it again.");
  check_refused(
      with(text, "face 4", "face 99"),
      "hull.ply:14: the header states 99 of `face`, more than the 33 bytes after it can hold; the file is truncated or the count is damaged: export it again.");
  check_refused(with(text, "vertex 4", "vertex -4"),
                "hull.ply:4: the element `vertex` has `-4` where a count is expected; correct the file or export it again.");
  check_refused(with(text, "vertex 4", "vertex 99999999999999999999"),
                "hull.ply:4: the element `vertex` has `99999999999999999999` where a count is expected; correct the file or export it again.");
  check_refused(with(text, "\n3 0 2 1", "\n4000000000 0 2 1"),
                "hull.ply:15: the file ends in face 1 of 4; it is truncated or a count is damaged: export it again.");
  check_refused(with(text, "\n3 0 2 1", "\n-3 0 2 1"),
                "hull.ply:15: face 1 has a list whose count is negative or not an integer; correct the file or export it again.");
}

TEST_CASE("ply: faces with undefined vertices, with two vertices or crossing sides are refused") {
  const std::string text = fixtures::ply_text(fixtures::mesh_of(fixtures::tetrahedron()));
  for (const char* vertex : {"4", "-1", "0.5", "1e300"}) {
    check_refused(with(text, "\n3 0 2 1", std::string("\n3 0 2 ") + vertex),
                  "hull.ply:15: face 1 has a vertex number outside the range of the 4, counted from 0; correct the file or export it again.");
  }
  check_refused(with(text, "\n3 0 2 1", "\n2 0 2"), "hull.ply:15: face 1 has 2 vertices, but needs at least three; delete or correct it.");
  Mesh crossed;
  crossed.vertices = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {4, 4, 0}, {2, 5, 0}};
  crossed.add_polygon({0, 1, 2, 3, 4});
  for (const std::string& contents : all_forms(crossed)) {
    check_refused(contents, "hull.ply: face 1 with 5 vertices cannot be triangulated because its sides cross; triangulate the mesh before exporting it.");
  }
}

TEST_CASE("ply: coordinates that are not finite are refused with the vertex") {
  Mesh bad = fixtures::mesh_of(fixtures::tetrahedron());
  bad.vertices[2].y = std::numeric_limits<double>::quiet_NaN();
  check_refused(fixtures::ply_text(bad), "hull.ply:13: vertex 3 has `nan` where a finite number is expected; correct the file or export it again.");
  check_refused(fixtures::ply_binary(bad, std::endian::little), "hull.ply: vertex 3 has a number that is not finite; repair the mesh and export it again.");
  bad.vertices[2].y = std::numeric_limits<double>::infinity();
  check_refused(fixtures::ply_binary(bad, std::endian::big), "hull.ply: vertex 3 has a number that is not finite; repair the mesh and export it again.");
}

TEST_CASE("ply: binary declared as text, text declared as binary and the wrong byte order are refused") {
  const Mesh mesh = fixtures::mesh_of(fixtures::tetrahedron());
  check_refused(with(fixtures::ply_binary(mesh, std::endian::little), "binary_little_endian", "ascii"),
                "hull.ply:11: vertex 1 has `????????????????????????…` where a finite number is expected; correct the file or export it again.");
  check_refused(
      with(fixtures::ply_text(mesh), "ascii", "binary_big_endian"),
      "hull.ply: the header states 4 of `vertex`, more than the 56 bytes after it can hold; the file is truncated or the count is damaged: export it again.");
  CHECK_THROWS_AS(parse(with(fixtures::ply_binary(mesh, std::endian::little), "little", "big")), InputError);
}

TEST_CASE("ply: invalid headers are refused with the reason") {
  const std::string text = fixtures::ply_text(fixtures::mesh_of(fixtures::tetrahedron()));
  check_refused("", "hull.ply:1: a PLY file begins with `ply`; the contents do not match the file extension.");
  check_refused("solid hull\n", "hull.ply:1: a PLY file begins with `ply`; the contents do not match the file extension.");
  check_refused("ply\n", "hull.ply:2: the format, such as `format ascii 1.0`, must be in the second line of a PLY file; export it again.");
  check_refused(with(text, "ascii", "xml"),
                "hull.ply:2: the format is `xml`, but must be ascii, binary_little_endian or binary_big_endian; export the file again.");
  check_refused(with(text, "double", "real"),
                "hull.ply:5: the property has the type `real`, but PLY has char, short, int, their unsigned u…, float and double.");
  check_refused(with(text, "uchar", "float"), "hull.ply:9: the count of a list must be of an integer type; export the file again.");
  check_refused(with(text, "element face", "element vertex"), "hull.ply:8: the header has `vertex` twice; export the file again.");
  check_refused(with(text, "element vertex 4\n", ""), "hull.ply:4: the property comes before the first element; export the file again.");
  check_refused(with(text, "comment", "remark"),
                "hull.ply:3: `remark` is not a PLY header statement; these are element, property, comment, obj_info and end_header.");
  check_refused(with(text, "double y", "double w"), "hull.ply:11: the element `vertex` has no property `y`; export the file again with x, y and z.");
  check_refused(with(text, "vertex_indices", "corners"), "hull.ply:14: the element `face` has no list `vertex_indices`; export the file again.");
}

TEST_CASE("ply: triangle strips are refused by name, and a point cloud has no panels") {
  check_refused(with(two_vertices_header, "end_header", "element tristrips 1\nproperty list int int vertex_indices\nend_header") + "0 0 0 1 1 1 3 0 1 0\n",
                "hull.ply:10: triangle strips (`tristrips`) are not supported in PLY; export faces.");
  CHECK(parse(two_vertices_header + "0 0 0 1 1 1\n").panels.empty());
  check_refused(two_vertices_header + "0 0 0 1 1 1 2\n", "hull.ply:8: there is data after the last element; a count or the file is damaged: export it again.");
}

TEST_CASE("ply: thousands of damaged files are read or refused, never more") {
  std::mt19937_64 random(1);
  const std::vector<std::string> good = all_forms(fixtures::mesh_of(fixtures::tetrahedron()));
  for (int trial = 0; trial < 3000; ++trial) check_read_or_refused(fixtures::damaged(good[random() % good.size()], random), 300);
}
