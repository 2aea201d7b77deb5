// Solids: points inside and outside of every shape, against the formula of the shape and against the panels of its mesh.
#include "perimpact/discretisation/solid.hpp"

#include <doctest/doctest.h>

#include <filesystem>
#include <numbers>
#include <random>

#include "base/error.hpp"
#include "fixtures/surface_files.hpp"
#include "fixtures/surfaces.hpp"
#include "fixtures/temporary_folder.hpp"
#include "fixtures/tolerance.hpp"
#include "mesh/shapes/box.hpp"
#include "mesh/shapes/cylinder.hpp"
#include "mesh/shapes/sphere.hpp"
#include "mesh_io/read_panels.hpp"

using namespace perimpact;

namespace {

struct Form {
  SolidShape shape;
  double (*distance)(const Vec3d& local);  // [m] how far outside, negative inside, or nearly so: by formula
};

const Vec3d box_size{1.2, 0.8, 0.5};
constexpr double cylinder_diameter = 0.9, cylinder_height = 1.4, sphere_diameter = 1.1;

double distance_of_box(const Vec3d& p) { return std::max({std::fabs(p.x) - box_size.x / 2, std::fabs(p.y) - box_size.y / 2, std::fabs(p.z) - box_size.z / 2}); }
double distance_of_cylinder(const Vec3d& p) { return std::max(std::sqrt(p.y * p.y + p.z * p.z) - cylinder_diameter / 2, std::fabs(p.x) - cylinder_height / 2); }
double distance_of_sphere(const Vec3d& p) { return norm(p) - sphere_diameter / 2; }

std::vector<Form> forms() {
  return {{BoxSolid{box_size}, distance_of_box},
          {CylinderSolid{cylinder_diameter, cylinder_height, {axis_words, 0}}, distance_of_cylinder},
          {SphereSolid{sphere_diameter}, distance_of_sphere}};
}

std::vector<Frame> frames() { return {Frame{}, frame_of({0.3, -2, 5}, {}), frame_of({-0.1, 0.2, 0.4}, {0.3, -1.1, 2.0})}; }

std::vector<Vec3d> points_about(const fccda::Box& bounds, int count, unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> share(-0.1, 1.1);
  std::vector<Vec3d> points;
  for (int k = 0; k < count; ++k) {
    const Vec3d size = bounds.size();
    points.push_back(bounds.low + Vec3d{share(random) * size.x, share(random) * size.y, share(random) * size.z});
  }
  return points;
}

/// The surface of the panels as a closed file's would be, in the world.
SurfaceSolid surface(const fccda::Panels& panels) { return SurfaceSolid(panels, 0, "test"); }

bool holds(const SurfaceSolid& solid, const Vec3d& point, double margin = 0) {
  std::uint8_t inside = 0;
  solid.mark({.first = point}, margin, {&inside, 1}, 1);
  return inside != 0;
}

fccda::Panels turned(fccda::Panels panels, const Frame& frame) {
  for (Vec3d& vertex : panels.vertices) vertex = frame.to_world(vertex);
  return panels;
}

}  // namespace

TEST_CASE("solid: a point is inside a shape, in any position and orientation, according to its formula") {
  constexpr double margin = 0.01, rounding = 1e-12;  // of places of a few metres
  for (const Form& form : forms()) {
    for (const Frame& frame : frames()) {
      const Solid solid(form.shape, frame);
      int inside = 0;
      for (const Vec3d& point : points_about(solid.bounds(), 2000, 1)) {
        const double distance = form.distance(frame.to_local(point));
        if (std::fabs(distance) < rounding || std::fabs(distance - margin) < rounding) continue;
        CHECK(solid.contains(point) == (distance < 0));
        CHECK(solid.contains(point, margin) == (distance < margin));
        inside += distance < 0 ? 1 : 0;
      }
      CHECK(inside > 200);
    }
  }
}

TEST_CASE("solid: a point on the surface is inside") {
  const Solid box(BoxSolid{{2, 2, 2}}, Frame{});
  for (const Vec3d& point : {Vec3d{1, 0, 0}, Vec3d{0, -1, 0.5}, Vec3d{1, 1, 1}}) CHECK(box.contains(point));
  const Solid sphere(SphereSolid{2}, Frame{}), cylinder(CylinderSolid{2, 2, {axis_words, 2}}, Frame{});
  CHECK(sphere.contains({0, 0, -1}));
  CHECK(cylinder.contains({0, 1, 1}));
  CHECK(!cylinder.contains({0, 1, 1.0001}));
}

