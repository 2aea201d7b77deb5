#include "perimpact/discretisation/filling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>

#include "base/parallel.hpp"
#include "perimpact/deck_model/setup_error.hpp"
#include "perimpact/particles/fill.hpp"

namespace perimpact {

bool is_plain_box(const BodySetup& body) { return std::holds_alternative<BoxSolid>(body.shape) && body.rotate == Vec3d{} && body.add.empty(); }

namespace {

Vec3d size_of(const BodySetup& body, const BodySolid& solid) {
  return is_plain_box(body) ? std::get<BoxSolid>(body.shape).size : solid.bounds().size();  // the bounds of a distant box are rounded
}

double cells_along(std::size_t axis, const BodySetup& body, const BodySolid& solid) {
  if (axis == 2 && body.is_plane()) return 1;
  return std::max(1.0, std::round(size_of(body, solid)[axis] / body.spacing.value()));
}

}  // namespace

double slots_of(const BodySetup& body, const BodySolid& solid) {
  const auto cells = [&](std::size_t axis) { return cells_along(axis, body, solid); };
  return std::ceil(cells(0) / fccda::byte_lanes) * fccda::byte_lanes * cells(1) * cells(2);
}

Lattice lattice_that_fills(const BodySetup& body, const BodySolid& solid) {
  const double spacing = body.spacing.value(), slots = slots_of(body, solid);
  constexpr double most = std::numeric_limits<std::int32_t>::max();  // pairs of particles and cells of frames have their numbers as such
  if (!(slots < most))
    throw SetupError(
        "bodies." + body.name + ".spacing",
        fmt::format("a spacing of {} m requires {:.3g} cells to fill body {}, more than the maximum of {:.2g}; increase it.", spacing, slots, body.name, most));
  if (is_plain_box(body)) return lattice_of_box(std::get<BoxSolid>(body.shape).size, body.position, spacing, body.is_plane());
  Lattice lattice{.spacing = spacing};
  Vec3d centre = solid.bounds().centre();
  if (body.is_plane()) centre.z = body.position.z, lattice.thickness = solid.thickness();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    lattice.cells[axis] = static_cast<int>(cells_along(axis, body, solid));
    lattice.origin[axis] = centre[axis] - 0.5 * (lattice.cells[axis] - 1) * spacing;
  }
  return lattice;
}

namespace {

void mark_row(const Lattice& lattice, const BodySolid& solid, std::size_t first_slot, std::span<std::uint8_t> inside) {
  const Vec3d centre = lattice.centre(first_slot);
  solid.mark({{lattice.origin.x, centre.y, centre.z}, lattice.spacing, lattice.cells[0], lattice.first[0]}, surface_share * lattice.spacing, inside);
}

}  // namespace

std::vector<std::uint8_t> cells_inside(const Lattice& lattice, const BodySolid& solid) {
  std::vector<std::uint8_t> inside(lattice.slots(), 0);
  fccda::parallel_for_uneven(static_cast<std::ptrdiff_t>(lattice.rows()), [&](std::ptrdiff_t row) {
    const std::size_t begin = static_cast<std::size_t>(row) * lattice.row_slots();
    mark_row(lattice, solid, begin, std::span(inside).subspan(begin, static_cast<std::size_t>(lattice.cells[0])));
  });
  return inside;
}

double particles_of(const BodySetup& body, const BodySolid& solid) {
  if (is_plain_box(body) && body.holes.empty()) return cells_along(0, body, solid) * cells_along(1, body, solid) * cells_along(2, body, solid);
  const double slots = slots_of(body, solid);
  constexpr double most = 1e9;  // beyond, counting takes longer than an estimate may
  if (!(slots < most)) return slots;
  const Lattice lattice = lattice_that_fills(body, solid);
  std::vector<std::size_t> of_layer(static_cast<std::size_t>(lattice.cells[2]), 0);
  fccda::parallel_for_uneven(static_cast<std::ptrdiff_t>(of_layer.size()), [&](std::ptrdiff_t layer) {
    std::vector<std::uint8_t> inside(static_cast<std::size_t>(lattice.cells[0]));
    for (int j = 0; j < lattice.cells[1]; ++j) {
      mark_row(lattice, solid, lattice.slot(0, j, static_cast<int>(layer)), inside);
      of_layer[static_cast<std::size_t>(layer)] += static_cast<std::size_t>(std::count(inside.begin(), inside.end(), 1));
    }
  });
  return static_cast<double>(std::accumulate(of_layer.begin(), of_layer.end(), std::size_t{0}));
}

}  // namespace perimpact
