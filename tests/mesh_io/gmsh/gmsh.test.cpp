#include "mesh_io/gmsh/gmsh.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "base/error.hpp"
#include "fixtures/gmsh_files.hpp"
#include "fixtures/surfaces.hpp"
#include "fixtures/tolerance.hpp"
#include "mesh/shapes/sphere.hpp"
#include "mesh/surface.hpp"

using namespace fccda;
using fixtures::GmshForm;
using fixtures::GmshMesh;

namespace {

Panels parse(const std::string& contents) { return panels_of(parse_gmsh(contents, "hull.msh"), "hull.msh"); }
void check_refused(const std::string& contents, const char* sentence) { CHECK_THROWS_WITH_AS(parse(contents), sentence, InputError); }

std::string with(std::string text, const std::string& old, const std::string& replacement) {
  REQUIRE(text.find(old) != std::string::npos);
  return text.replace(text.find(old), old.size(), replacement);
}

std::string described(const GmshForm& form) {
  return std::to_string(form.version) + (form.is_binary ? " binary" : " text") + (form.is_other_order ? ", other byte order" : "");
}

/// Panels of each part by name, whatever the order of the parts.
std::map<std::string, int> panels_by_part(const Panels& panels) {
  std::map<std::string, int> counts;
  for (const int part : panels.part) ++counts[panels.part_names[std::size_t(part)]];
  return counts;
}

const GmshForm text_2{22}, text_4{41}, binary_2{22, true}, binary_4{41, true};

/// Two triangles, in a form that can be broken on purpose.
std::string small(const GmshForm& form) {
  return gmsh_file(fixtures::gmsh_mesh({{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2, -1}, {0, 2, 3, -1}}, {}, {}}), form);
}

/// A cube of 2 x 2 x 2 hexahedra, those at the bottom in entity 1.
GmshMesh block() {
  GmshMesh mesh;
  for (int v = 0; v < 27; ++v) mesh.vertices.push_back({double(v % 3), double(v / 3 % 3), double(v / 9)});
  for (int c = 0; c < 8; ++c) {
    const int o = c % 2 + 3 * (c / 2 % 2) + 9 * (c / 4);
    mesh.elements.push_back({5, {o, o + 1, o + 4, o + 3, o + 9, o + 10, o + 13, o + 12}, 1 + c / 4});
  }
  return mesh;
}

/// A second-order solid: corners on the unit sphere, and the corner numbers of its edges in Gmsh's order of mid-side nodes.
struct Curved {
  int type, complete_type;
  std::size_t nodes_of_complete;
  std::vector<Vec3d> corners;
  std::vector<std::array<int, 2>> edges;
  std::vector<std::vector<int>> faces;
};

std::vector<Curved> curved_solids() {
  const double h = 1 / std::sqrt(3.0), b = std::sqrt(0.6), r = std::sqrt(3.0) / 2;
  const std::vector<Vec3d> cube{{-h, -h, -h}, {h, -h, -h}, {h, h, -h}, {-h, h, -h}, {-h, -h, h}, {h, -h, h}, {h, h, h}, {-h, h, h}};
  const std::vector<Vec3d> tetrahedron{{h, h, h}, {h, -h, -h}, {-h, h, -h}, {-h, -h, h}};
  const std::vector<Vec3d> wedge{{r, 0, -0.5}, {-r / 2, 0.75, -0.5}, {-r / 2, -0.75, -0.5}, {r, 0, 0.5}, {-r / 2, 0.75, 0.5}, {-r / 2, -0.75, 0.5}};
  const double c = std::sqrt(1 - b * b);
  const std::vector<Vec3d> pyramid{{b, 0, -c}, {0, b, -c}, {-b, 0, -c}, {0, -b, -c}, {0, 0, 1}};
  return {{11, 11, 10, tetrahedron, {{0, 1}, {1, 2}, {2, 0}, {3, 0}, {2, 3}, {1, 3}}, {{0, 1, 2}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}},
          {17,
           12,
           27,
           cube,
           {{0, 1}, {0, 3}, {0, 4}, {1, 2}, {1, 5}, {2, 3}, {2, 6}, {3, 7}, {4, 5}, {4, 7}, {5, 6}, {6, 7}},
           {{0, 1, 2, 3}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}},
          {18,
           13,
           18,
           wedge,
           {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 4}, {2, 5}, {3, 4}, {3, 5}, {4, 5}},
           {{0, 1, 2}, {3, 4, 5}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}}},
          {19, 14, 14, pyramid, {{0, 1}, {0, 3}, {0, 4}, {1, 2}, {1, 4}, {2, 3}, {2, 4}, {3, 4}}, {{0, 1, 2, 3}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}}};
}

