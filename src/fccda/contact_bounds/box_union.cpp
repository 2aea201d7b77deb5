#include "fccda/contact_bounds/box_union.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "base/contract.hpp"
#include "base/error.hpp"
#include "base/finite.hpp"
#include "fccda/contact_bounds/boxes.hpp"
#include "mesh/polygon.hpp"

namespace fccda {

namespace {

Polygon polygon_of(const Surface& surface, std::size_t triangle) {
  return {surface.corner(triangle, 0), surface.corner(triangle, 1), surface.corner(triangle, 2)};
}

/// Adds the part of the polygon outside the box to `left`, in convex pieces; true if some of it lies inside.
bool subtract(Polygon polygon, const Box& box, std::vector<Polygon>& left) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const Side inner : {Side::above, Side::below}) {
      const double face = inner == Side::above ? box.low[axis] : box.high[axis];
      const bool extends_beyond =
          std::any_of(polygon.begin(), polygon.end(), [&](const Vec3d& corner) { return inner == Side::above ? corner[axis] < face : corner[axis] > face; });
      if (!extends_beyond) continue;
      left.push_back(part_of(polygon, inner == Side::above ? Side::below : Side::above, axis, face));
      polygon = part_of(polygon, inner, axis, face);
      if (polygon.empty()) return false;
    }
  }
  return true;
}

std::string name_of(std::size_t box, std::size_t count) {
  std::ostringstream text;
  count == 1 ? text << "the box" : text << "box " << box + 1 << " of " << count;
  return text.str();
}

/// Comparisons with NaN are false, so that a box of it would contain nothing, without a message.
void expect_usable(std::span<const BoxUnion::Shape> shapes) {
  if (shapes.empty()) throw InputError("contact bounds: no boxes are given; give one at least.");
  for (std::size_t b = 0; b < shapes.size(); ++b) {
    const auto& [size, centre] = shapes[b];
    const std::string box = name_of(b, shapes.size());
    if (!(size.x > 0 && size.y > 0 && size.z > 0) || !is_finite(size))
      throw InputError("contact bounds: the size of " + box + " is " + in_words(size) +
                       " m, but its three edge lengths must be finite and positive; correct it.");
    expect_finite(centre, "contact bounds: the centre of " + box);
  }
}

}  // namespace

BoxUnion::BoxUnion(std::span<const Shape> shapes, const Surface& surface, Beyond beyond) {
  expect_usable(shapes);
  for (const Shape& shape : shapes) boxes_.push_back(widened({shape.centre - 0.5 * shape.size, shape.centre + 0.5 * shape.size}, widening(surface)));
  bounds_ = bounds_of(boxes_);

  ExceedingPanels out;
  std::vector<bool> is_reached(boxes_.size(), false);
  std::vector<Polygon> left, next;
  for (std::size_t t = 0; t < surface.triangles().size(); ++t) {
    left = {polygon_of(surface, t)};
    const Box its = fccda::bounds_of(left.front());
    for (std::size_t b = 0; b < boxes_.size(); ++b) {
      if (are_apart(its, boxes_[b])) continue;
      if (fccda::contains(boxes_[b], its)) {
        is_reached[b] = true;
        left.clear();
      }
      // A box may also be reached by panels that another one contains.
      if (!is_reached[b]) {
        next.clear();
        is_reached[b] = subtract(polygon_of(surface, t), boxes_[b], next);
      }
      next.clear();
      for (const Polygon& polygon : left) subtract(polygon, boxes_[b], next);
      left.swap(next);
    }
    for (const Polygon& polygon : left) {
      Vec3d middle{};
      for (const Vec3d& corner : polygon) {
        middle += corner / static_cast<double>(polygon.size());
        out.add(surface.triangles()[t].panel, distance_at_least(corner));
      }
      out.add(surface.triangles()[t].panel, distance_at_least(middle));
    }
  }
  for (std::size_t b = 0; b < boxes_.size(); ++b)
    if (!is_reached[b])
      throw InputError("contact bounds: no panel of the surface reaches into " + name_of(b, boxes_.size()) +
                       ", so no contact is possible there; check the box's centre and size.");
  clips_ = !out.panels.empty();
  if (clips_ && beyond == Beyond::error)
    refuse(out, surface, boxes_.size() == 1 ? "the box" : "the boxes", boxes_.size() == 1 ? "enlarge the box" : "enlarge them, or add a box");
}

BoxUnion::BoxUnion(std::vector<Box> boxes) : boxes_(std::move(boxes)), bounds_(bounds_of(boxes_)) { EXPECTS(!boxes_.empty()); }

bool BoxUnion::contains(const Vec3d& point) const {
  return std::any_of(boxes_.begin(), boxes_.end(), [&](const Box& box) { return fccda::contains(box, point); });
}

bool BoxUnion::may_contact(const Path& path, double margin) const {
  const Box reach = widened({min(path.start, path.end), max(path.start, path.end)}, margin);
  if (are_apart(reach, bounds_)) return false;
  return boxes_.size() == 1 || std::any_of(boxes_.begin(), boxes_.end(), [&](const Box& box) { return !are_apart(reach, box); });
}

double BoxUnion::distance_at_least(const Vec3d& point) const {
  double least = std::numeric_limits<double>::infinity();
  for (const Box& box : boxes_) least = std::min(least, squared_distance(box, point));
  return std::sqrt(least);
}

double BoxUnion::volume() const { return volume_of(boxes_); }

}  // namespace fccda
