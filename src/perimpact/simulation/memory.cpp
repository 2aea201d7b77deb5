#include "perimpact/simulation/memory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

#include "base/pack.hpp"
#include "base/parallel.hpp"
#include "perimpact/body/body.hpp"
#include "perimpact/deck_model/setup_error.hpp"
#include "perimpact/family/stencil.hpp"
#include "perimpact/integrate/stable_step.hpp"
#include "perimpact/materials/internal_force.hpp"
#include "perimpact/self_contact/near_pairs.hpp"
#include "perimpact/self_contact/short_range_view.hpp"
#include "perimpact/simulation/sample_block.hpp"

namespace perimpact {

namespace {

using fccda::squared_norm;

constexpr double lanes = static_cast<double>(fccda::byte_lanes);
constexpr double number = sizeof(double), vector = sizeof(Vec3d), slot_number = sizeof(std::uint32_t);
constexpr double program = 21e6;  // [bytes] measured: the program with its libraries

/// Per axis; those of a cube if there are too many to be numbered.
std::array<double, 3> cells_of(const BodySetup& setup, const BodySolid& solid, double slots) {
  if (!(slots < std::numeric_limits<std::uint32_t>::max())) return {std::cbrt(slots), std::cbrt(slots), std::cbrt(slots)};
  const Lattice lattice = lattice_that_fills(setup, solid);
  return {static_cast<double>(lattice.cells[0]), static_cast<double>(lattice.cells[1]), static_cast<double>(lattice.cells[2])};
}

/// Mean number of rows per pack of eight in the bond list of a point cloud, from a sample.
double rows_of_eight(const BodySetup& setup, const Cloud& cloud) {
  const std::size_t count = cloud.points.size(), eights = fccda::eights_of(count);
  const double horizon = setup.horizon_ratio * spacing_of(cloud);
  const bool to_the_last = setup.family.as<FamilyRule>() == FamilyRule::hu_ha_bobaru;
  std::vector<double> part(count, 0);  // [m] of the reach, from its own size; cube roots cost more than distances
  if (to_the_last) std::ranges::transform(cloud.volumes, part.begin(), [&](double volume) { return 0.25 * size_of_volume(volume, cloud.thickness); });
  const std::size_t sampled = std::min<std::size_t>(eights, 32);
  std::vector<double> longest(sampled, 0);
  fccda::parallel_for_uneven(static_cast<std::ptrdiff_t>(sampled), [&](std::ptrdiff_t k) {
    const std::size_t first = (2 * static_cast<std::size_t>(k) + 1) * eights / (2 * sampled) * fccda::byte_lanes;
    for (std::size_t i = first; i < std::min(first + fccda::byte_lanes, count); ++i) {
      double bonds = 0;
      for (std::size_t j = 0; j < count; ++j) {
        const double reach = horizon + part[i] + part[j];
        bonds += j != i && squared_norm(cloud.points[j] - cloud.points[i]) < reach * reach ? 1 : 0;
      }
      longest[static_cast<std::size_t>(k)] = std::max(longest[static_cast<std::size_t>(k)], bonds);
    }
  });
  return std::accumulate(longest.begin(), longest.end(), 0.0) / static_cast<double>(sampled);
}

ArrayLengths lengths_of(const BodySetup& setup, const Discretisation& discretisation) {
  const double slots = std::ceil(slots_of(setup, discretisation) / lanes) * lanes, particles = particles_of(setup, discretisation);
  if (const auto* cloud = std::get_if<Cloud>(&discretisation)) {
    const double rows = slots / lanes * rows_of_eight(setup, *cloud);
    return {.particles = particles, .slots = slots, .with_slack = slots, .rows = rows, .entries = rows * lanes};
  }
  const Stencil stencil(setup.family.as<FamilyRule>(), setup.spacing.value_or(1), setup.horizon_ratio, setup.is_plane() ? std::optional(1.0) : std::nullopt);
  const BodySolid& solid = std::get<BodySolid>(discretisation);
  const std::array<double, 3> cells = cells_of(setup, solid, slots);
  const double row = slots / (cells[1] * cells[2]), reach = stencil.reach(), family = static_cast<double>(stencil.size());
  const double slack = reach * (setup.is_plane() ? row : row * cells[1] + row) + reach + lanes;
  const auto inner = [&](std::size_t axis, double depth) { return axis == 2 && setup.is_plane() ? cells[2] : std::max(0.0, cells[axis] - 2 * depth); };
  // particles near a surface have factors of their own, and so have those bonded to them
  const double changed = 2 * reach, affected = 3 * reach;
  const auto packs_within = [&](double depth) { return std::floor(inner(0, depth) / lanes) * lanes * inner(1, depth) * inner(2, depth); };
  // rows at the same distances from the faces share a table, if four packs of their interior do
  const auto classes = [&](std::size_t axis) { return std::min(cells[axis], 2 * affected + 1); };
  const double tables = inner(0, affected) >= 4 * lanes ? classes(1) * (setup.is_plane() ? 1 : classes(2)) : 1;
  return {.particles = particles,
          .slots = slots,
          .with_slack = slots + 2 * slack,
          .rows = slots / lanes * family,
          .tables = tables * family,
          .surface = 1 - packs_within(changed) / slots,
          .partial = 1 - packs_within(reach) / slots};
}

/// [bytes] of one body, and what is added to it for a while.
struct BodyMemory {
  double count = 0;      ///< particles
  double particles = 0;  ///< positions, velocities, forces
  double bonds = 0;      ///< bonds and material
  double impactors = 0;  ///< what each impactor keeps of each particle
  double fragments = 0;  ///< of contact between fragments
  double deck = 0;       ///< points of a cloud, in the deck and in the simulation's own set-up

