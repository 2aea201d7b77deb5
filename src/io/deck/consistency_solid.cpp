#include "io/deck/consistency_solid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "io/deck/deck_file.hpp"
#include "io/deck/point_list.hpp"
#include "io/deck/units.hpp"
#include "io/deck/yaml_node.hpp"

namespace perimpact::deck {

namespace fs = std::filesystem;

namespace {

void check_spacing_given(const BodySetup& body, const std::string& path, const Places& places) {
  if (body.spacing) return;
  const auto fields = BodySetup::fields();
  const auto& field = *std::find_if(fields.begin(), fields.end(), [](const auto& one) { return one.name == "spacing"; });
  const UnitKind& kind = kind_of(field.unit);
  refuse(places.of(path), fmt::format("{} lacks spacing [m], {}; for example spacing: {}. {}", path, kind.what, kind.example, field.sentence));
}

void check_whole_spacings(const BoxSolid& box, double spacing, bool is_plane, const std::string& path, const Places& places) {
  const std::size_t axes = is_plane ? 2 : 3;  // a plane body is one layer of its full thickness
  for (std::size_t axis = 0; axis < axes; ++axis) {
    const double count = box.size[axis] / spacing;
    const double nearest = std::round(count);
    constexpr double tolerance = 1e-6;  // relative: permits rounding of decimal fractions, not a wrong digit
    if (nearest >= 1 && std::fabs(count - nearest) <= tolerance * nearest) continue;
    const double fewer = std::floor(count), more = fewer + 1;
    const std::string nearby = fewer >= 1 ? fmt::format("{:.9g} m or {:.9g} m", fewer * spacing, more * spacing) : fmt::format("{:.9g} m", spacing);
    refuse(places.of(path + ".shape.box.size"),
           fmt::format("{} of size is {} m, that is {:.9g} spacings of {} m, but it must be a whole number of spacings; use {}, or another spacing.",
                       "xyz"[axis], box.size[axis], count, spacing, nearby));
  }
}

/// A plane body is a layer of uniform thickness in z.
void check_plane(const BodySetup& body, const std::string& path, const Places& places) {
  if (!body.is_plane()) return;
  if (body.rotate.x != 0 || body.rotate.y != 0) refuse(places.of(path + ".rotate"), "rotate moves a plane body out of the x-y plane; rotate it about z only.");
  if (std::holds_alternative<SphereSolid>(body.shape))
    refuse(places.of(path + ".shape.sphere"), "a plane body needs a uniform thickness, but a sphere has none; use a cylinder about z, or plane: none.");
  const auto* cylinder = std::get_if<CylinderSolid>(&body.shape);
  if (cylinder && cylinder->axis.word() != "z")
    refuse(places.of(path + ".shape.cylinder"),
           fmt::format("a plane body has its thickness in z, but the axis of its cylinder is {}; set axis: z, or plane: none.", cylinder->axis.word()));
}

void check_thickness(const std::optional<double>& thickness, bool is_plane, const std::string& path, const Places& places) {
  if (is_plane && !thickness) refuse(places.of(path), fmt::format("{} lacks thickness [m], which a plane body requires; for example thickness: 9 mm.", path));
  if (!is_plane && thickness)
    refuse(places.of(path + ".thickness"), "thickness is given, but only plane bodies have one; remove it, or set plane: stress or strain.");
}

void make_cloud_consistent(BodySetup& body, const std::string& path, const fs::path& folder, const Places& places) {
  const auto refuse_if_given = [&](std::string_view key, bool is_given, std::string_view what) {
    if (is_given)
      refuse(places.of(fmt::format("{}.{}", path, key)),
             fmt::format("{} is given, but the shape of {} is a file of particles, {}; remove {}, or give a solid.", key, body.name, what, key));
  };
  refuse_if_given("spacing", body.spacing.has_value(), "whose positions define the spacing");
  refuse_if_given("add", !body.add.empty(), "which cannot be united with a solid");
  if (auto* cells = std::get_if<CellsShape>(&body.shape)) {
    check_thickness(cells->thickness, body.is_plane(), path + ".shape.cells", places);
    cells->file = full_path(folder / cells->file, places.of(path + ".shape.cells.file"));
  } else if (auto* points = std::get_if<PointsShape>(&body.shape)) {
    check_thickness(points->thickness, body.is_plane(), path + ".shape.points", places);
    const std::string key = path + ".shape.points.file";
    points->file = full_path(folder / points->file, places.of(key));
    if (points->is_vtk()) return;  // read when the body is discretised
    PointList list = read_point_list(points->file, places.of(key));
    points->points = std::move(list.points);
    points->volumes = std::move(list.volumes);
  }
}

}  // namespace

void make_shape_consistent(BodySetup& body, const fs::path& folder, const Places& places) {
  const std::string path = "bodies." + body.name;
  check_plane(body, path, places);
  if (std::holds_alternative<PointsShape>(body.shape) || std::holds_alternative<CellsShape>(body.shape))
    return make_cloud_consistent(body, path, folder, places);
  check_spacing_given(body, path, places);
  const auto* box = std::get_if<BoxSolid>(&body.shape);
  if (box && body.rotate == Vec3d{} && body.add.empty()) check_whole_spacings(*box, *body.spacing, body.is_plane(), path, places);
}

}  // namespace perimpact::deck
