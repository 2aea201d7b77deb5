#include "perimpact/simulation/memory.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

#include "base/pack.hpp"
#include "base/parallel.hpp"
#include "perimpact/deck_model/setup_error.hpp"
#include "perimpact/family/stencil.hpp"
#include "perimpact/materials/internal_force.hpp"

namespace perimpact {

namespace {

using fccda::squared_norm;

constexpr double lanes = static_cast<double>(fccda::byte_lanes);
constexpr double number = sizeof(double), vector = sizeof(Vec3d), slot_number = sizeof(std::uint32_t);

/// Per axis; those of a cube if there are too many to be numbered.
std::array<double, 3> cells_of(const BodySetup& setup, const BodySolid& solid, double slots) {
  if (!(slots < std::numeric_limits<std::uint32_t>::max())) return {std::cbrt(slots), std::cbrt(slots), std::cbrt(slots)};
  const Lattice lattice = lattice_that_fills(setup, solid);
  return {static_cast<double>(lattice.cells[0]), static_cast<double>(lattice.cells[1]), static_cast<double>(lattice.cells[2])};
}

/// Mean number of rows per pack of eight in the bond list of a point cloud, from a sample.
double rows_of_eight(const BodySetup& setup, const Cloud& cloud) {
  const auto size_of = [&](double volume) { return cloud.thickness ? std::sqrt(volume / *cloud.thickness) : std::cbrt(volume); };
  const std::size_t count = cloud.points.size(), eights = (count + fccda::byte_lanes - 1) / fccda::byte_lanes;
  const double mean = size_of(std::accumulate(cloud.volumes.begin(), cloud.volumes.end(), 0.0) / static_cast<double>(count));
  const double horizon = setup.horizon_ratio * mean;
  const bool to_the_last = setup.family.as<FamilyRule>() == FamilyRule::hu_ha_bobaru;
  std::vector<double> part(count, 0);  // [m] of the reach, from its own size; cube roots cost more than distances
  if (to_the_last) std::ranges::transform(cloud.volumes, part.begin(), [&](double volume) { return 0.25 * size_of(volume); });
  const std::size_t asked = std::min<std::size_t>(eights, 32);
  std::vector<double> longest(asked, 0);
  fccda::parallel_for_uneven(static_cast<std::ptrdiff_t>(asked), [&](std::ptrdiff_t k) {
    const std::size_t first = (2 * static_cast<std::size_t>(k) + 1) * eights / (2 * asked) * fccda::byte_lanes;
    for (std::size_t i = first; i < std::min(first + fccda::byte_lanes, count); ++i) {
      double bonds = 0;
      for (std::size_t j = 0; j < count; ++j) {
        const double reach = horizon + part[i] + part[j];
        bonds += j != i && squared_norm(cloud.points[j] - cloud.points[i]) < reach * reach ? 1 : 0;
      }
      longest[static_cast<std::size_t>(k)] = std::max(longest[static_cast<std::size_t>(k)], bonds);
    }
  });
  return std::accumulate(longest.begin(), longest.end(), 0.0) / static_cast<double>(asked);
}

ArrayLengths lengths_of(const BodySetup& setup, const Discretisation& discretisation) {
  const double slots = std::ceil(slots_of(setup, discretisation) / lanes) * lanes;
  if (const auto* cloud = std::get_if<Cloud>(&discretisation)) {
    const double rows = slots / lanes * rows_of_eight(setup, *cloud);
    return {.slots = slots, .with_slack = slots, .rows = rows, .entries = rows * lanes};
  }
  const Stencil stencil(setup.family.as<FamilyRule>(), setup.spacing.value_or(1), setup.horizon_ratio, setup.is_plane() ? std::optional(1.0) : std::nullopt);
  const BodySolid& solid = std::get<BodySolid>(discretisation);
  const std::array<double, 3> cells = cells_of(setup, solid, slots);
  const double row = slots / (cells[1] * cells[2]), reach = stencil.reach(), family = static_cast<double>(stencil.size());
  const double slack = reach * (setup.is_plane() ? row : row * cells[1] + row) + reach + lanes;
  // rows near the surface have factors of their own, and so have those bonded to them; eight packs of a row are enough to share a table
  const auto inner = [&](std::size_t axis) { return std::max(0.0, cells[axis] - 4 * reach); };
  const double surface_rows = cells[1] * cells[2] - inner(1) * inner(2);
  const double shared = row >= 8 * lanes ? std::min(surface_rows, slots / lanes) : 0;
  return {.slots = slots, .with_slack = slots + 2 * slack, .rows = slots / lanes * family, .tables = shared * family * 4};
}

struct BodyMemory {
  double at_rest, setting_up, pictures, rubble;
};

/// [bytes] per particle of self_contact/near_pairs.hpp and self_contact/short_range.hpp in rubble as dense as the solid, at most while the
/// list is rebuilt.
double rubble_of(const BodySetup& setup, const FragmentContactSetup& fragments) {
  const double dimension = setup.is_plane() ? 2 : 3, of_pair = fragments.friction > 0 ? vector : 0;  // its tangential spring
  // lattice points within 2.5 and 2 spacings, the reach of the list and of the weight function
  const double listed = (setup.is_plane() ? 20 : 80) * std::pow((2 * fragments.distance_ratio + 0.5) / 2.5, dimension);
  const double near = (setup.is_plane() ? 8 : 26) * std::pow(fragments.distance_ratio, dimension);
  const double pair = (fragments.friction > 0 ? 4.25 : 3.25) * slot_number + of_pair, gap = 4 * pair, found = 2 * slot_number,
               kept = 2 * slot_number + of_pair;  // stored once per pair
  const double member = 3 * vector + 17 * number;
  return listed * (pair + found) + gap + near / 2 * kept + member;
}

BodyMemory memory_of(const BodySetup& setup, const Discretisation& discretisation, const FragmentContactSetup& fragments, std::size_t impactors) {
  const ArrayLengths length = lengths_of(setup, discretisation);
  const double n = length.slots, with_slack = length.with_slack;
  double arrays = 9 * number * with_slack + n / 8 + 3 * slot_number * n;  // particles and the family's numbers of their slots, grown one by one
  arrays += length.rows + number * n;                                     // bonds, volumes of families
  if (length.is_list()) arrays += 2 * vector * n + number * n + slot_number * n + length.rows + length.entries * (sizeof(std::int32_t) + 2 * number);
  // of the copy on which the stiffest mode is sought, for a given step alone, nothing is counted
  const MaterialMemory material = with_material(setup, [&](const auto& its, auto kind) { return kind.memory(its, {setup, kind.correction(setup), length}); });
  arrays += material.at_rest;
  double at_rest = arrays + static_cast<double>(impactors) * (number + sizeof(int)) * n;  // a due distance and a guess for each slot
  if (const auto* points = std::get_if<PointsShape>(&setup.shape))                        // of the deck, and of the simulation's own set-up
    at_rest += 2 * (vector + number) * static_cast<double>(points->points.size());
  const double pictures = 56 * n;  // measured: arrays in single precision and their compressed form
  double rubble = 0;
  if (fragments.law.as<FragmentLaw>() != FragmentLaw::none) {
    at_rest += 132 * n;  // measured: particles, positions and cells of self_contact/near_pairs.hpp
    rubble = rubble_of(setup, fragments) * n;
  }
  return {at_rest, material.setting_up, pictures, rubble};
}

constexpr double program = 21e6;  // [bytes] measured: the program with its libraries

}  // namespace

double physical_memory() { return static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE)); }