  double making = 0;   ///< more while bonds are found and the material is built
  double step = 0;     ///< more while the stable time step is determined
  double picture = 0;  ///< more while an output frame is written
  double move = 0;     ///< more while its window moves
  double rubble = 0;   ///< more if all bonds break
};

/// [bytes] per particle of self_contact/near_pairs.hpp and self_contact/short_range.hpp in rubble as dense as the solid, at most while the
/// list is rebuilt.
double rubble_of(const BodySetup& setup, const FragmentContactSetup& fragments) {
  const double dimension = setup.is_plane() ? 2 : 3, of_pair = fragments.friction > 0 ? vector : 0;  // its tangential spring
  // lattice points within 2.5 and 2 spacings, the reach of the list and of the weight function, and those farther away in pairs with fast particles
  const double within_skin = (setup.is_plane() ? 20 : 80) * std::pow((2 * fragments.distance_ratio + 0.5) / 2.5, dimension);
  const double far = 0.07 * within_skin, listed = within_skin + far;
  const double near = (setup.is_plane() ? 8 : 26) * std::pow(fragments.distance_ratio, dimension);
  // an eighth more than their pairs has room in the list
  const double pair = 3.25 * slot_number + of_pair, gap = 4 * pair, spare = 0.25 * slot_number,
               kept = 2 * number + of_pair;  // stored once per pair
  const double member = sizeof(NearPairs::Member) + sizeof(PlaceOfMember) + sizeof(MotionOfMember) + sizeof(PairSum) + 14 * number + 6 * slot_number + 3;
  return listed * (pair + spare) + far * 2 * slot_number + gap + near / 2 * kept + member;
}

/// [bytes] while the stiffest mode of the body is sought, which is done for a given time step that may be unstable (integrate/stiffest_mode.hpp): a copy of
/// the body, densities, and four fields of displacements. The stable step is that of a block of the same material.
double stiffest_mode_of(const Setup& setup, const BodySetup& body, const Discretisation& discretisation, const ArrayLengths& length, double copy) {
  if (!setup.time.step || setup.time.relax) return 0;
  constexpr int cells = 12;
  if (!body.spacing || *setup.time.step <= 0.9 * safe_stable_step(make_body(sample_block(body, discretisation, cells)))) return 0;
  return copy + number * length.slots + 4 * vector * length.particles;
}

BodyMemory memory_of(const Setup& setup, const BodySetup& body, const Discretisation& discretisation) {
  const ArrayLengths length = lengths_of(body, discretisation);
  const double n = length.slots, p = length.particles;
  BodyMemory memory{.count = p};
  memory.particles = 9 * number * length.with_slack + n / lanes + slot_number * p;     // x, v, f; occupied; slot_of
  memory.bonds = length.rows + number * n * length.partial + slot_number * n / lanes;  // bits; initial volumes and their places
  memory.bonds += SumsOfEights::bytes_of_eight * n / lanes;
  if (length.is_list()) {
    memory.particles += (vector + number) * n + slot_number * p;  // reference positions, volumes, numbers in the file
    memory.bonds +=
        vector * n + number * n / lanes + length.entries * (sizeof(std::int32_t) + 2 * number);  // positions again; begin; neighbour, length, volume
    memory.making = (vector + number) * n + 2 * vector * n / 7;  // of the search: positions and sizes, and boxes of 8, 64, 512 … slots
  }
  const MaterialMemory material = with_material(body, [&](const auto& its, auto kind) { return kind.memory(its, {body, kind.correction(body), length}); });
  memory.bonds += material.at_rest;
  memory.making = std::max(memory.making, material.setting_up);
  if (body.failure && (body.failure->weibull_modulus || !body.failure->no_fail.empty())) memory.making += number * n;  // strength of each slot
  memory.impactors = static_cast<double>(setup.impactors.size()) * (number + sizeof(int)) * n;                         // due distance, guess
  if (setup.contact.impactors.crushing_pressure) memory.impactors += (number + vector) * n;
  if (const auto* points = std::get_if<PointsShape>(&body.shape)) memory.deck = 2 * (vector + number) * static_cast<double>(points->points.size());
  memory.step = std::max(4 * number * n + n / 2, stiffest_mode_of(setup, body, discretisation, length, memory.particles + memory.bonds));

  // one array of vectors in single precision, and all arrays compressed: at most 19 bytes a particle (docs/guide/cluster.md)
  const bool may_break = body.elastic().may_fail();
  if (setup.output.frames > 0)
    memory.picture = std::max(3 * sizeof(float) * p + 19 * p, may_break ? 2 * slot_number * n : 0) + (may_break ? slot_number * p : 0);
  if (setup.output.frames > 0 && setup.output.frame_particles) memory.picture += 2 * slot_number * p;  // numbers of the particles, kept and of a frame
  if (setup.contact.fragments.law.as<FragmentLaw>() != FragmentLaw::none) {
    // near_pairs.hpp and short_range.hpp: particle, position when the list was built, mark, member, pairs, cell and point, position and reference position in
    // its cell; about as many cells: first point, next point while they are sorted, body, and two marks; runs of some 64 particles with their displacements;
    // threshold, surfaces, particle of a slot, broken ends of eights
    const double of_particle = sizeof(NearPairs::Member) + vector + 1 + 4 * slot_number + 2 * vector, of_cell = 3 * slot_number + 2,
                 of_run = sizeof(ParticleRun) + sizeof(DisplacementExtremes);
    memory.fragments = (of_particle + of_cell + of_run / 64) * p + (number + 1 + 2 + slot_number + sizeof(std::uint32_t) / lanes) * n;
    memory.rubble = rubble_of(body, setup.contact.fragments) * n;
  }
  // a new body, and a copy of the state
  if (body.moving_window)
    memory.move = memory.particles + memory.bonds + memory.making + 9 * number * n + length.rows + (memory.impactors + memory.fragments) / 2;
  return memory;
}

Memory sum_of(std::span<const BodyMemory> bodies) {
  double filled = program, built = 0, others = 0, while_built = 0, step = 0;
  Memory sum;
  for (const BodyMemory& body : bodies) filled += body.particles + body.impactors + body.deck;
  for (const BodyMemory& body : bodies) {  // built one after the other
    built += body.bonds;
    others += body.fragments;
    while_built = std::max(while_built, filled + built + body.making);
    step = std::max(step, body.step);
    sum.rubble += body.rubble;
    sum.decks += body.deck;
    sum.particles.push_back(body.count);
    sum.of_bodies.push_back(body.particles + body.bonds + body.deck);
    sum.pictures = std::max(sum.pictures, body.picture);
    sum.moves = std::max(sum.moves, body.move);
  }
  sum.at_rest = filled + built + others;
  sum.setting_up = std::max({0.0, while_built - sum.at_rest, step});
  return sum;
}

}  // namespace

void Memory::reduce_to(double share) {
  double alike = program + decks;  // on every rank
  for (const OfSurface& surface : of_surfaces) alike += surface.bytes;
  at_rest = alike + share * (at_rest - alike);
  for (double& of_body : of_bodies) of_body *= share;
  setting_up *= share;
  moves *= share;
  rubble *= share;
}

double share_of_slots(const Lattice& whole, const CellBox& cells) {
  Lattice own = whole;
  for (std::size_t axis = 0; axis < 3; ++axis) own.cells[axis] = cells.size(axis);
  return static_cast<double>(own.slots()) / static_cast<double>(whole.slots());
}

double share_of_memory(const Setup& setup, std::span<const Discretisation> bodies, const Ranks& ranks, std::span<const MeasuredLoad> loads) {
  if (ranks.size() == 1) return 1;
  double largest = 0;
  RanksInTurn in_turn(ranks.size());
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const MeasuredLoad load = load_of_body(loads, b);
    if (const auto* cloud = std::get_if<Cloud>(&bodies[b])) {
      const CloudPart part = parts_of(setup.bodies[b], *cloud, ranks.size(), in_turn.first_rank(), load).of(ranks.rank());
      in_turn.add(part.partition.parts());
      largest = std::max(largest, static_cast<double>(part.eights.size()) / static_cast<double>(part.partition.eights()));
      continue;
    }
    const Lattice whole = lattice_that_fills(setup.bodies[b], std::get<BodySolid>(bodies[b]));
    const PartitionRule rule = partition_rule_of(setup.bodies[b], whole, load);
    const std::vector<CellBox> boxes = boxes_of_ranks(rule, ranks.size(), in_turn.first_rank());
    in_turn.add(count_parts(boxes));
    largest = std::max(largest, share_of_slots(whole, with_ghosts(boxes[static_cast<std::size_t>(ranks.rank())], rule)));
  }
  return largest;
}

