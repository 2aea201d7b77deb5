#include "mesh_io/keyword/lsdyna.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>

#include "base/error.hpp"
#include "fixtures/keyword_files.hpp"
#include "fixtures/tolerance.hpp"
#include "mesh/shapes/sphere.hpp"
#include "mesh/surface.hpp"
#include "mesh_io/keyword/lsdyna_keywords.hpp"

using namespace fccda;
using fixtures::LsdynaForm;

namespace {

Elements parse(const std::string& contents) { return parse_lsdyna(contents, "hull.k"); }
void check_refused(const std::string& contents, const char* sentence) { CHECK_THROWS_WITH_AS(parse(contents), sentence, InputError); }

constexpr LsdynaForm forms[] = {LsdynaForm::fixed, LsdynaForm::commas, LsdynaForm::i10, LsdynaForm::large};

const std::string square = "*NODE\n1,0,0,0\n2,1,0,0\n3,1,1,0\n4,0,1,0\n5,0,0,1\n6,1,0,1\n7,1,1,1\n8,0,1,1\n";

/// Sorted nodes of each element: the orientation of a solid does not affect its boundary faces.
std::vector<std::vector<int>> sorted_nodes(const Elements& elements) {
  std::vector<std::vector<int>> out;
  for (std::size_t e = 0; e < elements.size(); ++e) {
    out.emplace_back(elements.nodes_of_element(e).begin(), elements.nodes_of_element(e).end());
    std::sort(out.back().begin(), out.back().end());
  }
  return out;
}

void check_read_or_refused(const std::string& contents, std::size_t most_nodes) {
  std::string sentence;
  std::size_t nodes = 0;
  try {
    Elements elements = parse(contents);
    nodes = elements.vertices.size();
    panels_of(std::move(elements), "hull.k");
  } catch (const InputError& error) {
    sentence = error.what();
    CHECK(sentence.starts_with("hull.k:"));
  }
  CHECK(nodes <= most_nodes);
  CHECK(sentence.find('\n') == std::string::npos);
  CHECK(sentence.find('\0') == std::string::npos);
}

}  // namespace

TEST_CASE("lsdyna: shells are read back bitwise from columns of every width and from comma-separated fields") {
  for (const Elements& written :
       {fixtures::elements_of(fixtures::unit_cube(), "cube of quads"), fixtures::elements_of(make_sphere({.diameter = 2, .edge_length = 0.5}), "ball")}) {
    for (const LsdynaForm form : forms) {
      CAPTURE(static_cast<int>(form));
      const Elements read = parse(fixtures::lsdyna_text(written, form));
      CHECK(read.vertices == written.vertices);
      CHECK(read.kinds == written.kinds);
      CHECK(read.nodes == written.nodes);
      CHECK(read.part_names == written.part_names);
    }
  }
}

TEST_CASE("lsdyna: solids are read back as their kind, on one card or two, although all are written as hexahedra") {
  for (const ElementKind kind : {ElementKind::hexahedron, ElementKind::wedge, ElementKind::tetrahedron}) {
    const Elements written = fixtures::block_of(kind, 3);
    for (const LsdynaForm form : forms) {
      for (const bool on_two_cards : {false, true}) {
        const Elements read = parse(fixtures::lsdyna_text(written, form, on_two_cards));
        CHECK(read.kinds == written.kinds);
        CHECK(sorted_nodes(read) == sorted_nodes(written));
        CHECK(read.part == written.part);
        CHECK(read.part_names == written.part_names);
        const Surface skin(panels_of(read, "hull.k"));
        CHECK(skin.report().volume == fixtures::relative(27, 1e-12));
        CHECK(skin.report().area == fixtures::relative(54, 1e-12));
      }
    }
  }
  Elements ten;
  std::vector<int> nodes;
  for (int k = 0; k < 10; ++k) ten.vertices.push_back({double(k), double(k * k), 0}), nodes.push_back(k);
  ten.add(ElementKind::tetrahedron_10, nodes, ten.part_number("ten"));
  for (const LsdynaForm form : forms) CHECK(parse(fixtures::lsdyna_text(ten, form)).nodes == ten.nodes);
}