Vec3d on_sphere(const Vec3d& a, const Vec3d& b) { return normalised(a + b); }
double area(const Vec3d& a, const Vec3d& b, const Vec3d& c) { return 0.5 * norm(cross(b - a, c - a)); }

/// Area over corners and mid-side nodes, from the corners of the faces alone.
double area_of(const Curved& solid) {
  double sum = 0;
  for (const std::vector<int>& face : solid.faces) {
    std::vector<Vec3d> middles;
    for (std::size_t k = 0; k < face.size(); ++k)
      middles.push_back(on_sphere(solid.corners[std::size_t(face[k])], solid.corners[std::size_t(face[(k + 1) % face.size()])]));
    for (std::size_t k = 0; k < face.size(); ++k) sum += area(solid.corners[std::size_t(face[k])], middles[k], middles[(k + face.size() - 1) % face.size()]);
    sum += area(middles[0], middles[1], middles[2]);
    if (face.size() == 4) sum += area(middles[0], middles[2], middles[3]);
  }
  return sum;
}

}  // namespace

TEST_CASE("gmsh: quads and triangles are read back exactly from every version, as text and binary in both byte orders") {
  for (const Panels& given : {fixtures::unit_cube(), make_sphere({.diameter = 0.7, .edge_length = 0.2}), fixtures::torus(2, 0.5, 9, 7)}) {
    for (const GmshForm& form : fixtures::every_gmsh_form()) {
      CAPTURE(described(form));
      const Panels back = parse(gmsh_file(fixtures::gmsh_mesh(given), form));
      CHECK(back.panels == given.panels);
      CHECK(back.vertices == given.vertices);
      CHECK(back.part_names == std::vector<std::string>{"surface 1"});
    }
  }
}

TEST_CASE("gmsh: parametric coordinates and sections that do not concern the surface are skipped") {
  const Panels cube = fixtures::unit_cube();
  GmshMesh mesh = fixtures::gmsh_mesh(cube);
  mesh.has_other_sections = true;
  for (const GmshForm& form : fixtures::every_gmsh_form()) {
    CAPTURE(described(form));
    mesh.is_parametric = form.version != 22;
    const Panels back = parse(gmsh_file(mesh, form));
    CHECK(back.panels == cube.panels);
    CHECK(back.vertices == cube.vertices);
  }
}

TEST_CASE("gmsh: the boundary faces of hexahedra are read, and volumes are parts") {
  GmshMesh mesh = block();
  mesh.names = {{{3, 7}, "ice"}, {{2, 7}, "of a surface"}};
  mesh.groups = {{{3, 1}, {7}}};
  for (const GmshForm& form : fixtures::every_gmsh_form()) {
    CAPTURE(described(form));
    const Panels skin = parse(gmsh_file(mesh, form));
    CHECK(Surface(skin).report().volume == fixtures::relative(8, 1e-12));  // rounding
    CHECK(panels_by_part(skin) == std::map<std::string, int>{{"ice", 4 + 8}, {"volume 2", 4 + 8}});
  }
}

TEST_CASE("gmsh: mid-side nodes of second-order solids belong to the edges given in the Gmsh manual") {
  for (const Curved& solid : curved_solids()) {
    GmshMesh mesh;
    mesh.vertices = solid.corners;
    for (const auto& [a, b] : solid.edges) mesh.vertices.push_back(on_sphere(solid.corners[std::size_t(a)], solid.corners[std::size_t(b)]));
    GmshMesh complete = mesh;
    complete.vertices.resize(solid.nodes_of_complete);  // mid-face and mid-volume nodes are ignored
    for (const auto& [one, type_of_one] : {std::pair(&mesh, solid.type), std::pair(&complete, solid.complete_type)}) {
      const int type = type_of_one;  // a plain variable, for CAPTURE with clang
      CAPTURE(type);
      one->elements.push_back({type, {}});
      for (int n = 0; n < int(one->vertices.size()); ++n) one->elements[0].nodes.push_back(n);
      for (const GmshForm& form : {text_2, binary_2, text_4, binary_4}) {
        const Surface surface(parse(gmsh_file(*one, form)));
        CHECK(surface.is_closed());
        CHECK(surface.report().rewound + surface.report().flipped == 0);
        CHECK(surface.report().area == fixtures::relative(area_of(solid), 1e-12));  // rounding
      }
    }
  }
}

