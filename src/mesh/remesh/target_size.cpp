#include "mesh/remesh/target_size.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>

#include "base/error.hpp"
#include "base/no_such_part.hpp"
#include "mesh/polygon.hpp"

namespace fccda {
namespace {

using TriangleCorners = std::array<Vec3d, 3>;

bool contains(const Box& box, const Vec3d& point) { return box.distance(point) == 0; }

/// The part of the triangle inside the box, the box's faces included.
Polygon part_in(const Box& box, const TriangleCorners& corners) {
  Polygon part(corners.begin(), corners.end());
  for (std::size_t axis = 0; axis < 3 && !part.empty(); ++axis)
    part = part_of(part_of(part, Side::above, axis, box.low[axis]), Side::below, axis, box.high[axis]);
  return part;
}

bool are_apart(const Box& box, const TriangleCorners& corners) {
  const Vec3d low = min(min(corners[0], corners[1]), corners[2]), high = max(max(corners[0], corners[1]), corners[2]);
  return low.x > box.high.x || low.y > box.high.y || low.z > box.high.z || high.x < box.low.x || high.y < box.low.y || high.z < box.low.z;
}

bool reaches_into(const Box& box, const TriangleCorners& corners) {
  if (are_apart(box, corners)) return false;
  return std::any_of(corners.begin(), corners.end(), [&](const Vec3d& corner) { return contains(box, corner); }) || !part_in(box, corners).empty();
}

double area_of(const Polygon& polygon) {
  Vec3d doubled{};
  for (std::size_t k = 2; k < polygon.size(); ++k) doubled += cross(polygon[k - 1] - polygon[0], polygon[k] - polygon[0]);
  return 0.5 * norm(doubled);
}

}  // namespace

TargetSize::TargetSize(const Surface& surface, const Curvature& curvature, std::span<const Refinement> refinements) : surface_(surface), curvature_(curvature) {
  for (const Refinement& refinement : refinements) {
    requests_.push_back(request_of(refinement));
    if (refinement.box) expect_panels_in(requests_.back());
  }
}

void TargetSize::expect_panels_in(const SizeRequest& request) const {
  const Box& box = *request.refinement.box;
  for (std::size_t t = 0; t < surface_.triangles().size(); ++t)
    if (holds_for_part_of(request, t) && reaches_into(box, {surface_.corner(t, 0), surface_.corner(t, 1), surface_.corner(t, 2)})) return;
  const auto words = [](const Box& one) {
    std::ostringstream text;
    text << "(" << one.low.x << ", " << one.low.y << ", " << one.low.z << ") to (" << one.high.x << ", " << one.high.y << ", " << one.high.z << ") m";
    return text.str();
  };
  throw InputError(request.refinement.name + ": no panel" + (request.refinement.surface_part ? " of part " + *request.refinement.surface_part : "") +
                   " reaches into the box from " + words(box) + ", and the surface goes from " + words(surface_.report().bounds) + "; correct the box.");
}

TargetSize::SizeRequest TargetSize::request_of(const Refinement& refinement) const {
  const auto names = surface_.part_names();
  if (refinement.surface_part && std::find(names.begin(), names.end(), *refinement.surface_part) == names.end())
    throw InputError(refinement.name + ": " + no_such_part(*refinement.surface_part, names));
  SizeRequest request{refinement, {}};
  for (const std::string& name : names) request.holds_for_part.push_back(!refinement.surface_part || *refinement.surface_part == name);
  return request;
}

bool TargetSize::holds_for_part_of(const SizeRequest& request, std::size_t triangle) const {
  return request.holds_for_part[static_cast<std::size_t>(surface_.part_of_panel(surface_.triangles()[triangle].panel))];
}

/// [m] Size for a triangle without creases; infinity if it is flat.
double TargetSize::smooth_size(const SizeRequest& request, std::size_t triangle) const {
  return request.refinement.angle ? std::max(request.refinement.edge_length, *request.refinement.angle / curvature_.largest[triangle])
                                  : request.refinement.edge_length;
}

double TargetSize::of(const Bisection& bisection, const Bisection::Piece& piece) const {
  const auto given = static_cast<std::size_t>(piece.given);
  double smallest = std::numeric_limits<double>::infinity();
  for (const SizeRequest& request : requests_) {
    if (!holds_for_part_of(request, given)) continue;
    const double size = request.refinement.angle && bisection.touches_crease(piece) ? request.refinement.edge_length : smooth_size(request, given);
    if (!(size < smallest)) continue;
    if (request.refinement.box && !reaches_into(*request.refinement.box, {bisection.corner(piece, 0), bisection.corner(piece, 1), bisection.corner(piece, 2)}))
      continue;
    smallest = size;
  }
  return smallest;
}

double TargetSize::estimated_panels(const Refinement& refinement) const {
  const SizeRequest request = request_of(refinement);
  double panels = 0;
  for (std::size_t t = 0; t < surface_.triangles().size(); ++t) {
    if (!holds_for_part_of(request, t)) continue;
    const TriangleCorners corners{surface_.corner(t, 0), surface_.corner(t, 1), surface_.corner(t, 2)};
    if (refinement.box && are_apart(*refinement.box, corners)) continue;
    const Polygon part = refinement.box ? part_in(*refinement.box, corners) : Polygon(corners.begin(), corners.end());
    const double size = smooth_size(request, t);
    if (part.empty()) continue;
    const double length = norm(bounds_of(part).size());
    // The last bisection leaves longest edges between half the size and the whole. Halved squares have a quarter of its square as their area,
    // so there are at most eight in the square of the size. Thin triangles become a row.
    if (length > size) panels += 8 * area_of(part) / (size * size) + 2 * length / size;
    // A row along a crease, and rows of doubling width next to it.
    for (std::size_t e = 0; refinement.angle && e < 3; ++e)
      if (curvature_.is_crease[t][e]) panels += 16 * std::min(length, norm(corners[(e + 1) % 3] - corners[e])) / refinement.edge_length;
  }
  return panels;
}

}  // namespace fccda