TEST_CASE("lsdyna: the sign after a keyword sets the width of its fields, and *KEYWORD that of all") {
  const std::string nodes =
      "*NODE %\n         1             0.0             0.0             0.0       0       0\n"
      "9999999999             1.0             0.0             0.0\n*NODE+\n"
      "                   3                 1.0                1D+0\n";
  const Elements read = parse("*KEYWORD\n" + nodes +
                              "*ELEMENT_SHELL%\n"
                              "         1         1         19999999999         3\n");
  CHECK(read.nodes == std::vector{0, 2, 1});
  CHECK(read.vertices[1] == Vec3d{1, 1, 0});
  CHECK(parse("*KEYWORD LONG=Y\n*NODE -\n       1             2.0             3.0             4.0\n").vertices[0] == Vec3d{2, 3, 4});
  CHECK(parse("*KEYWORD  i10 = y\n*NODE\n         1             2.0             3.0             4.0\n").vertices[0] == Vec3d{2, 3, 4});
  CHECK(parse("*KEYWORD LONG=S\n*NODE\n       1             2.0             3.0             4.0\n").vertices[0] == Vec3d{2, 3, 4});
}

TEST_CASE("lsdyna: fields need no blanks between them, blank ones are 0, and reals may be in Fortran notation") {
  const Elements read = parse("*NODE\n$ a comment\n12345678-1.5000000000-031.00000000000000" + std::string(16, ' ') + "       2\n");
  CHECK(read.vertices == std::vector<Vec3d>{{-1.5e-3, 1, 0}});
  CHECK(parse("*NODE\n       7                             2.0\n").vertices[0] == Vec3d{0, 2, 0});
}

TEST_CASE("lsdyna: additional cards of shell options are skipped, including thicknesses at mid-side nodes") {
  const std::string shells[] = {
      "*ELEMENT_SHELL\n1,1,1,2,3,4\n2,1,5,6,7,8\n",
      "*ELEMENT_SHELL_THICKNESS\n1,1,1,2,3,4\n.1,.1,.1,.1\n2,1,5,6,7,8\n\n",
      "*ELEMENT_SHELL_BETA\n1,1,1,2,3,4\n,,,,45.\n2,1,5,6,7,8\n,,,,45.\n",
      "*ELEMENT_SHELL_THICKNESS_MCID_OFFSET\n1,1,1,2,3,4\n1,1,1,1,7\n0.5\n2,1,5,6,7,8\n1,1,1,1,7\n0.5\n",
      "*ELEMENT_SHELL_OFFSET\n1,1,1,2,3,4\n0.5\n2,1,5,6,7,8\n0.5\n",
      "*ELEMENT_SHELL_DOF\n1,1,1,2,3,4\n,,1,2,3,4\n2,1,5,6,7,8\n,,1,2,3,4\n",
  };
  for (const std::string& text : shells) {
    CAPTURE(text);
    CHECK(parse(square + text).nodes == std::vector{0, 1, 2, 3, 4, 5, 6, 7});
  }
  const Elements eight = parse(square + "*ELEMENT_SHELL_THICKNESS\n1,1,1,2,3,4,5,6,7,8\n1,1,1,1\n1,1,1,1\n2,1,1,2,3,3\n1,1,1\n");
  CHECK(eight.kinds == std::vector{ElementKind::quad_8, ElementKind::polygon});
  CHECK(parse(square + "*ELEMENT_SHELL\n1,1,1,2,3,0\n").nodes == std::vector{0, 1, 2});
}

TEST_CASE("lsdyna: additional cards of solid options are skipped, and thick shells are solids") {
  const std::string solids[] = {"*ELEMENT_SOLID\n1,1,1,2,3,4,5,6,7,8\n",
                                "*ELEMENT_SOLID (ten nodes format)\n1,1\n1,2,3,4,5,6,7,8,0,0\n",
                                "*ELEMENT_SOLID_ORTHO\n1,1,1,2,3,4,5,6,7,8\n1,0,0\n0,1,0\n",
                                "*ELEMENT_SOLID_ORTHO_DOF\n1,1\n1,2,3,4,5,6,7,8\n1,0,0\n0,1,0\n,,1\n",
                                "*ELEMENT_TSHELL\n1,1,1,2,3,4,5,6,7,8\n",
                                "*ELEMENT_TSHELL_BETA\n1,1,1,2,3,4,5,6,7,8\n,,,,30.\n"};
  for (const std::string& text : solids) {
    CAPTURE(text);
    CHECK(parse(square + text).kinds == std::vector{ElementKind::hexahedron});
    CHECK(Surface(panels_of(parse(square + text), "hull.k")).report().volume == fixtures::relative(1, 1e-12));
  }
  CHECK(parse(square + "*ELEMENT_SOLID\n1,1\n1,2,3,5\n").kinds == std::vector{ElementKind::tetrahedron});
}