double Memory::peak() const { return at_rest + std::max(setting_up, pictures); }

Memory memory_of(const Setup& setup, std::span<const Discretisation> bodies) {
  Memory sum{.at_rest = program};
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const BodyMemory one = memory_of(setup.bodies[b], bodies[b], setup.contact.fragments, setup.impactors.size());
    sum.at_rest += one.at_rest;
    sum.rubble += one.rubble;
    sum.setting_up = std::max(sum.setting_up, one.setting_up);  // bodies are built one after the other
    if (setup.output.frames > 0) sum.pictures = std::max(sum.pictures, one.pictures);
  }
  return sum;
}

void expect_to_fit(const Setup& setup, std::span<const Discretisation> bodies, double available) {
  const double needed = memory_of(setup, bodies).peak();
  if (needed <= available) return;  // false for NaN
  const auto at_rest = [&](std::size_t b) { return memory_of(setup.bodies[b], bodies[b], {}, 0).at_rest; };
  std::size_t largest = 0;
  for (std::size_t b = 1; b < bodies.size(); ++b)
    if (at_rest(b) > at_rest(largest)) largest = b;
  const BodySetup& body = setup.bodies[largest];
  if (!body.spacing)
    throw SetupError(
        "bodies." + body.name + ".shape",
        fmt::format("with {:.3g} particles of body {} the run needs {:.3g} GB of memory, but this machine has {:.3g} GB; use fewer and larger particles.",
                    slots_of(body, bodies[largest]), body.name, needed / 1e9, available / 1e9));
  const std::string key = "bodies." + body.name + ".spacing";
  if (!std::isfinite(needed))
    throw SetupError(key, fmt::format("a spacing of {} m gives body {} more cells than can be numbered; increase it.", *body.spacing, body.name));
  throw SetupError(key, fmt::format("with a spacing of {} m for body {} the run needs {:.3g} GB of memory, but this machine has {:.3g} GB; use a spacing of at "
                                    "least {:.2g} m, or a smaller body.",
                                    *body.spacing, body.name, needed / 1e9, available / 1e9, 1.05 * *body.spacing * std::cbrt(needed / available)));
}

}  // namespace perimpact
