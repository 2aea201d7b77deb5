#include "mesh_io/obj.hpp"

#include <doctest/doctest.h>

#include <numbers>
#include <random>

#include "base/error.hpp"
#include "fixtures/surface_files.hpp"
#include "fixtures/tolerance.hpp"
#include "mesh/surface.hpp"

using namespace fccda;

namespace {
Panels parse(const std::string& contents) { return parse_obj(contents, "hull.obj"); }
void check_refused(const std::string& contents, const char* sentence) { CHECK_THROWS_WITH_AS(parse(contents), sentence, InputError); }
const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
/// Passes only for a one-sentence refusal or a surface of sensible size.
void check_read_or_refused(const std::string& contents, std::size_t most_panels) {
  std::string sentence;
  std::size_t panels = 0;
  try {
    panels = parse(contents).panels.size();
  } catch (const InputError& error) {
    sentence = error.what();
    CHECK(sentence.starts_with("hull.obj:"));
  }
  CHECK(panels <= most_panels);
  CHECK(sentence.find('\n') == std::string::npos);
  CHECK(sentence.find('\0') == std::string::npos);
}

}  // namespace

TEST_CASE("obj: vertices, triangles and quads are read back bitwise") {
  for (const Panels& panels : {fixtures::torus(2, 0.5, 9, 7, 1), fixtures::tetrahedron(), fixtures::unit_cube()}) {
    const Panels back = parse(fixtures::obj_text(panels));
    CHECK(back.vertices == panels.vertices);
    CHECK(back.panels == panels.panels);
  }
}

TEST_CASE("obj: faces may carry texture and normal numbers, and count back from the last vertex") {
  const Panels panels = parse(square + "vt 0 0\nvn 0 0 1\nf 1/1 2/1 3/1\nf 1/1/1 2/1/1 3/1/1\nf 1//1 2//1 3//1\nf -4 -3 -2\nv 0 0 1\nf -5/-1 -4 -3");
  CHECK(panels.panels.size() == 5);
  for (const auto& panel : panels.panels) CHECK(panel == std::array{0, 1, 2, -1});
}

TEST_CASE("obj: comments, groups, materials, colours, weights, joined lines and other line ends are accepted") {
  const Panels panels = parse(
      "\xEF\xBB\xBF# hull\r\nmtllib a.mtl\r\n\r\no hull\r\n  v 0 0 0 1.0\r\nv 1 0 0 0.5 0.5 0.5\r\nv 1 1 \\\r\n 0\r\nv\t0 1 0 # last\r\n"
      "g side\r\ns off\r\nusemtl steel\r\nl 1 2\r\nf 1 2 \\\r\n3 4 # quad\r\nf 1 2 3 # triangle");
  CHECK(panels.vertices.size() == 4);
  CHECK(panels.vertices[2] == Vec3d{1, 1, 0});
  CHECK(panels.panels == std::vector{std::array{0, 1, 2, 3}, std::array{0, 1, 2, -1}});
}

TEST_CASE("obj: groups and objects are parts, the latest statement applies, and every triangle of a fan keeps the part of its face") {
  const Panels panels = parse(square + "v 2 0.5 0\nf 1 2 3\no hull\ng\ng bow plating\nf 1 2 3\nf 1 2 5 3 4\no deck\nf 1 2 3 4\ng bow plating\nf 1 2 3");
  CHECK(panels.part_names == std::vector<std::string>{"", "bow plating", "deck"});
  CHECK(panels.part == std::vector{0, 1, 1, 1, 1, 2, 1});
  CHECK(parse(square + "f 1 2 3").part.empty());
}

TEST_CASE("obj: a convex polygon becomes a fan of its area") {
  for (const int sides : {5, 6, 17}) {
    std::string text, face = "f";
    for (int k = 0; k < sides; ++k) {
      const double u = 2 * std::numbers::pi * k / sides;
      text += "v " + std::to_string(std::cos(u)) + " " + std::to_string(std::sin(u)) + " 2\n";
      face += " " + std::to_string(k + 1);
    }
    const Surface polygon(parse(text + face), {.orientation = Orientation::normals, .name = "polygon"});
    CHECK(polygon.triangles().size() == std::size_t(sides - 2));
    CHECK(polygon.report().area == fixtures::relative(0.5 * sides * std::sin(2 * std::numbers::pi / sides), 1e-5));  // six digits of to_string
    for (std::size_t t = 0; t < polygon.triangles().size(); ++t) CHECK(polygon.normal(t).z == 1);
  }
}

