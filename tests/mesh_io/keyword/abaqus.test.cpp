#include "mesh_io/keyword/abaqus.hpp"

#include <doctest/doctest.h>

#include <random>

#include "base/error.hpp"
#include "fixtures/keyword_files.hpp"
#include "fixtures/tolerance.hpp"
#include "mesh/shapes/sphere.hpp"
#include "mesh/surface.hpp"
#include "mesh_io/keyword/abaqus_types.hpp"

using namespace fccda;

namespace {

Elements parse(const std::string& contents) { return parse_abaqus(contents, "hull.inp"); }
void check_refused(const std::string& contents, const char* sentence) { CHECK_THROWS_WITH_AS(parse(contents), sentence, InputError); }

void check_equal(const Elements& read, const Elements& written) {
  CHECK(read.vertices == written.vertices);
  CHECK(read.kinds == written.kinds);
  CHECK(read.ends == written.ends);
  CHECK(read.nodes == written.nodes);
  CHECK(read.part == written.part);
  CHECK(read.part_names == written.part_names);
}

const std::string square = "*NODE\n1,0,0,0\n2,1,0,0\n3,1,1,0\n4,0,1,0\n";

/// Passes only for a one-sentence refusal or a mesh of sensible size.
void check_read_or_refused(const std::string& contents, std::size_t most_nodes) {
  std::string sentence;
  std::size_t nodes = 0;
  try {
    Elements elements = parse(contents);
    nodes = elements.vertices.size();
    panels_of(std::move(elements), "hull.inp");
  } catch (const InputError& error) {
    sentence = error.what();
    CHECK(sentence.starts_with("hull.inp:"));
  }
  CHECK(nodes <= most_nodes);
  CHECK(sentence.find('\n') == std::string::npos);
  CHECK(sentence.find('\0') == std::string::npos);
}

}  // namespace

TEST_CASE("abaqus: shells and solids of each kind are read back bitwise") {
  check_equal(parse(fixtures::abaqus_text(fixtures::elements_of(fixtures::unit_cube(), "cube"))), fixtures::elements_of(fixtures::unit_cube(), "cube"));
  const Elements sphere = fixtures::elements_of(make_sphere({.diameter = 2, .edge_length = 0.5}), "ball");
  check_equal(parse(fixtures::abaqus_text(sphere)), sphere);
  for (const ElementKind kind : {ElementKind::hexahedron, ElementKind::wedge, ElementKind::tetrahedron}) {
    const Elements block = fixtures::block_of(kind, 3);
    const Elements back = parse(fixtures::abaqus_text(block));
    check_equal(back, block);
    const Surface skin(panels_of(back, "hull.inp"));
    CHECK(skin.report().volume == fixtures::relative(27, 1e-12));
    CHECK(skin.report().area == fixtures::relative(54, 1e-12));
  }
  for (const auto kind : {ElementKind::triangle_6, ElementKind::quad_8, ElementKind::quad_9, ElementKind::tetrahedron_10, ElementKind::pyramid,
                          ElementKind::pyramid_13, ElementKind::wedge_15, ElementKind::hexahedron_20}) {
    Elements one;
    std::vector<int> nodes;
    for (int k = 0; k < static_cast<int>(nodes_of(kind)); ++k) one.vertices.push_back({1.0 * k, 0.1 * k * k, 1.0 / (k + 1)}), nodes.push_back(k);
    one.add(kind, nodes, one.part_number(""));
    check_equal(parse(fixtures::abaqus_text(one)), one);
  }
}

TEST_CASE("abaqus: case, blanks, comments, long lines and missing coordinates follow the Abaqus syntax") {
  const Elements read = parse(
      "\xEF\xBB\xBF** written by hand\r\n*Heading\r\n 7 words, of any kind\r\n  * n o d e , nset = all ,\r\n** between\r\n system=r\r\n 1\r\n2, 1.\r\n\r\n 3 "
      ",1.D0, +1., 0., 0., 0., 1.\r\n"
      "9999999999,,1.5-1,\r\n*nset, nset=x\r\n1, 2\r\n*Element,type = s4 , elset = \"Bow, port\"\r\n1,1,2,\r\n** between\r\n3,\r\n9999999999\r\n*ELEMENT, "
      "type=s3, elset=\"bow, PORT\"\r\n2,1,2,3\r\n");
  CHECK(read.vertices == std::vector<Vec3d>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0.15, 0}});
  CHECK(read.nodes == std::vector{0, 1, 2, 3, 0, 1, 2});
  CHECK(read.part_names == std::vector<std::string>{"Bow, port"});
}

TEST_CASE("abaqus: an element with many nodes continues after sixteen values, and after a trailing comma") {
  std::string nodes = "*NODE\n", sixteen = "*ELEMENT, TYPE=C3D20\n1", one_line = sixteen;
  for (int k = 1; k <= 20; ++k) {
    nodes += std::to_string(k) + "," + std::to_string(k * k) + "\n";
    sixteen += (k == 16 ? "\n" : ",") + std::to_string(k);
    one_line += "," + std::to_string(k);
  }
  check_equal(parse(nodes + sixteen), parse(nodes + one_line));
  CHECK(parse(nodes + one_line + ",\n").nodes.size() == 20);
}