TEST_CASE("gmsh: second-order surface elements follow their mid-side nodes, in both orientations of an entity") {
  const std::vector<Vec3d> square{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {1, 0, 0}, {2, 1, 0}, {1, 2, 0}, {0, 1, 0}, {1, 1, 0}};
  const std::vector<std::pair<GmshMesh, double>> cases{{{square, {{16, {0, 1, 2, 3, 4, 5, 6, 7}}}}, 4},
                                                       {{square, {{10, {0, 1, 2, 3, 4, 5, 6, 7, 8}}}}, 4},
                                                       {{square, {{9, {0, 1, 2, 4, 5, 8}}}}, 2},
                                                       {{square, {{3, {0, 1, 2, 3}}}}, 4},
                                                       {{square, {{2, {0, 1, 2}}}}, 2}};
  for (auto [mesh, expected] : cases) {
    for (const int sign : {1, -1}) {
      mesh.groups = {{{2, 1}, {sign * 5}}};
      const Panels panels = parse(gmsh_file(mesh));
      double up = 0;
      fixtures::for_each_triangle(panels, [&](const Vec3d& a, const Vec3d& b, const Vec3d& c) { up += 0.5 * cross(b - a, c - a).z; });
      CHECK(up == sign * expected);  // halves, exact
    }
  }
}

TEST_CASE("gmsh: parts are named after all their groups, or else after the entity") {
  GmshMesh mesh = fixtures::gmsh_mesh(fixtures::unit_cube());
  for (int k = 0; k < 6; ++k) mesh.elements[std::size_t(2 + k)].entity = 11 + k;
  mesh.names = {{{2, 1}, "deck \"A\""}, {{2, 2}, "hull"}, {{2, 3}, "hull"}, {{3, 4}, "of a volume"}, {{2, 4}, "in no entity"}};
  mesh.groups = {{{2, 11}, {1}}, {{2, 12}, {2}}, {{2, 13}, {2, 1}}, {{2, 14}, {3}}, {{2, 15}, {9}}};
  for (const GmshForm& form : fixtures::every_gmsh_form()) {
    CAPTURE(described(form));
    const Panels panels = parse(gmsh_file(mesh, form));
    CHECK(panels.panels.size() == 6);
    CHECK(panels_by_part(panels) ==
          std::map<std::string, int>{{"deck \"A\"", 1}, {"hull", 2}, {"deck \"A\" + hull", 1}, {"physical surface 9", 1}, {"surface 16", 1}});
  }
}

TEST_CASE("gmsh: part names joined from many groups are limited to 200 bytes, so that names do not outgrow the file") {
  GmshMesh mesh = fixtures::gmsh_mesh(fixtures::unit_cube());
  for (int k = 0; k < 6; ++k) mesh.elements[std::size_t(2 + k)].entity = 11 + k;
  const std::string a(100, 'a'), b(97, 'b'), c(98, 'c'), d(500, 'd');
  mesh.names = {{{2, 1}, a}, {{2, 2}, b}, {{2, 3}, c}, {{2, 4}, d}};
  mesh.groups = {{{2, 11}, {1, 2}}, {{2, 12}, {1, 3}}, {{2, 13}, {1, 2, 3, 4}}, {{2, 14}, {4}}, {{2, 15}, {2, 4}}, {{2, 16}, {1, 4}}};
  for (const GmshForm& form : fixtures::every_gmsh_form()) {
    CAPTURE(described(form));
    CHECK(panels_by_part(parse(gmsh_file(mesh, form))) ==
          std::map<std::string, int>{{a + " + " + b, 1}, {a + " + 1 more", 2}, {a + " + " + b + " + 2 more", 1}, {d, 1}, {b + " + 1 more", 1}});
  }

  // each of 2000 surfaces is in all of 40 groups with long names
  GmshMesh many;
  many.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  std::vector<int> groups;
  for (int k = 1; k <= 40; ++k) many.names[{2, k}] = std::string(125, 'n') + std::to_string(k), groups.push_back(k);
  for (int k = 1; k <= 2000; ++k) {
    many.elements.push_back({2, {0, 1, 2}, k});
    many.groups[{2, k}] = groups;
    many.groups[{2, k}].push_back(40 + k);
  }
  const std::string contents = gmsh_file(many, text_4);
  std::size_t letters = 0;
  for (const std::string& name : parse(contents).part_names) letters += name.size();
  CHECK(letters < contents.size());
}