TEST_CASE("obj: a polygon with corners on a straight side is triangulated completely") {
  const Surface polygon(parse("v 0 0 0\nv 1 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nf 1 2 3 4 5"), {.orientation = Orientation::normals, .name = "polygon"});
  CHECK(polygon.report().area == fixtures::relative(4, 1e-12));
  CHECK(polygon.report().boundary_edges == 5);
}

TEST_CASE("obj: a re-entrant polygon is triangulated inside, and one whose sides cross is refused") {
  const std::string dart = "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 3.9 0.1 0\nv 0 4 0\n";
  const Surface inside(parse(dart + "f 1 2 3 4 5"), {.orientation = Orientation::normals, .name = "dart"});
  CHECK(inside.report().area == fixtures::relative(8.2, 1e-12));  // shoelace: (0 + 16 - 15.2 + 15.6 + 0)/2
  check_refused("v 0 0 0\nv 4 0 0\nv 0 4 0\nv 4 4 0\nv 2 5 0\nf 1 2 3 4 5",
                "hull.obj:6: the face with 5 vertices cannot be triangulated because its sides cross; triangulate the mesh before exporting it.");
}

TEST_CASE("obj: undefined vertex numbers are refused with the line") {
  check_refused(square + "f 1 2 5",
                "hull.obj:5: the face has vertex `5`, but there are 4 before this line, counted from 1 or back from -1; correct the numbers.");
  for (const char* face :
       {"f 0 1 2", "f -5 1 2", "f 1 2 99999999999999999999", "f 1 2 -99999999999999999999", "f 1 2 4294967297", "f 1 2 9223372036854775807"}) {
    CHECK_THROWS_WITH_AS(parse(square + face), doctest::Contains("before this line"), InputError);
  }
  for (const char* face : {"f 1 2 x", "f 1 2 /3", "f 1 2 3.5", "f 1 2 3x/1", "f +1 2 3"}) {
    CHECK_THROWS_WITH_AS(parse(square + face), doctest::Contains("where a vertex number is expected"), InputError);
  }
  check_refused(square + "f 1 2", "hull.obj:5: the face has 2 vertices, but needs at least three; delete or correct it.");
}

TEST_CASE("obj: vertices that are not numbers are refused with line and number") {
  check_refused("v 0 0 0\nv 1 nan 0\n", "hull.obj:2: vertex 2 has `nan` where a finite number is expected; correct the file or export it again.");
  check_refused("v 0 0\nf 1 1 1", "hull.obj:1: vertex 1 has nothing where a finite number is expected; correct the file or export it again.");
  check_refused("v 0 0,5 0\n", "hull.obj:1: vertex 1 has `0,5` where a finite number is expected; correct the file or export it again.");
  check_refused("v 0 1e999 0\n", "hull.obj:1: vertex 1 has `1e999` where a finite number is expected; correct the file or export it again.");
}

TEST_CASE("obj: unsupported statements are refused by name, including free-form surfaces") {
  check_refused("v 0 0 0\nsurf 0 1 0 1 1 2 3\n",
                "hull.obj:2: `surf` is not a supported statement: surfaces need `v` and `f`; export the file as a polygon mesh.");
}

TEST_CASE("obj: damaged files are read or refused, never more") {
  std::mt19937_64 random(1);
  const std::string text = fixtures::obj_text(fixtures::torus(2, 0.5, 4, 3));
  for (int trial = 0; trial < 3000; ++trial) {
    std::string contents = text.substr(0, 1 + random() % text.size());
    for (std::size_t k = 0; k < 1 + random() % 5; ++k) contents[random() % contents.size()] = static_cast<char>(random());
    check_read_or_refused(contents, 2 * text.size());
  }
}