TEST_CASE("lsdyna: shells and solids are numbered independently") {
  CHECK(parse(square + "*ELEMENT_SHELL\n1,1,1,2,3,4\n*ELEMENT_SOLID\n1,2,1,2,3,4,5,6,7,8\n").size() == 2);
}

TEST_CASE("lsdyna: parts are named by their heading, or by number where that is blank, missing or ambiguous") {
  const std::string shells = square + "*ELEMENT_SHELL\n1,1,1,2,3,4\n2,2,1,2,3\n3,3,1,2,4\n4,4,1,3,4\n5,5,2,3,4\n6,6,2,3,5\n";
  const Elements read =
      parse(shells +
            "*PART\n  bow shell  \n         1         "
            "1\n\n2,1,1\n*PART_INERTIA\nkeel\n3,1,1\n0,0,0,8e6,1\n1,0,0,1,0,1\n0,0,0\n1,0,0,0,1,0\nplate\n4,1,1\n0,0,0,8e6,0\n1,0,0,1,0,1\n0,0,0\n"
            "*PART_CONTACT\nplate\n5,1,1\n.1,.1\n*SET_PART\n1\n*PART_COMPOSITE\npart 2\n6,1\n1,2,3\n1,2,3\n");
  CHECK(read.part_names == std::vector<std::string>{"bow shell", "part 2", "keel", "part 4", "part 5", "part 6"});
  CHECK(read.part == std::vector{0, 1, 2, 3, 4, 5});
  CHECK(parse(square + "*ELEMENT_SHELL\n1,9999999999,1,2,3,4\n").part_names == std::vector<std::string>{"part 9999999999"});
}

TEST_CASE("lsdyna: everything other than the mesh is skipped, and *END ends the file") {
  const Elements read = parse(
      "$ comment\n*KEYWORD MEMORY=100M\n*TITLE\nany text\n*CONTROL_TERMINATION\n  "
      "1.0\n*MAT_RIGID\n1,7.85e3\n*SECTION_SHELL\n1,2\n*SET_NODE_LIST\n1\n1,2,3\n*DEFINE_CURVE\n1\n0,&x\n" +
      square +
      "*ELEMENT_BEAM\n1,1,1,2,3\n*ELEMENT_MASS\n1,1,5.\n*ELEMENT_DISCRETE\n1,1,1,2\n*ELEMENT_SEATBELT\n1,1,1,2\n*ELEMENT_SHELL_SOURCE_SINK\n1,1,1\n*PART_"
      "SENSOR\n1,2\n*INCLUDE_PATH\n/somewhere\n"
      "*ELEMENT_SHELL\n1,1,1,2,3,4\n*END\n*ELEMENT_SHELL\n2,1,1,2,3,4\n");
  CHECK(read.size() == 1);
}

TEST_CASE("lsdyna: content in other files, generated by the solver, of unsupported kinds or parametrised is refused by name") {
  for (const std::string name : {"INCLUDE", "INCLUDE_TRANSFORM"})
    check_refused("*" + name + "\nmesh.k\n",
                  ("hull.k:1: *" + name + " refers to another file, but only this one is read; insert the lines of that file here.").c_str());
  for (const std::string name : {"NODE_TRANSFORM", "PART_MOVE", "PART_DUPLICATE"})
    check_refused("*" + name + "\n", ("hull.k:1: *" + name + " moves nodes or copies elements, which is not supported; export the resulting mesh.").c_str());
  for (const std::string name :
       {"ELEMENT_SHELL_COMPOSITE", "ELEMENT_SHELL_NURBS_PATCH", "ELEMENT_SOLID_H20", "ELEMENT_TSHELL_COMPOSITE", "ELEMENT_GENERALIZED_SHELL", "IGA_SHELL"})
    check_refused("*" + name + "\n",
                  ("hull.k:1: *" + name + " is not supported; export the surface as *ELEMENT_SHELL or *ELEMENT_SOLID with ordinary nodes.").c_str());
  check_refused("*PARAMETER\nR len,2.5\n*NODE\n1,&len,0,0\n",
                "hull.k:4: node 1 has `&len` where a finite number is expected; parameters are not supported: write the number itself.");
}

