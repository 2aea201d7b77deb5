#include "mesh.hpp"

#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <array>

#include "base/error.hpp"
#include "mesh/shapes/box.hpp"
#include "mesh/shapes/cylinder.hpp"
#include "mesh/shapes/sphere.hpp"
#include "mesh_io/read_panels.hpp"

namespace perimpact::python {

namespace {

using fccda::InputError;
using fccda::Panels;
using Faces = py::array_t<long, py::array::c_style | py::array::forcecast>;

void take_faces(Panels& panels, const Faces& faces) {
  if (faces.ndim() != 2 || (faces.shape(1) != 3 && faces.shape(1) != 4))
    throw InputError(
        fmt::format("mesh: faces has the shape {}, but must be (faces, 3) or (faces, 4): the vertex numbers around each face.", shape_in_words(faces)));
  const auto count = static_cast<long>(panels.vertices.size());
  for (py::ssize_t f = 0; f < faces.shape(0); ++f) {
    std::array<int, 4> panel{0, 0, 0, -1};
    for (py::ssize_t c = 0; c < faces.shape(1); ++c) {
      const long vertex = faces.at(f, c);
      if ((vertex < 0 || vertex >= count) && !(c == 3 && vertex == -1))
        throw InputError(fmt::format("mesh: face {} has vertex {}, but there are {}, counted from 0.", f, vertex, count));
      panel[static_cast<std::size_t>(c)] = static_cast<int>(vertex);
    }
    panels.panels.push_back(panel);
  }
}

void take_parts(Panels& panels, const std::vector<std::string>& parts) {
  if (parts.size() != panels.panels.size())
    throw InputError(fmt::format("mesh: parts has {} entries for {} faces; give one part per face.", parts.size(), panels.panels.size()));
  for (const std::string& name : parts) {
    const auto known = std::find(panels.part_names.begin(), panels.part_names.end(), name);
    panels.part.push_back(static_cast<int>(known - panels.part_names.begin()));
    if (known == panels.part_names.end()) panels.part_names.push_back(name);
  }
}

Panels panels_from(Numbers& vertices, const Faces& faces, const std::optional<std::vector<std::string>>& parts) {
  Panels panels;
  const fccda::ConstVectors points = vectors_in(vertices, "mesh: vertices");
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!is_finite(points[i])) throw InputError(fmt::format("mesh: vertex {} has a coordinate that is not a finite number.", i));
    panels.vertices.push_back(points[i]);
  }
  take_faces(panels, faces);
  if (parts) take_parts(panels, *parts);
  return panels;
}

std::vector<std::string> parts_of(const Mesh& mesh) {
  std::vector<std::string> parts;
  for (const int part : mesh.panels().part) parts.push_back(mesh.panels().part_names[static_cast<std::size_t>(part)]);
  return parts;
}

// ---- pickled meshes ----

py::tuple pickled(const Mesh& mesh) {
  const Panels& panels = mesh.panels();
  return py::make_tuple(array_of(panels.vertices), array_of(panels.panels), py::array_t<int>(static_cast<py::ssize_t>(panels.part.size()), panels.part.data()),
                        panels.part_names);
}

Mesh unpickled(const py::tuple& state) {
  auto vertices = state[0].cast<Numbers>();
  Panels panels = panels_from(vertices, state[1].cast<Faces>(), std::nullopt);
  panels.part = state[2].cast<std::vector<int>>();
  panels.part_names = state[3].cast<std::vector<std::string>>();
  return Mesh(std::move(panels));
}

fccda::Axis axis_of(const std::string& word) {
  if (word.size() == 1 && word[0] >= 'x' && word[0] <= 'z') return static_cast<fccda::Axis>(word[0] - 'x');
  throw InputError(fmt::format("axis is \"{}\", but it must be one of x, y, z.", word));
}

void expect_positive(double value, const char* what) {
  if (!(value > 0)) throw InputError(fmt::format("{} is {} m, but it must be above 0.", what, value));
}