TEST_CASE("abaqus: types are identified by family and number of nodes, whatever letters follow") {
  using Use = AbaqusType::Use;
  for (const char* name : {"S3",     "S3R",     "S3RS",   "S4",     "S4R",  "S4RSW", "S4R5", "STRI3", "STRI65", "S8R",  "S8R5", "S9R5", "S6",
                           "SFM3D3", "SFM3D4R", "SFM3D6", "SFM3D8", "M3D3", "M3D4R", "M3D6", "M3D8",  "M3D9R",  "R3D3", "R3D4", "DS4"}) {
    CAPTURE(name);
    CHECK(abaqus_type(name).use == Use::surface);
  }
  for (const char* name : {"C3D4", "C3D4H", "C3D5", "C3D6", "C3D8", "C3D8R", "C3D8RHT", "C3D8I", "C3D10", "C3D10MH", "C3D13", "C3D15", "C3D20RHT", "DC3D8",
                           "AC3D4", "SC6R", "SC8R", "CSS8", "COH3D8"}) {
    CAPTURE(name);
    CHECK(abaqus_type(name).use == Use::solid);
  }
  for (const char* name : {"B31", "B31OS", "B33", "PIPE31", "T3D2", "MASS", "ROTARYI", "SPRINGA", "SPRING2", "DASHPOTA", "CONN3D2", "GAPUNI", "DCOUP3D"}) {
    CAPTURE(name);
    CHECK(abaqus_type(name).use == Use::skipped);
  }
  for (const char* name : {"CPS3", "CPS4R", "CPE8", "CAX4P"}) {
    CAPTURE(name);
    CHECK(abaqus_type(name).use == Use::surface);
  }
  for (const char* name : {"CPEG4", "CGAX4", "SAX1", "MAX1", "RAX2", "DC2D4"}) {
    CAPTURE(name);
    CHECK(abaqus_type(name).use == Use::plane);
  }
  for (const char* name : {"C3D27", "C3D15V", "C3D7", "S5", "S", "U1", "CIN3D8", "", "S99999999999999999999"}) {
    CAPTURE(name);
    CHECK(abaqus_type(name).use == Use::unknown);
  }
  CHECK(abaqus_type("S8R5").kind == ElementKind::quad_8);
  CHECK(abaqus_type("STRI65").kind == ElementKind::triangle_6);
  CHECK(abaqus_type("SC8R").kind == ElementKind::hexahedron);
}

TEST_CASE("abaqus: beams, springs and everything other than the mesh are skipped, and plane and unknown elements are refused with advice") {
  const Elements read = parse(square +
                              "*ELEMENT, TYPE=B31\n1,1,2\n*ELEMENT, TYPE=CONN3D2\n1, , Hull-1.7\n*ELEMENT, TYPE=S4\n1,1,2,3,4\n*MATERIAL, "
                              "NAME=steel\n*DENSITY\n7850.,\n*NODE OUTPUT\nU\n"
                              "*SURFACE, NAME=s, TYPE=ELEMENT\nbow, SPOS\n*STEP\n*STATIC\n");
  CHECK(read.size() == 1);
  CHECK(read.part_names == std::vector<std::string>{""});
  check_refused("*ELEMENT, TYPE=SAX1\n1,1,2", "hull.inp:1: elements of type SAX1 are two-dimensional and cannot form a 3-D surface; delete them.");
  check_refused("*ELEMENT, TYPE=C3D27\n",
                "hull.inp:1: elements of type C3D27 are not supported; delete them, or export them as shells (S3, S4) or solids (C3D4 to C3D20).");
  check_refused("*ELEMENT\n1,1,2,3", "hull.inp:1: *ELEMENT needs TYPE=; correct the keyword.");
}

TEST_CASE("abaqus: elements that repeat nodes are reduced, and refused where nothing valid remains") {
  const Elements read = parse(square + "5,0,0,1\n*ELEMENT, TYPE=S4\n1,1,2,3,3\n*ELEMENT, TYPE=C3D8\n2,1,2,3,4,5,5,5,5\n");
  CHECK(read.kinds == std::vector{ElementKind::polygon, ElementKind::pyramid});
  CHECK(read.nodes_of_element(0).size() == 3);
  check_refused(square + "*ELEMENT, TYPE=S4\n1,1,2,1,3\n",
                "hull.inp:7: element 1 repeats nodes and does not reduce to a supported element; correct or delete it.");
}

