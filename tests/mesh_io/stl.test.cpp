#include "mesh_io/stl.hpp"

#include <doctest/doctest.h>

#include <limits>
#include <random>

#include "base/error.hpp"
#include "fixtures/surface_files.hpp"
#include "mesh/surface.hpp"

using namespace fccda;

namespace {

Panels parse(const std::string& contents) { return parse_stl(contents, "hull.stl"); }
void check_refused(const std::string& contents, const char* sentence) { CHECK_THROWS_WITH_AS(parse(contents), sentence, InputError); }

std::string with(std::string text, const std::string& old, const std::string& replacement) { return text.replace(text.find(old), old.size(), replacement); }

/// Passes only for a one-sentence refusal or a surface of sensible size.
void check_read_or_refused(const std::string& contents, std::size_t most_panels) {
  std::string sentence;
  std::size_t panels = 0;
  try {
    panels = parse(contents).panels.size();
  } catch (const InputError& error) {
    sentence = error.what();
    CHECK(sentence.starts_with("hull.stl:"));
  }
  CHECK(panels <= most_panels);
  CHECK(sentence.find('\n') == std::string::npos);
  CHECK(sentence.find('\0') == std::string::npos);
}

}  // namespace

TEST_CASE("stl: text is read back with all digits") {
  const Panels torus = fixtures::torus(2, 0.5, 9, 7);
  const Panels back = parse(fixtures::stl_text(torus));
  CHECK(back.panels.size() == 2 * torus.panels.size());
  std::size_t next = 0;
  fixtures::for_each_triangle(torus, [&](const Vec3d& a, const Vec3d& b, const Vec3d& c) {
    for (const Vec3d& v : {a, b, c}) CHECK(back.vertices[next++] == v);
  });
  CHECK(Surface(back).report().vertices == torus.vertices.size());
}

TEST_CASE("stl: binary is read back as the stored floats, and is closed when welded") {
  const Panels torus = fixtures::torus(2, 0.5, 9, 7);
  const Panels back = parse(fixtures::stl_binary(torus));
  std::size_t next = 0;
  fixtures::for_each_triangle(torus, [&](const Vec3d& a, const Vec3d& b, const Vec3d& c) {
    for (const Vec3d& v : {a, b, c}) {
      const Vec3d& read = back.vertices[next++];
      // as floats: g++ 12 drops the rounding of double(float(x)) where it vectorises three of them
      for (std::size_t axis = 0; axis < 3; ++axis) CHECK(static_cast<float>(read[axis]) == static_cast<float>(v[axis]));
    }
  });
  CHECK(Surface(back).is_closed());
}

TEST_CASE("stl: a binary file that begins with `solid` is read as binary") {
  CHECK(parse(fixtures::stl_binary(fixtures::unit_cube(), "solid exported by a program that does not care")).panels.size() == 12);
}

TEST_CASE("stl: text may have capitals, any white space, plus signs, several solids, no names, and end without a line end") {
  const char* text =
      "\xEF\xBB\xBF\r\n SOLID\r\nFACET NORMAL nan nan nan OUTER LOOP VERTEX +1 2. -.5 vertex 1e0 2E+00 3 vertex\t4 5\r\n6 endloop endfacet endsolid\r\n"
      "solid b\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 0 0 1\nvertex 0 1 0\nendloop\nendfacet\nendsolid b";
  const Panels panels = parse(text);
  CHECK(panels.panels.size() == 2);
  CHECK(panels.vertices[0] == Vec3d{1, 2, -0.5});
  CHECK(panels.vertices[2] == Vec3d{4, 5, 6});
}

TEST_CASE("stl: each solid of a text is a part, solids of equal name are one part, and a binary file has no parts") {
  const std::string facet = "facet normal 0 0 0 outer loop vertex 0 0 0 vertex 0 0 1 vertex 0 1 0 endloop endfacet\n";
  const Panels panels = parse("solid blade 1 \t\r\n" + facet + facet + "endsolid blade 1\nsolid hub\n" + facet + "endsolid\nsolid blade 1\n" + facet +
                              "endsolid\nsolid\n" + facet + "endsolid\nsolid nothing in it\nendsolid");
  CHECK(panels.part_names == std::vector<std::string>{"blade 1", "hub", ""});
  CHECK(panels.part == std::vector{0, 0, 1, 0, 2});
  CHECK(parse("solid\n" + facet + "endsolid").part.empty());
  CHECK(parse("solid a\x1b[31m\n" + facet + "endsolid").part_names == std::vector<std::string>{"a?[31m"});  // would colour a terminal
  CHECK(parse(fixtures::stl_binary(fixtures::unit_cube())).part.empty());
}

