#include "mesh_io/keyword/abaqus_model.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "fixtures/keyword_files.hpp"
#include "fixtures/tolerance.hpp"
#include "mesh/surface.hpp"
#include "mesh_io/keyword/abaqus.hpp"

using namespace fccda;

namespace {

Elements parse(const std::string& contents) { return parse_abaqus(contents, "hull.inp"); }
void check_refused(const std::string& contents, const char* sentence) { CHECK_THROWS_WITH_AS(parse(contents), sentence, InputError); }

using Names = std::vector<std::string>;

const std::string mesh = "*NODE\n1,0,0,0\n2,1,0,0\n3,1,1,0\n4,0,1,0\n*ELEMENT, TYPE=S3\n1,1,2,3\n2,1,3,4\n";
std::string part(const std::string& name, const std::string& contents = mesh) { return "*PART, NAME=" + name + "\n" + contents + "*END PART\n"; }
std::string instance(const std::string& name, const std::string& of, const std::string& lines = "") {
  return "*INSTANCE, NAME=" + name + ", PART=" + of + "\n" + lines + "*END INSTANCE\n";
}
std::string assembly(const std::string& contents) { return "*ASSEMBLY, NAME=a\n" + contents + "*END ASSEMBLY\n"; }

/// Name of the part of each element.
Names parts(const Elements& elements) {
  Names out;
  for (const int part : elements.part) out.push_back(elements.part_names[std::size_t(part)]);
  return out;
}

}  // namespace