TEST_CASE("abaqus: content in other files, generated by the solver or in other coordinate systems is refused by name") {
  check_refused("*NODE\n*INCLUDE, INPUT=mesh.inp\n",
                "hull.inp:2: *INCLUDE refers to another file, but only this one is read; insert the lines of that file here.");
  check_refused("*NODE, INPUT=mesh.inp\n", "hull.inp:1: *NODE refers to another file, but only this one is read; insert the lines of that file here.");
  for (const std::string name : {"NGEN", "NFILL", "NCOPY", "ELGEN", "ELCOPY"}) {
    check_refused(
        "*" + name + "\n",
        ("hull.inp:1: *" + name + " generates nodes or elements that are not in the file; export the mesh with all nodes and elements listed.").c_str());
  }
  check_refused("*NODE, SYSTEM=C\n", "hull.inp:1: nodes in SYSTEM=C are not supported, only in SYSTEM=R; export Cartesian coordinates.");
  check_refused("*SYSTEM\n0,0,1,1,0,0\n",
                "hull.inp:2: *SYSTEM transforms the nodes that follow, which is not supported; export the coordinates in the global system.");
  CHECK(parse("*SYSTEM\n" + square).vertices.size() == 4);  // without a line: back to the global system
  check_refused("*SURFACE, TYPE=REVOLUTION, NAME=s\n",
                "hull.inp:1: *SURFACE of TYPE=REVOLUTION is an analytical surface, which is not supported; mesh it with R3D4 or S4, or delete it.");
}

TEST_CASE("abaqus: missing nodes and conflicting definitions of nodes and elements are refused with their lines") {
  const std::string one = square + "*ELEMENT, TYPE=S3\n1,1,2,3\n";
  check_refused(square + "*ELEMENT, TYPE=S3\n1,1,2,9999999999\n",
                "hull.inp:7: element 1 has node 9999999999, which is not defined; correct the element or add the node.");
  check_refused(one + "*NODE\n2,1,0,1e-9\n", "hull.inp:9: node 2 has different coordinates on line 3; renumber one of the two.");
  CHECK(parse(one + "*NODE\n2,1,0,0\n").vertices.size() == 4);
  check_refused(one + "2,1,2,4\n1,1,2,4\n", "hull.inp:9: element 1 is defined differently on line 7; renumber one of the two.");
  CHECK(parse(one + "1,1,2,3\n").size() == 1);
}

TEST_CASE("abaqus: invalid numbers are refused with the line and the item") {
  check_refused("*NODE\n1,0,nan,0\n", "hull.inp:2: node 1 has `nan` where a finite number is expected; correct the file or export it again.");
  check_refused("*NODE\n1,0,1e999,0\n", "hull.inp:2: node 1 has `1e999` where a finite number is expected; correct the file or export it again.");
  check_refused("*NODE\nx,0,0,0\n", "hull.inp:2: *NODE has `x` where a node number is expected; correct the file or export it again.");
  check_refused("*NODE\n-3,0,0,0\n", "hull.inp:2: *NODE has `-3` where a node number is expected; correct the file or export it again.");
  check_refused(square + "*ELEMENT, TYPE=S3\n1,1,,3\n",
                "hull.inp:7: element 1 has nothing where a node number is expected; correct the file or export it again.");
  check_refused(square + "*ELEMENT, TYPE=S3\n1,1,2.0,3\n",
                "hull.inp:7: element 1 has `2.0` where a node number is expected; correct the file or export it again.");
  check_refused(square + "*ELEMENT, TYPE=S4\n1,1,2,3\n2,1,2,3,4\n", "hull.inp:7: element 1 has 3 nodes, but its type S4 needs 4; correct the element.");
  check_refused(square + "*ELEMENT, TYPE=S4\n1,1,2,3,4,4\n", "hull.inp:7: element 1 has 5 nodes, but its type S4 needs 4; correct the element.");
  check_refused(square + "*ELEMENT, TYPE=S4\n1,1,2,3,\n*NODE\n", "hull.inp:7: element 1 has 3 nodes, but its type S4 needs 4; correct the element.");
}

TEST_CASE("abaqus: files of other programs are recognised, and one without elements is empty") {
  check_refused("8 6 0 0 0\n1 0 0 0\n", "hull.inp:1: `8 6 0 0 0` appears where a keyword such as *NODE is expected; this is not an Abaqus input file.");
  CHECK_THROWS_AS(parse(std::string("\x7f"
                                    "ELF\x02\x01\0\0",
                                    8)),
                  InputError);
  CHECK(parse("").size() == 0);
  CHECK(parse("** nothing\n\n").size() == 0);
}

TEST_CASE("abaqus: a truncated or damaged file is read or refused in one sentence") {
  const Elements block = fixtures::block_of(ElementKind::tetrahedron, 1);
  const std::string whole =
      "*PART, NAME=p\n" + fixtures::abaqus_mesh(block) +
      "*ELSET, ELSET=s, GENERATE\n1, 5, 2\n*END PART\n*ASSEMBLY\n*INSTANCE, NAME=i, PART=p\n1,2,3\n0,0,0,1,1,1,45\n*END INSTANCE\n*END ASSEMBLY\n";
  for (std::size_t length = 0; length < whole.size(); ++length) check_read_or_refused(whole.substr(0, length), 8);
  std::mt19937_64 random(1);
  for (int trial = 0; trial < 2000; ++trial) {
    std::string contents = whole;
    for (std::size_t k = 0; k < 1 + random() % 4; ++k)
      contents[random() % contents.size()] = static_cast<char>(random() % 3 == 0 ? random() : "*,\n =0129-eE"[random() % 12]);
    check_read_or_refused(contents, 40);
  }
}