TEST_CASE("stl: a truncated text is never read as a smaller surface") {
  const std::string whole = fixtures::stl_text(fixtures::tetrahedron());
  for (std::size_t length = 0; length < whole.rfind("endsolid") + 8; ++length) CHECK_THROWS_AS(parse(whole.substr(0, length)), InputError);
  check_refused(whole.substr(0, whole.find("endfacet") + 9),
                "hull.stl:9: the file ends after 1 triangles without `endsolid`; it is truncated: export it again.");
  check_refused(whole.substr(0, whole.find("endloop")), "hull.stl:7: the file ends in triangle 1; it is truncated: export it again.");
}

TEST_CASE("stl: a truncated binary file is refused with the triangle where it ends") {
  const std::string whole = fixtures::stl_binary(fixtures::tetrahedron());
  for (std::size_t length = 0; length < whole.size(); ++length) CHECK_THROWS_AS(parse(whole.substr(0, length)), InputError);
  check_refused(whole.substr(0, 84 + 50 + 20), "hull.stl: the file ends in triangle 2 of 4; it is truncated or not an STL file: export it again.");
  check_refused(whole.substr(0, 70),
                "hull.stl: 70 bytes are too few for an STL file, which begins with `solid` or has 84 bytes before its first triangle; export it again.");
  check_refused(fixtures::stl_binary(fixtures::tetrahedron(), "solid too").substr(0, 84 + 50 + 20),
                "hull.stl: the file ends in triangle 2 of 4; it is truncated or not an STL file: export it again.");
  check_refused(whole + "abc", "hull.stl: 3 bytes follow the last of 4 triangles; the count or the file is damaged: export it again.");
}

TEST_CASE("stl: a count of four billion is refused without allocating memory") {
  std::string huge = fixtures::stl_binary(fixtures::tetrahedron());
  huge.replace(80, 4, "\xff\xff\xff\xff");
  check_refused(huge, "hull.stl: the file ends in triangle 5 of 4294967295; it is truncated or not an STL file: export it again.");
}

TEST_CASE("stl: coordinates that are not finite are refused with the triangle") {
  Panels bad = fixtures::tetrahedron();
  bad.vertices[3].z = std::numeric_limits<double>::quiet_NaN();
  check_refused(fixtures::stl_binary(bad), "hull.stl: triangle 2 of 4 has a coordinate that is not a finite number; repair the mesh and export it again.");
  check_refused(fixtures::stl_text(bad), "hull.stl:13: triangle 2 has `nan` where a finite number is expected; correct the file or export it again.");
  bad.vertices[3].z = 1e300;  // infinite as a float
  CHECK_THROWS_AS(parse(fixtures::stl_binary(bad)), InputError);
  const std::string good = fixtures::stl_text(fixtures::tetrahedron());
  for (const char* number : {"vertex 0 0,5", "vertex 0 1e999", "vertex 0 inf", "vertex 0 0x1", "vertex 0 --1", "vertex 0 1.0.0", "vertex 0 +-1"}) {
    CHECK_THROWS_AS(parse(with(good, "vertex 0 0", number)), InputError);
  }
}

TEST_CASE("stl: text that violates the format is refused with the line and the expected word") {
  const std::string good = fixtures::stl_text(fixtures::tetrahedron());
  check_refused(with(good, "endloop", "vertex 1 1 1\nendloop"), "hull.stl:7: triangle 1 has `vertex` where `endloop` is expected.");
  check_refused(with(good, "outer loop", "inner loop"), "hull.stl:3: triangle 1 has `inner` where `outer` is expected.");
  check_refused(with(good, "  facet", "  face"), "hull.stl:2: `face` follows 0 triangles, where `facet` or `endsolid` is expected.");
  check_refused(good + "junk", "hull.stl:31: triangle 5 has `junk` where `solid` is expected.");
}

TEST_CASE("stl: a thousand files of junk and damaged files are read or refused, never more") {
  std::mt19937_64 random(1);
  const std::string text = fixtures::stl_text(fixtures::tetrahedron()), binary = fixtures::stl_binary(fixtures::tetrahedron());
  for (int trial = 0; trial < 3000; ++trial) {
    std::string contents = trial % 3 == 0 ? text : trial % 3 == 1 ? binary : "solid" + std::string(random() % 300, '\0');
    const std::size_t damages = trial % 3 == 2 ? contents.size() : 1 + random() % 3;
    for (std::size_t k = 0; k < damages; ++k)
      contents[trial % 3 == 2 ? std::min(contents.size() - 1, k + 5) : random() % contents.size()] = static_cast<char>(random());
    check_read_or_refused(contents, 5);
  }
}