TEST_CASE("gmsh: an element that version 2 lists for each of its groups is one, also of a solid") {
  GmshMesh mesh = block();
  mesh.groups = {{{3, 1}, {1}}, {{3, 2}, {2, 1, 3}}};
  for (const GmshForm& form : {text_2, binary_2}) {
    const Panels skin = parse(gmsh_file(mesh, form));
    CHECK(skin.panels.size() == 24);
    CHECK(panels_by_part(skin) == std::map<std::string, int>{{"physical volume 1", 12}, {"physical volume 1 + physical volume 2 + physical volume 3", 12}});
  }
}

TEST_CASE("gmsh: partitions are named after their groups, or else after the parent entity") {
  GmshMesh mesh = fixtures::gmsh_mesh(fixtures::unit_cube());
  for (int k = 0; k < 6; ++k) mesh.elements[std::size_t(2 + k)].entity = 11 + k;
  mesh.names = {{{2, 1}, "hull"}};
  mesh.groups = {{{2, 13}, {1}}};
  mesh.parent = {{{2, 11}, {2, 3}}, {{2, 12}, {2, 3}}, {{2, 13}, {2, 4}}, {{2, 14}, {3, 1}}};
  for (const GmshForm& form : fixtures::every_gmsh_form()) {
    if (form.version == 22) continue;  // gives partitions as tags of each element
    CAPTURE(described(form));
    CHECK(panels_by_part(parse(gmsh_file(mesh, form))) ==
          std::map<std::string, int>{{"surface 3", 2}, {"hull", 1}, {"surface 14", 1}, {"surface 15", 1}, {"surface 16", 1}});
  }
}