double panel_of(const std::optional<double>& panel) {
  if (!panel) return 0;  // the default of the shape
  expect_positive(*panel, "edge_length");
  return *panel;
}

}  // namespace

Mesh::Mesh(Numbers vertices, const Faces& faces, const std::optional<std::vector<std::string>>& parts) : Mesh(panels_from(vertices, faces, parts)) {}

void bind_mesh(py::module_& module) {
  using namespace py::literals;
  py::class_<Mesh>(module, "Mesh", R"(A surface mesh in memory: vertices and panels.

May replace a surface file in a set-up, with the same accompanying keys:
``"surface": {"file": mesh, "scale": 0.001}`` for an impactor, ``"shape": {"file": mesh}`` for a body.)")
      .def(py::init<Numbers, const Faces&, const std::optional<std::vector<std::string>>&>(), "vertices"_a, "faces"_a, "parts"_a = py::none(),
           R"(vertices: (n, 3) coordinates [m].
faces: (m, 3) or (m, 4) vertex numbers around each panel, from 0, counterclockwise seen from outside; the fourth is -1 for triangles among quads.
parts: part name of each panel, for `file_parts`, `gauges` and `refine`.)")
      .def_static(
          "read", [](const std::filesystem::path& file, const std::vector<std::string>& parts) { return Mesh(fccda::read_panels(file, parts)); }, "file"_a,
          "parts"_a = std::vector<std::string>(), "Reads the panels of a surface file, in its units: all, or those of the named parts.")
      .def_static(
          "box",
          [](const Vec3d& size, const std::optional<double>& panel) {
            for (const double edge : {size.x, size.y, size.z}) expect_positive(edge, "size");
            return Mesh(fccda::make_box({.size = size, .edge_length = panel_of(panel)}));
          },
          "size"_a, "edge_length"_a = py::none(),
          "A box of edge lengths size [m] centred on the origin, with panels of edge length at most edge_length [m] along the axes; by default two triangles "
          "per side.")
      .def_static(
          "cylinder",
          [](double diameter, double height, const std::optional<double>& panel, const std::string& axis) {
            expect_positive(diameter, "diameter"), expect_positive(height, "height");
            return Mesh(fccda::make_cylinder({.diameter = diameter, .height = height, .axis = axis_of(axis), .edge_length = panel_of(panel)}));
          },
          "diameter"_a, "height"_a, "edge_length"_a = py::none(), "axis"_a = "z",
          "A cylinder centred on the origin [m], about the axis x, y or z, with panels of edge length at most edge_length [m]; by default a twentieth of the "
          "diameter.")
      .def_static(
          "sphere",
          [](double diameter, const std::optional<double>& panel) {
            expect_positive(diameter, "diameter");
            return Mesh(fccda::make_sphere({.diameter = diameter, .edge_length = panel_of(panel)}));
          },
          "diameter"_a, "edge_length"_a = py::none(),
          "A sphere centred on the origin [m], with panels of edge length at most edge_length [m]; by default a twentieth of the diameter.")
      .def_property_readonly(
          "vertices", [](const Mesh& mesh) { return array_of(mesh.panels().vertices); }, "(n, 3) coordinates [m], a copy.")
      .def_property_readonly(
          "faces", [](const Mesh& mesh) { return array_of(mesh.panels().panels); }, "(m, 4) vertex numbers, the fourth -1 for triangles; a copy.")
      .def_property_readonly("parts", &parts_of, "Part name of each panel; empty where there are no parts.")
      .def("__copy__", [](const Mesh& mesh) { return mesh; })
      .def(
          "__deepcopy__", [](const Mesh& mesh, const py::dict&) { return mesh; }, "memo"_a)  // copies share what cannot change
      .def(py::pickle(&pickled, &unpickled))
      .def("__len__", [](const Mesh& mesh) { return mesh.panels().panels.size(); })
      .def("__repr__", [](const Mesh& mesh) {
        return fmt::format("<perimpact.Mesh of {} vertices and {} faces>", mesh.panels().vertices.size(), mesh.panels().panels.size());
      });
}

}  // namespace perimpact::python