TEST_CASE("solid: bounds contain the shape and are tight on all sides") {
  for (const Form& form : forms()) {
    for (const Frame& frame : frames()) {
      const Solid solid(form.shape, frame);
      fccda::Box found;
      for (const Vec3d& point : points_about(solid.bounds(), 30000, 2))
        if (solid.contains(point)) found.include(point);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        CHECK(found.low[axis] >= solid.bounds().low[axis]);
        CHECK(found.high[axis] <= solid.bounds().high[axis]);
      }
      // corners of a turned box are slim: 30,000 points come within a tenth of the size
      const Vec3d gap = solid.bounds().size() - found.size();
      CHECK(fccda::largest_magnitude(gap) < 0.1 * fccda::largest_magnitude(solid.bounds().size()));
    }
  }
}

TEST_CASE("solid: the interior of rotated panels of a box, cylinder and sphere is that of the exact shape") {
  // A ball of inscribed panels is smaller than the sphere by the sagitta of a panel, panel²/(8 radius), here with a factor of two for triangles.
  constexpr double panel = 0.05;
  constexpr double sagitta = 2 * panel * panel / (8 * cylinder_diameter / 2);
  const fccda::Panels panels[] = {fccda::make_box({box_size, 0.2}), fccda::make_cylinder({cylinder_diameter, cylinder_height, fccda::Axis::x, panel}),
                                  fccda::make_sphere({sphere_diameter, panel})};
  const auto shapes = forms();
  for (std::size_t k = 0; k < shapes.size(); ++k) {
    for (const Frame& frame : frames()) {
      const SurfaceSolid solid = surface(turned(panels[k], frame));
      int inside = 0;
      for (const Vec3d& point : points_about(solid.bounds(), 2000, 3)) {
        const double distance = shapes[k].distance(frame.to_local(point));
        if (std::fabs(distance) < (k == 0 ? 1e-9 : sagitta)) continue;
        CHECK(holds(solid, point) == (distance < 0));
        inside += distance < 0 ? 1 : 0;
      }
      CHECK(inside > 200);
    }
  }
}

TEST_CASE("solid: the result for a row equals that of its points, and that of the solid angle") {
  for (const Frame& frame : frames()) {
    const SurfaceSolid solid = surface(turned(fixtures::torus(1, 0.3, 24, 12), frame));
    const fccda::Box bounds = solid.bounds();
    const double spacing = bounds.size().x / 50;
    std::mt19937_64 random(4);
    std::uniform_real_distribution<double> share(0, 1);
    for (int n = 0; n < 40; ++n) {
      const Row row{
          {bounds.low.x - 0.3 * spacing, bounds.low.y + share(random) * bounds.size().y, bounds.low.z + share(random) * bounds.size().z}, spacing, 52};
      std::vector<std::uint8_t> inside(52, 0);
      solid.mark(row, 0, inside, 1);
      for (int i = 0; i < row.count; ++i) {
        CHECK((inside[std::size_t(i)] != 0) == holds(solid, row.point(i)));
        CHECK((inside[std::size_t(i)] != 0) == (solid.winding(row.point(i)) > 0.5));
      }
    }
  }
}

TEST_CASE("solid: rows along faces, edges and corners of a surface contain the points on it, and none beyond") {
  const SurfaceSolid cube = surface(fixtures::unit_cube());
  constexpr double margin = 1e-9;
  for (const double y : {-0.5, 0.0, 0.25, 0.5, 1.0, 1.5}) {
    for (const double z : {-0.5, 0.0, 0.25, 0.5, 1.0, 1.5}) {
      const Row row{{-1, y, z}, 0.25, 13};
      std::vector<std::uint8_t> inside(13, 0);
      cube.mark(row, margin, inside, 1);
      for (int i = 0; i < row.count; ++i) {
        const bool is_in = row.x(i) >= 0 && row.x(i) <= 1 && y >= 0 && y <= 1 && z >= 0 && z <= 1;
        CHECK((inside[std::size_t(i)] != 0) == is_in);
      }
    }
  }
}

