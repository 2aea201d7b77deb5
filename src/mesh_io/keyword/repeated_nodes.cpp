#include "mesh_io/keyword/repeated_nodes.hpp"

#include <algorithm>

namespace fccda {
namespace {

using Id = std::int64_t;

/// A face of up to four corners, counterclockwise as seen from outside.
struct Face {
  std::array<Id, 4> corners{};
  std::size_t count = 0;
  void add(Id id) { corners[count++] = id; }
  std::span<const Id> all() const { return std::span(corners).first(count); }
};

bool contains(std::span<const Id> ids, Id id) { return std::find(ids.begin(), ids.end(), id) != ids.end(); }

Face without_neighbours_alike(std::span<const Id> corners) {
  Face out;
  for (std::size_t k = 0; k < corners.size(); ++k)
    if (corners[k] != corners[(k + 1) % corners.size()]) out.add(corners[k]);
  return out;
}

bool all_differ(std::span<const Id> ids) {
  for (std::size_t k = 0; k < ids.size(); ++k)
    if (contains(ids.subspan(k + 1), ids[k])) return false;
  return true;
}

NumberedShape as_written(std::span<const Id> corners) {
  NumberedShape out{corners.size() == 4   ? ElementKind::tetrahedron
                    : corners.size() == 5 ? ElementKind::pyramid
                    : corners.size() == 6 ? ElementKind::wedge
                                          : ElementKind::hexahedron};
  for (const Id corner : corners) out.nodes[out.count++] = corner;
  return out;
}

std::array<Id, 8> as_hexahedron(std::span<const Id> n) {
  switch (n.size()) {
    case 4:
      return {n[0], n[1], n[2], n[2], n[3], n[3], n[3], n[3]};
    case 5:
      return {n[0], n[1], n[2], n[3], n[4], n[4], n[4], n[4]};
    case 6:
      return {n[0], n[1], n[2], n[2], n[3], n[4], n[5], n[5]};
    default:
      return {n[0], n[1], n[2], n[3], n[4], n[5], n[6], n[7]};
  }
}

struct Hull {
  std::array<Face, 6> faces;
  std::size_t count = 0;
  std::span<const Face> all() const { return std::span(faces).first(count); }
  std::size_t with(std::size_t corners) const {
    return static_cast<std::size_t>(std::count_if(all().begin(), all().end(), [&](const Face& face) { return face.count == corners; }));
  }
  const Face& first_with(std::size_t corners) const {
    return *std::find_if(all().begin(), all().end(), [&](const Face& face) { return face.count == corners; });
  }
};

/// Whether every edge is traversed once in each direction (a closed, consistently oriented surface).
bool is_closed(const Hull& hull) {
  const auto times = [&](Id from, Id to) {
    int sum = 0;
    for (const Face& face : hull.all())
      for (std::size_t k = 0; k < face.count; ++k) sum += face.corners[k] == from && face.corners[(k + 1) % face.count] == to;
    return sum;
  };
  for (const Face& face : hull.all()) {
    for (std::size_t k = 0; k < face.count; ++k) {
      const Id from = face.corners[k], to = face.corners[(k + 1) % face.count];
      if (times(from, to) != 1 || times(to, from) != 1) return false;
    }
  }
  return true;
}

/// For a wedge: the corner of the other triangle that shares an edge with `corner`.
Id partner(const Hull& hull, const Face& triangle, Id corner) {
  for (const Face& face : hull.all()) {
    if (face.count != 4 || !contains(face.all(), corner)) continue;
    const auto k = static_cast<std::size_t>(std::find(face.corners.begin(), face.corners.end(), corner) - face.corners.begin());
    const Id next = face.corners[(k + 1) % 4];
    return contains(triangle.all(), next) ? face.corners[(k + 3) % 4] : next;
  }
  return corner;
}

}  // namespace

bool repeats_nodes(std::span<const Id> nodes) { return !all_differ(nodes); }

std::optional<NumberedShape> surface_without_repeats(std::span<const Id> corners) {
  const Face face = without_neighbours_alike(corners);
  if (face.count < 3 || !all_differ(face.all())) return std::nullopt;
  NumberedShape out;
  for (const Id corner : face.all()) out.nodes[out.count++] = corner;
  return out;
}

std::optional<NumberedShape> solid_without_repeats(std::span<const Id> corners) {
  if (all_differ(corners)) return as_written(corners);
  const std::array<Id, 8> n = as_hexahedron(corners);
  const std::array<std::array<Id, 4>, 6> sides{{{n[0], n[3], n[2], n[1]},
                                                {n[4], n[5], n[6], n[7]},
                                                {n[0], n[1], n[5], n[4]},
                                                {n[1], n[2], n[6], n[5]},
                                                {n[2], n[3], n[7], n[6]},
                                                {n[3], n[0], n[4], n[7]}}};
  Hull hull;
  for (const auto& side : sides) {
    const Face face = without_neighbours_alike(side);
    if (face.count < 3) continue;
    if (!all_differ(face.all())) return std::nullopt;
    hull.faces[hull.count++] = face;
  }
  if (!is_closed(hull)) return std::nullopt;

  NumberedShape distinct;
  for (const Id id : n)
    if (!contains(distinct.all(), id)) distinct.nodes[distinct.count++] = id;
  const std::size_t triangles = hull.with(3), quads = hull.with(4);
  const auto is = [&](std::size_t node_count, std::size_t triangle_count, std::size_t quad_count) {
    return distinct.count == node_count && triangles == triangle_count && quads == quad_count;
  };
  NumberedShape out;
  const auto start_with = [&](ElementKind kind, const Face& face) {
    out.kind = kind;
    for (const Id id : face.all()) out.nodes[out.count++] = id;
  };
  if (is(6, 2, 3)) {
    const Face& base = hull.first_with(3);
    start_with(ElementKind::wedge, base);
    for (const Id id : base.all()) out.nodes[out.count++] = partner(hull, base, id);
    if (!all_differ(out.all())) return std::nullopt;
  } else if (is(5, 4, 1)) {
    start_with(ElementKind::pyramid, hull.first_with(4));
  } else if (is(4, 4, 0) || is(4, 2, 1)) {  // second case: LS-DYNA repeats the fourth node five times, so one face appears as a quad
    start_with(ElementKind::tetrahedron, hull.first_with(3));
  } else {
    return std::nullopt;
  }
  for (const Id id : distinct.all())
    if (!contains(out.all(), id)) out.nodes[out.count++] = id;
  return out;
}

}  // namespace fccda
