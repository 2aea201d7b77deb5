#include "perimpact/discretisation/cloud_of.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>

#include "base/error.hpp"
#include "mesh_io/file/cells.hpp"
#include "mesh_io/read_panels.hpp"
#include "mesh_io/vtk/point_values.hpp"
#include "perimpact/deck_model/setup_error.hpp"
#include "perimpact/discretisation/body_solid.hpp"
#include "perimpact/discretisation/space_order.hpp"

namespace perimpact {

using fccda::InputError;

namespace {

Cloud listed(const PointsShape& shape) {
  if (!shape.is_vtk()) return {.points = shape.points, .volumes = shape.volumes, .thickness = shape.thickness};
  fccda::PointValues read = fccda::read_point_values(shape.file, "volume");
  if (read.points.empty()) throw InputError(fmt::format("{}: the file has no points; export it again.", shape.file));
  for (std::size_t k = 0; k < read.values.size(); ++k)
    if (!(read.values[k] > 0))
      throw InputError(fmt::format("{}: the volume of point {}, counted from 0, is {} m3, but it must be above 0; correct the array, or remove the point.",
                                   shape.file, k, read.values[k]));
  return {.points = std::move(read.points), .volumes = std::move(read.values), .thickness = shape.thickness};
}

/// Points of the file, relative to the body's position. Throws InputError.
Cloud given(const PointsShape& shape) {
  Cloud cloud = listed(shape);
  if (!shape.thickness) return cloud;
  for (std::size_t k = 0; k < cloud.points.size(); ++k)
    if (cloud.points[k].z != cloud.points[0].z)
      throw InputError(
          fmt::format("{}: row {} has another z than the first, {} m and {} m, but all particles of a plane body share one z; use the same z in all rows, or "
                      "omit thickness.",
                      shape.file, k + 1, cloud.points[k].z, cloud.points[0].z));
  return cloud;
}

Cloud given(const CellsShape& shape) {
  const fccda::Elements mesh = fccda::read_elements(shape.file, shape.file_parts);
  const bool is_plane = shape.thickness.has_value();
  Cloud cloud{.thickness = shape.thickness};
  std::vector<Vec3d> corners;
  for (std::size_t e = 0; e < mesh.size(); ++e) {
    if (fccda::is_solid(mesh.kinds[e]) == is_plane) {
      if (!is_plane) continue;
      throw InputError(fmt::format(
          "{}: element {} in the order of the file is a solid, but a plane body consists of triangles and quads; use another mesh, or omit thickness.",
          shape.file, e + 1));
    }
    const auto nodes = mesh.nodes_of_element(e);
    corners.clear();
    for (const int node : nodes.first(fccda::corners_of(mesh.kinds[e], nodes.size())))
      corners.push_back(shape.scale * mesh.vertices[static_cast<std::size_t>(node)]);
    const auto cell = fccda::cell_of(mesh.kinds[e], corners);
    if (!cell)
      throw InputError(fmt::format("{}: element {} in the order of the file, about ({:.4g}, {:.4g}, {:.4g}) m, has no volume or is inverted; repair the mesh.",
                                   shape.file, e + 1, corners[0].x, corners[0].y, corners[0].z));
    if (is_plane) {
      const double flat = 1e-6 * std::sqrt(cell->measure);  // a millionth of the cell size: single precision
      const double z = cloud.points.empty() ? cell->centroid.z : cloud.points[0].z;
      for (const Vec3d& corner : corners)
        if (std::fabs(corner.z - z) > flat)
          throw InputError(
              fmt::format("{}: element {} in the order of the file extends from z = {} m to {} m, but the mesh of a plane body has a single z; rotate it into "
                          "the x-y plane, or omit thickness.",
                          shape.file, e + 1, z, corner.z));
      cloud.points.push_back({cell->centroid.x, cell->centroid.y, z});
    } else {
      cloud.points.push_back(cell->centroid);
    }
    cloud.volumes.push_back(cell->measure * shape.thickness.value_or(1));
  }
  if (cloud.points.empty())
    throw InputError(
        is_plane ? fmt::format("{}: the file has no triangles or quads for a plane body; check the export.", shape.file)
                 : fmt::format("{}: the file has no solid cells, only a surface; mesh the volume, or fill the surface with shape: {{file: …}}, or give a "
                               "thickness for a plane body.",
                               shape.file));
  return cloud;
}

/// Bonds have non-zero length: no two points may coincide.
void expect_apart(const Cloud& cloud, double distance, const std::string& file) {
  const auto rounded = [&](std::uint32_t k) {
    const Vec3d& p = cloud.points[k];
    return std::array{std::round(p.x / distance), std::round(p.y / distance), std::round(p.z / distance)};
  };
  std::vector<std::uint32_t> order(cloud.points.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return std::pair(rounded(a), a) < std::pair(rounded(b), b); });
  for (std::size_t k = 1; k < order.size(); ++k) {
    if (rounded(order[k - 1]) != rounded(order[k])) continue;
    const Vec3d& p = cloud.points[order[k]];
    throw InputError(fmt::format("{}: particles {} and {} in the order of the file coincide at ({:.6g}, {:.6g}, {:.6g}) m; remove one.", file, order[k - 1] + 1,
                                 order[k] + 1, p.x, p.y, p.z));
  }
}

std::vector<Solid> holes_of(const BodySetup& body) {
  std::vector<Solid> holes;
  for (const SolidSetup& hole : body.holes) holes.push_back(solid_of(hole, body, fmt::format("bodies.{}.holes.{}", body.name, hole.name)));
  return holes;
}

/// In global coordinates, along the space-filling curve, without points in holes.
Cloud arranged(const Cloud& file, const BodySetup& body) {
  const Frame frame = frame_of(body);
  const std::vector<Solid> holes = holes_of(body);
  const double margin = surface_share * spacing_of(file);
  Cloud out{.thickness = file.thickness};
  for (const std::uint32_t number : space_order(file.points)) {
    const Vec3d point = frame.to_world(file.points[number]);
    if (std::any_of(holes.begin(), holes.end(), [&](const Solid& hole) { return hole.contains(point, margin); })) continue;
    out.points.push_back(point);
    out.volumes.push_back(file.volumes[number]);
    out.numbers.push_back(number);
  }
  if (out.numbers.empty())
    throw SetupError("bodies." + body.name + ".holes",
                     fmt::format("the holes of body {} remove all of its particles; make them smaller, or move them.", body.name));
  return out;
}

template <class Shape>
Cloud cloud_of(const Shape& shape, const BodySetup& body) {
  const std::string key = fmt::format("bodies.{}.shape.{}", body.name, Shape::name);
  Cloud cloud;
  try {
    cloud = given(shape);
    constexpr auto most = static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max() - 8);
    if (cloud.points.size() > most)
      throw InputError(fmt::format("{}: {} particles exceed the maximum of {}; use fewer.", shape.file, cloud.points.size(), most));
    expect_apart(cloud, surface_share * spacing_of(cloud), shape.file);
  } catch (const InputError& error) {
    throw SetupError(key + ".file", error.what());
  }
  return arranged(cloud, body);
}

}  // namespace

bool is_cloud(const BodySetup& body) { return std::holds_alternative<PointsShape>(body.shape) || std::holds_alternative<CellsShape>(body.shape); }

Cloud cloud_of(const BodySetup& body) {
  if (const auto* points = std::get_if<PointsShape>(&body.shape)) return cloud_of(*points, body);
  return cloud_of(std::get<CellsShape>(body.shape), body);
}

}  // namespace perimpact