TEST_CASE("solid: rows within faces parallel to them up to rounding end outside the solid") {
  // one such row in two hundred slips past a sliver of the face in its plane, and seems to enter more often than to leave; were that not seen to,
  // checked by the address sanitizer
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> share(0, 1);
  for (int n = 0; n < 200; ++n) {
    const int sides = 3 + static_cast<int>(random() % 5);
    const double length = std::pow(10.0, 6 * share(random) - 1), tilt = std::pow(10.0, -17 + 5 * share(random)), turn = 6.28 * share(random);
    fccda::Panels prism;
    for (const double x : {0.0, length})
      for (int k = 0; k < sides; ++k) {
        const double angle = turn + 2 * std::numbers::pi * k / sides;
        prism.vertices.push_back({x, 1.0 / 3 + std::cos(angle) + x * tilt, 0.7 + std::sin(angle) - 0.3 * x * tilt});
      }
    for (int k = 0; k < sides; ++k) prism.add_quad(k, sides + k, sides + (k + 1) % sides, (k + 1) % sides);
    for (int k = 1; k + 1 < sides; ++k) prism.add_triangle(0, k, k + 1), prism.add_triangle(sides, sides + k + 1, sides + k);
    const SurfaceSolid solid = surface(prism);
    for (int m = 0; m < 50; ++m) {
      const auto k = static_cast<std::size_t>(random() % static_cast<unsigned>(sides)), far = static_cast<std::size_t>(sides);
      const Vec3d &a = prism.vertices[k + far * (random() % 2)], &b = prism.vertices[(k + 1) % far + far * (random() % 2)];
      const Vec3d in_face = a + share(random) * (b - a);
      const Row row{{-length, in_face.y, in_face.z}, 1.5 * length, 3};  // before, in the face, behind
      std::vector<std::uint8_t> inside(3, 0);
      solid.mark(row, 0, inside, 1);
      CHECK((inside[0] == 0 && inside[2] == 0));
    }
  }
}

TEST_CASE("solid: a cavity is outside, and overlapping parts are united") {
  const auto ball = [](double diameter, const Vec3d& centre) {
    return fixtures::moved(fccda::make_sphere({diameter, 0.1}), [&](const Vec3d& v) { return v + centre; });
  };
  const SurfaceSolid shell = surface(fixtures::joined(ball(2, {}), ball(1, {})));
  CHECK(holds(shell, {0, 0, 0.75}));
  CHECK(!holds(shell, {0.1, 0, 0.2}));
  CHECK(shell.volume().value() == fixtures::relative(std::numbers::pi / 6 * 7, 0.02));  // inscribed panels of 0.1 m lose 1 %

  const SurfaceSolid pair = surface(fixtures::joined(ball(1, {}), ball(1, {0.4, 0.05, 0.02})));
  for (const Vec3d& point : {Vec3d{-0.3, 0, 0}, Vec3d{0.2, 0.02, 0}, Vec3d{0.7, 0, 0}}) CHECK(holds(pair, point));
  CHECK(!holds(pair, {0.2, -0.48, 0}));
  CHECK(!pair.volume().has_value());  // they overlap, so that the volume is unknown
}

TEST_CASE("solid: a file is scaled, rotated and translated before the frame of the body applies") {
  const fixtures::TemporaryFolder folder;
  fixtures::put(folder / "cube.stl", fixtures::stl_text(fixtures::unit_cube()));
  FileSolid file;
  file.file = (folder / "cube.stl").string(), file.scale = 2, file.translate = {0, 0, 1};
  const Solid solid(file, frame_of({10, 0, 0}, {0, 0, std::numbers::pi / 2}));
  // the cube of 2 m, from z = 1 m to 3 m, turned from x towards y
  CHECK(solid.contains({8.1, 0.1, 1.1}));
  CHECK(solid.contains({9.9, 1.9, 2.9}));
  CHECK(!solid.contains({10.1, 0.1, 1.1}));
  CHECK(!solid.contains({9.9, 0.1, 0.9}));
  CHECK(solid.volume().value() == fixtures::relative(8, 1e-12));  // rounding
}

TEST_CASE("solid: a surface that is not closed has no interior and is refused") {
  fixtures::Panels open = fixtures::unit_cube();
  open.panels.pop_back();
  CHECK_THROWS_WITH_AS(surface(open),
                       "test: the surface is open: 4 of its edges have a panel on one side only, so that no interior is defined; `perimpact mesh` shows these "
                       "edges and the welding tolerance that would close them.",
                       fccda::InputError);
}

TEST_CASE("solid: the interior of a real hull is that of the solid angle of all its panels") {
  const std::filesystem::path file = "/usr/share/doc/openfoam-examples/examples/resources/geometry/DTC-scaled.stl.gz";
  if (!std::filesystem::exists(file)) return;  // the package openfoam-examples is not installed
  const fccda::Panels panels = fccda::read_panels(file);
  const SurfaceSolid hull = surface(panels);
  int inside = 0;
  for (const Vec3d& point : points_about(hull.bounds(), 100, 5)) {
    const bool is_in = hull.winding(point) > 0.5;
    CHECK(holds(hull, point) == is_in);
    inside += is_in ? 1 : 0;
  }
  CHECK(inside > 10);
}
