#include "io/output/surface_file.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "fixtures/surfaces.hpp"
#include "fixtures/temporary_folder.hpp"
#include "mesh_io/read_panels.hpp"

using namespace fccda;
using fixtures::TemporaryFolder;
using fixtures::text_of;
using perimpact::output::write_surface;

namespace {

template <class Number>
using Corners = std::array<std::array<Number, 3>, 3>;

/// The triangles by part, sorted: corners rotated to begin with the smallest, which keeps the winding, as doubles or rounded to floats.
template <class Number>
std::map<std::string, std::vector<Corners<Number>>> triangles(const Surface& surface) {
  std::map<std::string, std::vector<Corners<Number>>> found;
  for (std::size_t t = 0; t < surface.triangles().size(); ++t) {
    Corners<Number> corners;
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t axis = 0; axis < 3; ++axis) corners[c][axis] = static_cast<Number>(surface.corner(t, c)[axis]);
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    found[surface.part_names()[static_cast<std::size_t>(surface.part_of_panel(surface.triangles()[t].panel))]].push_back(corners);
  }
  for (auto& [part, list] : found) std::sort(list.begin(), list.end());
  return found;
}

/// A torus in oblique orientation, so that no coordinate has a short decimal representation.
Panels askew() {
  return fixtures::moved(fixtures::torus(1, 0.3, 9, 7), [](const Vec3d& p) {
    return Vec3d{0.1 * p.x - p.y / 3, std::sqrt(2) * p.y + p.z / 7, p.z - 0.3 * p.x};
  });
}

Panels with_parts(Panels panels) {
  panels.part_names = {"blade 1", "", "hub"};
  for (std::size_t p = 0; p < panels.panels.size(); ++p) panels.part.push_back(static_cast<int>(p % 3));
  return panels;
}

}  // namespace

TEST_CASE("surface file: OBJ, and STL with parts, are read back bitwise, with winding and names") {
  const TemporaryFolder folder;
  for (const Panels& panels : {askew(), with_parts(askew())}) {
    const Surface surface(panels);
    for (const std::string name : {"a.obj", "a.stl"}) {
      if (name == "a.stl" && panels.part_names.empty()) continue;
      write_surface(folder / name, surface);
      const Surface back(read_panels(folder / name));
      CHECK(triangles<double>(back) == triangles<double>(surface));
      CHECK(back.report().vertices == surface.report().vertices);
      CHECK((back.report().rewound == 0 && back.report().flipped == 0 && back.report().degenerate == 0));
    }
  }
}

TEST_CASE("surface file: STL without parts is binary, with each coordinate rounded to a float and the normals of the surface") {
  const TemporaryFolder folder;
  const Surface surface(askew());
  write_surface(folder / "a.stl", surface);
  const std::string bytes = text_of(folder / "a.stl");
  CHECK(bytes.size() == 84 + 50 * surface.triangles().size());
  CHECK(!bytes.starts_with("solid"));
  const Surface back(read_panels(folder / "a.stl"));
  CHECK(triangles<float>(back) == triangles<float>(surface));
  for (std::size_t t = 0; t < surface.triangles().size(); ++t)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      float written = 0;
      std::copy_n(bytes.data() + 84 + 50 * t + 4 * axis, 4, reinterpret_cast<char*>(&written));
      CHECK(written == static_cast<float>(surface.normal(t)[axis]));
    }
}

TEST_CASE("surface file: an inward oriented and disconnected surface is written as repaired") {
  const TemporaryFolder folder;
  write_surface(folder / "cube.obj", Surface(fixtures::reversed(fixtures::exploded(fixtures::unit_cube()))));
  const Panels panels = read_panels(folder / "cube.obj");
  CHECK((panels.vertices.size() == 8 && panels.panels.size() == 12));
  CHECK(fixtures::is_watertight(panels));
  CHECK(Surface(panels).report().flipped == 0);
}

TEST_CASE("surface file: an unsupported extension is refused with the supported ones, before anything is written") {
  const TemporaryFolder folder;
  for (const std::string name : {"a.ply", "a", "a.STL.gz"}) {
    const std::string path = (folder / name).string();
    CHECK_THROWS_WITH_AS(write_surface(folder / name, Surface(fixtures::unit_cube())),
                         (path + ": surfaces are written as .stl or .obj; give the file one of these extensions.").c_str(), InputError);
  }
  CHECK(fixtures::files_in(folder.path()).empty());
}
