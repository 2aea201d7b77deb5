#include "mesh_io/off.hpp"

#include <doctest/doctest.h>

#include <random>

#include "base/error.hpp"
#include "fixtures/polygon_files.hpp"
#include "fixtures/read_or_refused.hpp"
#include "mesh_io/obj.hpp"

using namespace fccda;
using fixtures::Mesh;
using fixtures::with;

namespace {

Panels parse(const std::string& contents) { return parse_off(contents, "hull.off"); }
void check_refused(const std::string& contents, const char* sentence) { CHECK_THROWS_WITH_AS(parse(contents), sentence, InputError); }
void check_read_or_refused(const std::string& contents, std::size_t most_panels) {
  fixtures::check_read_or_refused("hull.off", most_panels, [&] { return parse(contents).panels.size(); });
}
const std::string body = "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
std::string tetrahedron() { return fixtures::off_text(fixtures::mesh_of(fixtures::tetrahedron())); }

}  // namespace

TEST_CASE("off: vertices are read back bitwise, with the panels that OBJ gives for the same polygons") {
  for (const Mesh& mesh : fixtures::polygon_meshes()) {
    const Panels panels = parse(fixtures::off_text(mesh));
    CHECK(panels.vertices == mesh.vertices);
    CHECK(panels.panels == parse_obj(fixtures::obj_text(mesh), "oracle.obj").panels);
    CHECK(panels.part.empty());
  }
}

TEST_CASE("off: counts may be on the first line, directly follow its word, or lack the edges") {
  for (const char* header : {"OFF\n3 1 0\n", "OFF 3 1 0\n", "OFF3 1 0\n", "OFF\r\n\r\n3 1\r\n", "# made\n\nOFF # a file\n# counts\n3 1 3 # of it\n"}) {
    CAPTURE(header);
    const Panels panels = parse(header + body);
    CHECK(panels.vertices.size() == 3);
    CHECK(panels.panels == std::vector<std::array<int, 4>>{{0, 1, 2, -1}});
  }
}

TEST_CASE("off: normals, colours and texture of vertices, colours of faces and comments are skipped") {
  const Panels panels = parse(
      "STCNOFF\n# made\n3 2 0\n0 0 0 0 0 1 255 0 0 255 0.5 0.5\n# between\n1 0 0  0 0 1 1 0 0 1\n\n0 1 0 nan nan nan # last\n"
      "3 0 1 2 0.5 0.5 0.5 # grey\n3 2 1 0 255 0 0 255\n# end\n");
  CHECK(panels.vertices[1] == Vec3d{1, 0, 0});
  CHECK(panels.panels == std::vector<std::array<int, 4>>{{0, 1, 2, -1}, {2, 1, 0, -1}});
  for (const char* word : {"COFF", "NOFF", "STOFF", "CNOFF"}) CHECK(parse(std::string(word) + "\n3 1 0\n" + body).panels.size() == 1);
}

TEST_CASE("off: a truncated file is refused in one sentence, or read where only digits are missing") {
  const std::string whole = tetrahedron();
  for (std::size_t length = 0; length + 2 < whole.size(); ++length) {
    CHECK_THROWS_AS(parse(whole.substr(0, length)), InputError);
    check_read_or_refused(whole.substr(0, length), 0);
  }
  check_refused("OFF\n4 1 0\n0 0 0\n1 0 0\n0 0.000000000000000000 0\n", "hull.off:6: the file ends before vertex 4 of 4; it is truncated: export it again.");
  check_refused("OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n# end\n", "hull.off:8: the file ends before face 2 of 2; it is truncated: export it again.");
}

TEST_CASE("off: counts beyond the file size are refused without allocating memory") {
  check_refused(with(tetrahedron(), "4 4 0", "4000000000 4 0"),
                "hull.off:3: the header states 4000000000 vertices, more than the 56 bytes after this line can hold; the file is truncated or the count is "
                "damaged: export it again.");
  check_refused(with(tetrahedron(), "4 4 0", "4 4000000000 0"),
                "hull.off:3: the header states 4000000000 faces, more than the 56 bytes after this line can hold; the file is truncated or the count is "
                "damaged: export it again.");
  check_refused(with(tetrahedron(), "4 4 0", "-4 4 0"),
                "hull.off:2: the count of vertices has `-4` where a count is expected; correct the file or export it again.");
  check_refused(with(tetrahedron(), "4 4 0", "4"),
                "hull.off:2: the count of faces has nothing where a count is expected; correct the file or export it again.");
  check_refused(with(tetrahedron(), "4 4 0", "4 3 0"), "hull.off:10: `3` follows the last of 3 faces; the count or the file is damaged: export it again.");
  check_refused(with(tetrahedron(), "\n3 0 2 1", "\n4000000000 0 2 1"),
                "hull.off:7: face 1 has nothing where an integer is expected; correct the file or export it again.");
}

TEST_CASE("off: invalid vertices and faces are refused with the line") {
  check_refused(with(tetrahedron(), "\n1 0 0", "\n1 nan 0"),
                "hull.off:4: vertex 2 has `nan` where a finite number is expected; correct the file or export it again.");
  check_refused(with(tetrahedron(), "\n1 0 0", "\n1 0   "),
                "hull.off:4: vertex 2 has nothing where a finite number is expected; correct the file or export it again.");
  check_refused(with(tetrahedron(), "\n3 0 2 1", "\n3 0 2 4"), "hull.off:7: face 1 has vertex 4, but there are 4, counted from 0; correct the numbers.");
  check_refused(with(tetrahedron(), "\n3 0 2 1", "\n3 0 2 -1"), "hull.off:7: face 1 has vertex -1, but there are 4, counted from 0; correct the numbers.");
  check_refused(with(tetrahedron(), "\n3 0 2 1", "\n2 0 2  "), "hull.off:7: face 1 has 2 vertices, but needs at least three; delete or correct it.");
  check_refused(with(tetrahedron(), "\n3 0 2 1", "\n3 0 2 x"), "hull.off:7: face 1 has `x` where an integer is expected; correct the file or export it again.");
  Mesh crossed;
  crossed.vertices = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {4, 4, 0}, {2, 5, 0}};
  crossed.add_polygon({0, 1, 2, 3, 4});
  check_refused(fixtures::off_text(crossed),
                "hull.off:9: face 1 with 5 vertices cannot be triangulated because its sides cross; triangulate the mesh before exporting it.");
}

TEST_CASE("off: binary files, other dimensions and other formats are refused by name") {
  check_refused("OFF BINARY\n" + std::string(40, '\0'), "hull.off:1: binary OFF is not supported; export the file as text or as PLY.");
  check_refused("4OFF\n3 1 0\n", "hull.off:1: `4OFF` has vertices with other than three coordinates; export the file in three dimensions.");
  check_refused("nOFF 2\n3 1 0\n", "hull.off:1: `nOFF` has vertices with other than three coordinates; export the file in three dimensions.");
  check_refused("XOFF\n3 1 0\n", "hull.off:1: `XOFF` is not a supported OFF header; supported are OFF and its prefixes ST, C and N.");
  check_refused("solid hull\n", "hull.off:1: an OFF file begins with `OFF`, but this one with `solid`; the contents do not match the file extension.");
  check_refused("", "hull.off:1: an OFF file begins with `OFF`, but this one with nothing; the contents do not match the file extension.");
}

TEST_CASE("off: thousands of damaged files are read or refused, never more") {
  std::mt19937_64 random(1);
  for (int trial = 0; trial < 3000; ++trial) check_read_or_refused(fixtures::damaged(tetrahedron(), random), 5);
}