TEST_CASE("lsdyna: missing nodes, and conflicting or invalid nodes and elements, are refused with their lines") {
  const std::string one = square + "*ELEMENT_SHELL\n1,1,1,2,3,4\n";
  check_refused(square + "*ELEMENT_SHELL\n1,1,1,2,9999999999,4\n",
                "hull.k:11: element 1 has node 9999999999, which is not defined; correct the element or add the node.");
  check_refused(one + "*NODE\n2,1,0,.1\n", "hull.k:13: node 2 has different coordinates on line 3; renumber one of the two.");
  CHECK(parse(one + "*NODE\n2,1,0,0\n").vertices.size() == 8);
  check_refused(one + "1,1,1,2,4,3\n", "hull.k:12: element 1 is defined differently on line 11; renumber one of the two.");
  CHECK(parse(one + "1,1,1,2,3,4\n").size() == 1);
  check_refused(
      square + "*ELEMENT_SHELL\n1,1,1,2,3,4,5\n",
      "hull.k:11: element 1 has nodes that do not form a triangle or a quad (with mid-side nodes on all sides of a quad or on none); correct or delete it.");
  check_refused(square + "*ELEMENT_SOLID\n1,1,1,2,3,4,5,6,7\n",
                "hull.k:11: element 1 has nodes that do not form a tetrahedron, pyramid, wedge, hexahedron or ten-node tetrahedron; correct or delete it.");
  check_refused(square + "*ELEMENT_SHELL\n1,1,1,0,3,4\n", "hull.k:11: element 1 has 0 among its nodes; correct the element.");
  check_refused(square + "*ELEMENT_SOLID\n1,1\n*END\n", "hull.k:11: element 1 ends before its last card; it is truncated: export the file again.");
}

TEST_CASE("lsdyna: invalid numbers are refused with the line and the item") {
  check_refused("*NODE\n1,0,nan,0\n", "hull.k:2: node 1 has `nan` where a finite number is expected; correct the file or export it again.");
  check_refused("*NODE\n       1             0.0         0.0 0.0\n",
                "hull.k:2: node 1 has `0.0 0.0` where a finite number is expected; correct the file or export it again.");
  check_refused("*NODE\nx,0,0,0\n", "hull.k:2: *NODE has `x` where an integer is expected; correct the file or export it again.");
  check_refused("*NODE\n0,0,0,0\n", "hull.k:2: the node number is 0, but numbers begin with 1; correct the file or export it again.");
  check_refused(square + "*ELEMENT_SHELL\n1,1,1,2.0,3,4\n",
                "hull.k:11: element 1 has `2.0` where an integer is expected; correct the file or export it again.");
  check_refused("*NODE\n1\t0\t0\t0\n", "hull.k:2: the card contains a tab, so its columns are ambiguous; replace tabs by blanks.");
  check_refused("solid cube\n", "hull.k:1: `solid cube` appears where a keyword such as *KEYWORD is expected; this is not an LS-DYNA file.");
  CHECK(parse("").size() == 0);
}

TEST_CASE("lsdyna: a truncated or damaged file is read or refused in one sentence") {
  const Elements block = fixtures::block_of(ElementKind::wedge, 1);
  std::mt19937_64 random(1);
  for (const LsdynaForm form : forms) {
    const std::string whole = fixtures::lsdyna_text(block, form, true);
    for (std::size_t length = 0; length < whole.size(); ++length) check_read_or_refused(whole.substr(0, length), 8);
    for (int trial = 0; trial < 500; ++trial) {
      std::string contents = whole;
      for (std::size_t k = 0; k < 1 + random() % 4; ++k)
        contents[random() % contents.size()] = static_cast<char>(random() % 3 == 0 ? random() : "*,\n =0129-eE"[random() % 12]);
      check_read_or_refused(contents, 60);
    }
  }
}