TEST_CASE("gmsh: names without dimension (version 2.0), elements without tags and nodes with huge numbers are read") {
  const Panels panels = parse(
      "$MeshFormat\r\n2 0 8\r\n$EndMeshFormat\r\n$PhysicalNames\r\n1\r\n5 \"old hull\"\r\n$EndPhysicalNames\r\n$Nodes\r\n3\r\n2000000000 0 0 0\r\n-7 1 0 0\r\n"
      "3 0 +1 0\r\n$EndNodes\r\n$Elements\r\n2\r\n1 2 1 5 2000000000 -7 3\r\n2 2 0 3 -7 2000000000\r\n$EndElements");
  CHECK(panels.vertices == std::vector<Vec3d>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  CHECK(panels.panels == std::vector<std::array<int, 4>>{{0, 1, 2, -1}, {2, 1, 0, -1}});
  CHECK(panels.part_names == std::vector<std::string>{"old hull", ""});
}

TEST_CASE("gmsh: a file truncated anywhere before its last section ends is refused") {
  GmshMesh mesh = fixtures::gmsh_mesh(fixtures::unit_cube());
  mesh.names = {{{2, 1}, "hull"}};
  mesh.groups = {{{2, 1}, {1}}};
  mesh.has_other_sections = true;
  for (const GmshForm& form : fixtures::every_gmsh_form()) {
    CAPTURE(described(form));
    const std::string whole = gmsh_file(mesh, form);
    std::vector<std::size_t> ends;  // valid ends of a file: after $EndElements and later sections, with or without the line end
    for (const char* last : {"$EndElements", "$EndPeriodic", "$EndNodeData"}) {
      const std::size_t end = whole.rfind(last) + std::string(last).size();
      ends.insert(ends.end(), {end, end + 1});
    }
    for (std::size_t length = 0; length < whole.size(); ++length) {
      if (std::find(ends.begin(), ends.end(), length) != ends.end()) {
        CHECK(parse(whole.substr(0, length)).panels.size() == 6);
      } else {
        CHECK_THROWS_AS(parse(whole.substr(0, length)), InputError);
      }
    }
  }
  const std::string text = small(text_4), binary = small(binary_2);
  check_refused(text.substr(0, text.find("$EndNodes") - 10), "hull.msh:21: the file ends in node 3 of 4; it is truncated: export it again.");
  check_refused(text.substr(0, text.find("$Elements")),
                "hull.msh:24: the file ends without `$Elements`; it is truncated or contains no mesh: export it again.");
  check_refused(text.substr(0, text.find("$EndElements")), "hull.msh:36: the file ends before `$EndElements`; it is truncated: export it again.");
  check_refused(binary.substr(0, binary.find("$EndElements") - 10), "hull.msh: the file ends in element 5 of 5; it is truncated: export it again.");
  check_refused(binary.substr(0, 30), "hull.msh: the file ends before `$EndMeshFormat`; it is truncated: export it again.");
}

TEST_CASE("gmsh: files that are not Gmsh meshes, and unsupported versions, are refused by name") {
  check_refused("", "hull.msh:1: nothing appears where `$MeshFormat` is expected, so this is not a Gmsh mesh; export it as one.");
  check_refused("solid hull", "hull.msh:1: `solid` appears where `$MeshFormat` is expected, so this is not a Gmsh mesh; export it as one.");
  check_refused("$NOD\n1\n", "hull.msh:1: version 1 of the Gmsh format is not supported; open the mesh in Gmsh and export it as version 4 or 2.");
  check_refused(with(small(text_4), "4.1 0", "5 0"),
                "hull.msh:2: `5` is not a supported version of the Gmsh format; open the mesh in Gmsh and export it as version 2, 4.0 or 4.1.");
  check_refused(with(small(text_4), "0 8", "2 8"),
                "hull.msh:2: `2` appears where 0 (text) or 1 (binary) is expected after the version; correct the file or export it again.");
  check_refused(with(small(text_4), "0 8", "0 4"), "hull.msh:2: the file has numbers of `4` bytes, but 8 are required; export it on a 64-bit machine.");
  check_refused(with(small(text_2), "$Nodes", "$ParametricNodes"),
                "hull.msh:4: the section `$ParametricNodes` is not supported; export the mesh without parametric coordinates (Mesh.SaveParametric 0).");
}

TEST_CASE("gmsh: binary declared as text and text declared as binary are refused") {
  check_refused(with(small(text_4), "0 8", "1 8"),
                "hull.msh: the header declares binary data, but the integer 1 that marks the byte order does not follow; the file is text or was transferred "
                "as text: export it again.");
  check_refused(with(small(binary_4), "1 8", "0 8"),
                "hull.msh:3: `????` appears where `$EndMeshFormat` is expected; the count or the file is damaged: export it again.");
}

TEST_CASE("gmsh: false counts are refused without allocating memory") {
  const std::string text = small(text_2), blocks = small(text_4), binary = small(binary_2);
  check_refused(with(text, "$Nodes\n4", "$Nodes\n4000000000"),
                "hull.msh:10: `$EndNodes` appears in node 5 of 4000000000; the count or the file is damaged: export it again.");
  check_refused(with(text, "$Nodes\n4", "$Nodes\n3"),
                "hull.msh:9: `13 0 1 0` appears where `$EndNodes` is expected; the count or the file is damaged: export it again.");
  check_refused(with(text, "$Nodes\n4", "$Nodes\n-4"), "hull.msh:5: `-4` appears where the number of nodes is expected; correct the file or export it again.");
  check_refused(with(text, "$Elements\n5", "$Elements\nfive"),
                "hull.msh:12: `five` appears where the number of elements is expected; correct the file or export it again.");
  check_refused(with(blocks, "$Nodes\n2 4 ", "$Nodes\n2 5 "),
                "hull.msh:22: the blocks contain 4 nodes, but the section states 5; the file is damaged: export it again.");
  check_refused(with(blocks, "$Nodes\n2 4 ", "$Nodes\n-2 4 "),
                "hull.msh:12: the beginning of `$Nodes` has `-2` where a count is expected; the count or the file is damaged: export it again.");
  check_refused(with(binary, "$Elements\n5", "$Elements\n2"),
                "hull.msh: `????????????????????????…` appears where `$EndElements` is expected; the count or the file is damaged: export it again.");
  std::string block_of_minus_1 = binary;
  const std::size_t in_block = binary.find("$Elements\n5\n") + 12 + 4;  // after the type of the first block
  block_of_minus_1.replace(in_block, 4, "\xff\xff\xff\xff");
  check_refused(block_of_minus_1, "hull.msh: element 1 of 5 begins a block of -1; the count or the file is damaged: export it again.");
}

TEST_CASE("gmsh: invalid coordinates, numbers and nodes are refused with the line, or the node or element") {
  const std::string text = small(text_2);
  check_refused(with(text, "7 1 0 0", "7 1 nan 0"),
                "hull.msh:7: node 2 of 4 has `nan` where a finite number is expected; correct the file or export it again.");
  check_refused(with(text, "7 1 0 0", "x 1 0 0"), "hull.msh:7: node 2 of 4 has `x` where an integer is expected; correct the file or export it again.");
  check_refused(
      with(text, "7 1 0 0", "99999999999 1 0 0"),
      "hull.msh:7: node 2 of 4 has the number `99999999999`, which is out of range; renumber the mesh in Gmsh, or export it again if the file is damaged.");
  check_refused(with(text, "7 1 0 0", "10 1 0 0"), "hull.msh:9: two nodes have the number 10; renumber the mesh in Gmsh and export it again.");
  check_refused(with(text, "1002 2 3 0 1 0 10 7 16", "1002 2 3 0 1 0 10 7 8"),
                "hull.msh:15: element 3 of 5 has node `8`, which is not defined; repair the mesh and export it again.");
  check_refused(
      with(text, "1002 2 3 0 1 0 10 7 16", "1002 21 3 0 1 0 10 7 16"),
      "hull.msh:15: elements of Gmsh type 21 are not supported, only points, lines, triangles, quads, tetrahedra, hexahedra, prisms and pyramids of first or "
      "second order; set Mesh.ElementOrder to 1 or 2 and export the mesh again.");
  check_refused(with(text, "1002 2 3 0", "1002 2 -3 0"), "hull.msh:15: element 3 of 5 has -3 tags; the file is damaged: export it again.");
  Panels bad = fixtures::unit_cube();
  bad.vertices[3].z = std::numeric_limits<double>::infinity();
  check_refused(gmsh_file(fixtures::gmsh_mesh(bad), binary_4),
                "hull.msh: node 4 of 8 has a coordinate that is not a finite number; repair the mesh and export it again.");
}

TEST_CASE("gmsh: invalid names, sections out of order and text between them are refused") {
  GmshMesh mesh = fixtures::gmsh_mesh(fixtures::unit_cube());
  mesh.names = {{{2, 1}, "hull"}};
  const std::string text = gmsh_file(mesh, text_2);
  check_refused(with(text, "2 1 \"hull\"", "2 1 hull"),
                "hull.msh:6: physical name 1 of 1 is `2 1 hull`, but must have the form `2 1 \"hull\"`; correct the file or export it again.");
  check_refused(with(text, "2 1 \"hull\"", "2 1 \"hull"),
                "hull.msh:6: physical name 1 of 1 is `2 1 \"hull`, but must have the form `2 1 \"hull\"`; correct the file or export it again.");
  check_refused(with(text, "\"hull\"", '"' + std::string(600, 'x') + '"'),
                "hull.msh:6: physical name 1 of 1 is longer than 127 characters; shorten it in Gmsh and export it again.");
  check_refused(with(text, "$EndPhysicalNames", "$EndPhysicalNames\njunk"),
                "hull.msh:8: `junk` appears where a section such as `$Nodes` is expected; correct the file or export it again.");
  check_refused("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Elements\n", "hull.msh:4: `$Elements` comes before `$Nodes`; export the file again with Gmsh.");
  check_refused(with(text, "$EndNodes", "$EndNodes\n$Nodes"), "hull.msh:19: there is a second `$Nodes` section; export each mesh to a separate file.");
}

TEST_CASE("gmsh: damaged files are read or refused, never more") {
  std::mt19937_64 random(1);
  GmshMesh mesh = block();
  mesh.names = {{{3, 1}, "ice"}};
  mesh.groups = {{{3, 1}, {1, 2}}};
  mesh.has_other_sections = true;
  for (const GmshForm& form : fixtures::every_gmsh_form()) {
    const std::string whole = gmsh_file(mesh, form);
    for (int trial = 0; trial < 500; ++trial) {
      std::string contents = whole;
      for (std::size_t k = 0; k < 1 + random() % 4; ++k)
        contents[random() % contents.size()] = static_cast<char>(trial % 2 == 0 ? random() : '0' + random() % 10);
      std::string sentence;
      std::size_t panels = 0;
      try {
        panels = parse(contents).panels.size();
      } catch (const InputError& error) {
        sentence = error.what();
        CHECK(sentence.starts_with("hull.msh:"));
      }
      CHECK(panels <= 8 * 6);
      CHECK(sentence.find('\n') == std::string::npos);
      CHECK(sentence.find('\0') == std::string::npos);
    }
  }
}