double Memory::peak() const { return at_rest + std::max({setting_up, pictures, moves}); }

Memory memory_of(const Setup& setup, std::span<const Discretisation> bodies) {
  std::vector<BodyMemory> each;
  for (std::size_t b = 0; b < bodies.size(); ++b) each.push_back(memory_of(setup, setup.bodies[b], bodies[b]));
  return sum_of(each);
}

void Memory::add(const fccda::Surface& surface) {
  const auto triangles = static_cast<double>(surface.triangles().size()), panels = static_cast<double>(surface.report().panels);
  // vertices and triangles with panels, neighbours and components; pseudonormals of faces, edges and vertices; faces and loads of panels
  constexpr double of_triangle = 74 + 4.5 * vector, of_panel = 180;
  // leaves of 440 bytes for three triangles, nodes, and the leaf of a triangle: of the detector, and to find the nearest particle
  constexpr double tree = 440.0 / 3 + 48 + sizeof(std::int32_t), while_built = 52;
  of_surfaces.push_back({triangles * (of_triangle + 2 * tree + while_built) + panels * of_panel, surface.report().panels});
  at_rest += of_surfaces.back().bytes;
}

void expect_to_fit(const Setup& setup, std::span<const Discretisation> bodies, const Memory& memory, const AvailableMemory& available) {
  const double needed = memory.peak();
  if (needed <= available.bytes) return;  // false for NaN
  const auto surface = std::ranges::max_element(memory.of_surfaces, {}, &Memory::OfSurface::bytes);
  if (surface != memory.of_surfaces.end() && surface->bytes > std::ranges::max(memory.of_bodies)) {
    const std::string& impactor = setup.impactors[static_cast<std::size_t>(surface - memory.of_surfaces.begin())].name;
    throw SetupError("impactors." + impactor + ".surface",
                     fmt::format("with {} panels on the surface of impactor {} the run needs {:.3g} GB of memory, but {}; use larger panels, or {}.",
                                 surface->panels, impactor, needed / 1e9, available.reason, available.remedy));
  }
  const std::size_t largest = static_cast<std::size_t>(std::ranges::max_element(memory.of_bodies) - memory.of_bodies.begin());
  const BodySetup& body = setup.bodies[largest];
  if (!body.spacing)
    throw SetupError("bodies." + body.name + ".shape",
                     fmt::format("with {:.3g} particles of body {} the run needs {:.3g} GB of memory, but {}; use fewer and larger particles, or {}.",
                                 slots_of(body, bodies[largest]), body.name, needed / 1e9, available.reason, available.remedy));
  const std::string key = "bodies." + body.name + ".spacing";
  if (!std::isfinite(needed))
    throw SetupError(key, fmt::format("a spacing of {} m gives body {} more cells than can be numbered; increase it.", *body.spacing, body.name));
  const double room = std::max(available.bytes - program, 1e6);
  throw SetupError(key,
                   fmt::format("with a spacing of {} m for body {} the run needs {:.3g} GB of memory, but {}; use a spacing of at least {:.2g} m, a "
                               "smaller body, or {}.",
                               *body.spacing, body.name, needed / 1e9, available.reason, 1.05 * *body.spacing * std::cbrt(needed / room), available.remedy));
}

}  // namespace perimpact