TEST_CASE("abaqus assembly: an instance is first translated, then rotated about the axis through two points") {
  // a third of a turn about the diagonal through (1, 0, 0) takes x to y, y to z and z to x about that point
  const Elements turned = parse(part("p") + assembly(instance("i", "p", "10, 20, 30\n1, 0, 0, 2, 1, 1, 120\n")));
  const auto cycled = [](const Vec3d& v) {
    const Vec3d moved = v + Vec3d{10, 20, 30} - Vec3d{1, 0, 0};
    return Vec3d{moved.z, moved.x, moved.y} + Vec3d{1, 0, 0};
  };
  const std::vector<Vec3d> corners{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  REQUIRE(turned.vertices.size() == 4);
  for (std::size_t v = 0; v < 4; ++v) CHECK(norm(turned.vertices[v] - cycled(corners[v])) < 1e-13);  // some roundings of numbers of 30

  // arbitrary axis and angle: distances from two points of the axis are preserved, and the angle is the given one
  const Vec3d a{0.3, -0.2, 0.5}, b{-1, 2, 0.25}, t{0.5, 0.25, -2};
  const Elements any = parse(part("p") + assembly(instance("i", "p", "0.5, 0.25, -2\n0.3, -0.2, 0.5, -1, 2, 0.25, -37.5\n")));
  const Vec3d axis = normalised(b - a);
  for (std::size_t v = 0; v < 4; ++v) {
    const Vec3d before = corners[v] + t, after = any.vertices[v];
    CHECK(norm(after - a) == fixtures::relative(norm(before - a), 1e-12));
    CHECK(norm(after - b) == fixtures::relative(norm(before - b), 1e-12));
    const Vec3d arm = before - a - dot(before - a, axis) * axis, turned_arm = after - a - dot(after - a, axis) * axis;
    CHECK(std::atan2(dot(cross(arm, turned_arm), axis), dot(arm, turned_arm)) == fixtures::relative(-37.5 * std::numbers::pi / 180, 1e-12));
  }
}

TEST_CASE("abaqus assembly: blank lines leave the mesh bitwise unchanged") {
  const Elements still = parse(part("p") + assembly(instance("i", "p")));
  CHECK(still.vertices == parse(mesh).vertices);
  CHECK(parse(part("p") + assembly(instance("i", "p", "\n\n"))).vertices == still.vertices);
  CHECK(parse(part("p") + assembly(instance("i", "p", "1,,\n"))).vertices[0] == Vec3d{1, 0, 0});
  check_refused(part("p") + assembly(instance("i", "p", "\n1,1,1,1,1,1,5\n")),
                "hull.inp:14: instance i is rotated about an axis defined by two equal points; correct the two points.");
  check_refused(part("p") + assembly(instance("i", "p", "0,x,0\n")),
                "hull.inp:13: instance i has `x` where a finite number is expected; correct the file or export it again.");
}

TEST_CASE("abaqus assembly: each instance is a copy of its part, and parts without an instance are omitted") {
  const Elements two = parse(part("Hull") + part("unused") + assembly(instance("hull-1", "HULL") + instance("hull-2", "hull", "5,0,0\n")));
  CHECK(two.size() == 4);
  CHECK(two.vertices.size() == 8);
  CHECK(two.vertices[4] == Vec3d{5, 0, 0});
  CHECK(two.part_names == Names{"hull-1", "hull-2"});
  CHECK(parse(part("a") + part("b")).part_names == Names{"a", "b"});  // without an assembly all parts are read
}

TEST_CASE("abaqus assembly: numbers refer to nodes of the same part, and instances and the assembly may define a mesh") {
  const std::string other = "*NODE\n1,7,7,7\n2,8,7,7\n3,7,8,7\n*ELEMENT, TYPE=S3\n1,1,2,3\n";
  const Elements all = parse(mesh + part("p", other) + assembly(instance("i", "p") + "*INSTANCE, NAME=j, PART=p\n0,0,1\n" + other + "*END INSTANCE\n" + other));
  CHECK(all.size() == 2 + 1 + 2 + 1);
  CHECK(parts(all) == Names{"", "", "i", "j", "j", ""});
  CHECK(all.vertices[std::size_t(all.nodes_of_element(4)[0])] == Vec3d{7, 7, 8});  // moved as its instance
}

TEST_CASE("abaqus parts: ELSET= on *ELEMENT names them, after the instance name where there is more than one") {
  const std::string two_sets = "*NODE\n1,0,0,0\n2,1,0,0\n3,1,1,0\n4,0,1,0\n*ELEMENT, TYPE=S3, ELSET=Bow\n1,1,2,3\n*ELEMENT, TYPE=S3\n2,1,3,4\n";
  CHECK(parts(parse(two_sets)) == Names{"Bow", ""});
  CHECK(parts(parse(part("p", two_sets) + assembly(instance("HULL-1", "p")))) == Names{"Bow", "HULL-1"});
  CHECK(parts(parse(part("p", two_sets) + assembly(instance("HULL-1", "p") + instance("HULL-2", "p")))) ==
        Names{"HULL-1.Bow", "HULL-1", "HULL-2.Bow", "HULL-2"});
}

TEST_CASE(
    "abaqus parts: an element without ELSET= belongs to the smallest *ELSET that lists it, and a set that shares elements with a smaller one is ignored") {
  const std::string four = "*NODE\n1,0,0,0\n2,1,0,0\n3,1,1,0\n4,0,1,0\n5,0,0,1\n*ELEMENT, TYPE=S3\n1,1,2,3\n2,1,3,4\n3,1,2,5\n4,2,3,5\n";
  CHECK(parts(parse(four + "*ELSET, ELSET=all, GENERATE\n1, 4\n*ELSET, ELSET=bow\n1, 3,\n")) == Names{"bow", "", "bow", ""});
  CHECK(parts(parse(four + "*ELSET, ELSET=odd, GENERATE\n1, 4, 2\n*ELSET, ELSET=even\n2\n*ELSET, ELSET=Even\n4\n")) == Names{"odd", "even", "odd", "even"});
  CHECK(parts(parse(four + "*ELSET, ELSET=_pick, INTERNAL\n1\n*ELSET, ELSET=_p\n2\n*ELSET, ELSET=x\n3\n*ELSET, ELSET=both\nx, 4\n")) == Names{"", "", "x", ""});
  CHECK(parts(parse(four +
                    "*ELSET, ELSET=far, GENERATE\n1000, 9000000000000000000\n*ELSET, ELSET=near, GENERATE\n4, 9000000000000000000, 9000000000000000000\n")) ==
        Names{"", "", "", "near"});
  CHECK(parts(parse(part("p", four + "*ELSET, ELSET=bow\n1\n") + assembly(instance("h", "p")))) == Names{"bow", "h (rest)", "h (rest)", "h (rest)"});
  CHECK(parts(parse(part("p", four) + assembly(instance("h", "p") + instance("k", "p") + "*ELSET, ELSET=bow, INSTANCE=K\n1\n"))) ==
        Names{"h", "h", "h", "h", "k.bow", "k (rest)", "k (rest)", "k (rest)"});
  check_refused(four + "*ELSET, ELSET=x, GENERATE\n1, 4, 0\n",
                "hull.inp:13: *ELSET has `0` where an increment is expected; correct the file or export it again.");
}

TEST_CASE("abaqus assembly: missing, duplicate, unclosed and misplaced items are refused by name") {
  check_refused(part("p") + assembly(instance("i", "q")), "hull.inp:12: instance i is of part q, which is not defined; correct the name or add the part.");
  check_refused(part("p") + part("P"), "hull.inp:11: part P is already defined; rename one of the two.");
  check_refused(part("p") + assembly(instance("i", "p") + instance("I", "p", "1,0,0\n")), "hull.inp:14: instance I is already defined; rename one of the two.");
  check_refused("*PART, NAME=p\n" + mesh, "hull.inp:9: the file ends before *END PART; it is truncated: export it again.");
  check_refused("*ASSEMBLY\n", "hull.inp:1: the file ends before *END ASSEMBLY; it is truncated: export it again.");
  check_refused("*PART, NAME=p\n*PART, NAME=q\n",
                "hull.inp:2: *PART is not allowed here; parts cannot contain parts, and instances must be inside an assembly.");
  check_refused("*END INSTANCE\n", "hull.inp:1: *ENDINSTANCE is not allowed here; parts cannot contain parts, and instances must be inside an assembly.");
  check_refused("*PART\n", "hull.inp:1: *PART needs NAME=; correct the keyword.");
  check_refused("*ASSEMBLY\n*INSTANCE, LIBRARY=old, INSTANCE=i\n",
                "hull.inp:2: this instance is imported from another analysis, but only this file is read; export the mesh itself.");
}

TEST_CASE("abaqus assembly: a small file that expands to a huge mesh is refused before it exhausts memory or time") {
  std::string nodes = "*NODE\n";
  for (int k = 1; k <= 10000; ++k) nodes += std::to_string(k) + "\n";
  std::string instances;
  for (int k = 0; k < 1000; ++k) instances += instance("i" + std::to_string(k), "p");
  CHECK_THROWS_WITH_AS(parse(part("p", nodes) + assembly(instances)),
                       doctest::Contains("instances and sets expand to more than 8388608 nodes and set members; export only the parts in the contact area."),
                       InputError);
  // neither do sets that list all elements over and over, nor long names
  std::string sets;
  for (int k = 0; k < 3000; ++k) sets += "*ELSET, ELSET=s" + std::to_string(k) + ", GENERATE\n1, 3000, 7000\n";
  std::string elements = "*NODE\n1\n2\n3\n*ELEMENT, TYPE=S3\n";
  for (int k = 1; k <= 3000; ++k) elements += std::to_string(k) + ",1,2,3\n";
  CHECK_THROWS_WITH_AS(parse(elements + sets), doctest::Contains("instances and sets expand to more than"), InputError);
  std::string set = "*NODE\n1\n2\n3\n*ELEMENT, TYPE=S3, ELSET=" + std::string(10000, 'x') + "\n1,1,2,3\n";
  CHECK_THROWS_WITH_AS(parse(part("p", set) + assembly(instances)), doctest::Contains("instances and sets expand to more than"), InputError);
}
