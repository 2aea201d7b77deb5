#include "perimpact/moving_window/moving_window.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "base/error.hpp"
#include "perimpact/deck_model/setup_error.hpp"

namespace perimpact {

namespace {

/// What keeps the body from being a window onto uniform material; empty if nothing does.
std::string obstacle(const Setup& setup, const BodySetup& body, const Particles& particles) {
  if (setup.time.relax) return "time.relax finds equilibria of one body; remove time.relax";
  const Lattice* lattice = particles.whole_lattice();
  if (!lattice) return "its particles are those of a file; fill a shape: box";
  if (particles.size_of_body() != lattice->slots()) {
    const int cells = lattice->cells[0], next = (cells + MovingWindow::cells_of_move - 1) / MovingWindow::cells_of_move * MovingWindow::cells_of_move;
    if (next != cells)
      return fmt::format("it has {} particles along x, which must be a multiple of {}; make it {:.6g} m long along x", cells, MovingWindow::cells_of_move,
                         next * lattice->spacing);
    return "it does not fill a box; remove holes and added solids, and keep particles out of impactors at the start";
  }
  if (!body.cracks.empty()) return "it has initial cracks, which material added later lacks; remove them";
  if (body.failure && body.failure->weibull_modulus) return "its strength is scattered (failure.weibull_modulus); remove the scatter";
  if (body.velocity != Vec3d{}) return "it has an initial velocity; let the impactor travel instead";
  const auto is_on = [&](const auto& one) { return one.body == body.name; };
  if (std::ranges::any_of(setup.output.probes, is_on) || std::ranges::any_of(setup.output.lines, is_on))
    return "probes and lines refer to points of it, which are discarded; remove them";
  for (const BoundaryConditionSetup& one : body.boundary_conditions) {
    const auto* floating = std::get_if<FloatingSetup>(&one.kind);
    if (floating && !floating->particle_set.empty()) return fmt::format("boundary condition {} floats a part of it; float all of it", one.name);
    if (!floating && !std::holds_alternative<FixedSetup>(one.kind) && !std::holds_alternative<AbsorbingSetup>(one.kind))
      return fmt::format("boundary condition {} is none of fixed, absorbing and floating; remove it", one.name);
  }
  return "";
}

std::size_t impactor_of(const MovingWindowSetup& window, const std::string& key, std::span<const Impactor> impactors) {
  const auto found = std::ranges::find(impactors, window.follow, &Impactor::name);
  if (found == impactors.end())
    throw SetupError(key + ".follow", fmt::format("the window follows impactor {}, which does not exist; name one of the deck's impactors.", window.follow));
  return static_cast<std::size_t>(found - impactors.begin());
}

}  // namespace

MovingWindow::MovingWindow(const Setup& setup, std::size_t body, const Body& its, std::span<const Impactor> impactors)
    : name_(its.name), body_(body), axis_(static_cast<std::size_t>(setup.bodies[body].moving_window->axis.index)) {
  const MovingWindowSetup& window = *setup.bodies[body].moving_window;
  const std::string key = "bodies." + name_ + ".moving_window";
  impactor_ = impactor_of(window, key, impactors);
  if (const std::string reason = obstacle(setup, setup.bodies[body], its.particles); !reason.empty())
    throw SetupError(key, fmt::format("body {} cannot be a moving window: {}.", name_, reason));
  start_after_ = window.start_after;
  length_of_move_ = cells_of_move * its.particles.spacing();
  start_ = position(impactors);
}

double MovingWindow::position(std::span<const Impactor> impactors) const { return impactors[impactor_].body().position_of_com()[axis_]; }

std::array<int, 3> MovingWindow::first() const { return cells_of(moves_); }

std::array<int, 3> MovingWindow::cells_of(long moves) const {
  std::array<int, 3> cells{};
  cells[axis_] = static_cast<int>(moves) * cells_of_move;
  return cells;
}

long MovingWindow::moves_due(std::span<const Impactor> impactors) const {
  const double travelled = position(impactors) - start_;
  const auto wanted = static_cast<long>(std::floor(std::max(0.0, std::abs(travelled) - start_after_) / length_of_move_));
  if (wanted <= std::abs(moves_) || (moves_ != 0 && std::signbit(travelled) != (moves_ < 0))) return 0;
  return (travelled < 0 ? -wanted : wanted) - moves_;
}

int MovingWindow::cells_from_front(const Particles& particles, std::size_t slot, long moves) const {
  const Lattice& whole = *particles.whole_lattice();
  const int cell = whole.cell(particles.share().whole_slot(slot))[axis_];
  return moves < 0 ? cell : whole.cells[axis_] - 1 - cell;
}

void MovingWindow::expect_fixed_along(const BoundaryConditions& boundary_conditions, const Particles& particles, long moves) const {
  const Share& share = particles.share();
  const Lattice& whole = *particles.whole_lattice();
  for (std::size_t direction = 0; direction < 3; ++direction) {
    std::vector<std::size_t> own;  // of all boundary conditions: they share the edges of a sheet
    std::vector<std::pair<const std::string*, std::vector<std::size_t>>> sets;
    for (const NamedBoundaryCondition& one : boundary_conditions.all()) {
      const auto* fixed = std::get_if<PrescribedDisplacement>(&one.boundary);
      if (!fixed || !fixed->constrains(direction)) continue;
      std::vector<std::size_t>& slots = sets.emplace_back(&one.name, std::vector<std::size_t>{}).second;
      for (const std::uint32_t slot : fixed->slots()) slots.push_back(share.whole_slot(slot));
      own.insert(own.end(), slots.begin(), slots.end());
    }
    std::vector<std::size_t> all = share.ranks().join_all(std::span<const std::size_t>(own));
    std::ranges::sort(all);
    for (const auto& [name, slots] : sets) {
      const auto was_free = std::ranges::any_of(slots, [&](std::size_t slot) {
        std::array<int, 3> cell = whole.cell(slot);
        cell[axis_] += cells_of(moves)[axis_];
        if (cell[axis_] < 0 || cell[axis_] >= whole.cells[axis_]) return false;  // it becomes of new material
        return !std::ranges::binary_search(all, whole.slot(cell[0], cell[1], cell[2]));
      });
      if (share.ranks().any(was_free))
        throw fccda::RunError(fmt::format(
            "The moving window of body {} moves along {}{}, and boundary condition {} would put back to its initial position material that was free. Fix "
            "particles at the front, or over the whole length of the window.",
            name_, moves < 0 ? '-' : '+', axis_ == 0 ? 'x' : 'y', *name));
    }
  }
}

void MovingWindow::inspect_front(const Body& body, long moves) {
  const auto reach = static_cast<int>(std::ceil(body.family.horizon() / body.particles.spacing()));
  for (const std::uint32_t slot : body.particles.slot_of()) {
    if (cells_from_front(body.particles, slot, moves) >= 2 * reach) continue;  // the family of particles with bonds to new material
    front_damage_ = std::max(front_damage_, body.family.damage(slot));
  }
  front_damage_ = body.particles.share().ranks().max(front_damage_);
}

void MovingWindow::continue_front(Body& body, long moves) const {
  // [cells] behind the front, for the slope; a set that is fixed over three cells thus has no slope, and new material there does not move either
  constexpr int base = 2;
  struct AtFront {
    std::uint64_t line;  // of cells along the axis
    bool is_second, is_damaged;
    Vec3d displacement, velocity;
  };
  Particles& particles = body.particles;
  const Share& share = particles.share();
  const Lattice& whole = *particles.whole_lattice();
  const int added = std::abs(cells_of(moves)[axis_]), length = whole.cells[axis_];
  if (length < added + base + 1) return;
  const std::size_t across = axis_ == 0 ? 1 : 0;
  const auto place_of = [&](std::size_t slot) {  // distance from the front, and line
    const std::array<int, 3> cell = whole.cell(share.whole_slot(slot));
    return std::pair(cells_from_front(particles, slot, moves),
                     static_cast<std::size_t>(cell[2]) * static_cast<std::size_t>(whole.cells[across]) + static_cast<std::size_t>(cell[across]));
  };
  std::vector<AtFront> own;
  for (const std::uint32_t slot : particles.slot_of()) {
    const auto [from_front, line] = place_of(slot);
    if (from_front == added || from_front == added + base)
      own.push_back({line, from_front != added, body.family.damage(slot) > 0, particles.displacement(slot), particles.velocity.at(slot)});
  }
  std::vector<std::array<AtFront, 2>> front(static_cast<std::size_t>(whole.cells[across]) * static_cast<std::size_t>(whole.cells[2]));
  for (const AtFront& one : share.ranks().join_all(std::span<const AtFront>(own))) front[one.line][one.is_second ? 1 : 0] = one;
  // Of damaged lines, by interpolation between the undamaged ones beside them in their layer.
  const auto lines_of_layer = static_cast<std::size_t>(whole.cells[across]);
  const auto undamaged = [&](std::size_t line, std::ptrdiff_t direction) -> std::optional<std::size_t> {
    for (std::size_t at = line; at / lines_of_layer == line / lines_of_layer && at < front.size(); at += static_cast<std::size_t>(direction))
      if (!front[at][0].is_damaged && !front[at][1].is_damaged) return at;
    return std::nullopt;
  };
  for (const std::uint32_t slot : particles.slot_of()) {
    const auto [from_front, line] = place_of(slot);
    if (from_front >= added) continue;
    const std::optional<std::size_t> before = undamaged(line, -1), after = undamaged(line, 1);
    if (!before && !after) continue;
    const std::size_t low = before ? *before : *after, high = after ? *after : *before;
    const double part = low == high ? 0 : static_cast<double>(line - low) / static_cast<double>(high - low),
                 way = static_cast<double>(added - from_front) / base;
    const auto continued = [&](Vec3d AtFront::*quantity) {
      const auto of_line = [&](std::size_t number) {
        const Vec3d &first = front[number][0].*quantity, &second = front[number][1].*quantity;
        return first + way * (first - second);
      };
      return low == high ? of_line(low) : of_line(low) + part * (of_line(high) - of_line(low));
    };
    particles.position.set(slot, particles.reference(slot) + continued(&AtFront::displacement));
    particles.velocity.set(slot, continued(&AtFront::velocity));
  }
  std::vector<double*> arrays;
  for (VectorArray* vectors : {&particles.position, &particles.velocity})
    for (double* component : vectors->writable_pointers()) arrays.push_back(component);
  share.refresh(std::span<double* const>(arrays));
}

void MovingWindow::expect_clear(std::span<Body> bodies, std::span<const Impactor> impactors, const ImpactorContactSetup& contact, long moves) const {
  Body& body = bodies[body_];
  const int added = std::abs(cells_of(moves)[axis_]);
  for (const Impactor& impactor : impactors) {
    const std::vector<std::size_t> inside = impactor.initial_overlap(body_, ContactParticles(body.particles, contact, {}, 0));
    const auto here = std::ranges::count_if(inside, [&](std::size_t slot) { return cells_from_front(body.particles, slot, moves) < added; });
    const std::int64_t all = body.particles.share().ranks().sum(static_cast<std::int64_t>(here));
    if (all > 0)
      throw fccda::RunError(fmt::format(
          "The moving window of body {} has reached impactor {}: {} particles of new material are inside its surface, or nearer to it than the contact "
          "radius. Start the impactor behind the front, end the run before, or use a body of the whole track without moving_window.",
          name_, impactor.name(), all));
  }
  const Lattice& whole = *body.particles.whole_lattice();
  Vec3d low{}, high{};  // [m] of the cells of new material
  for (std::size_t c = 0; c < 3; ++c) {
    const int cells = whole.cells[c], all_from = c == axis_ && moves > 0 ? cells - added : 0, all_to = c == axis_ && moves < 0 ? added : cells;
    low[c] = whole.origin[c] + (whole.first[c] + all_from - 0.5) * whole.spacing;
    high[c] = whole.origin[c] + (whole.first[c] + all_to - 0.5) * whole.spacing;
  }
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    if (b == body_) continue;
    const Particles& others = bodies[b].particles;
    const auto here = std::ranges::count_if(others.slot_of(), [&](std::uint32_t slot) {
      const Vec3d at = others.position.at(slot);
      return at.x > low.x && at.x < high.x && at.y > low.y && at.y < high.y && (whole.thickness || (at.z > low.z && at.z < high.z));
    });
    const std::int64_t all = others.share().ranks().sum(static_cast<std::int64_t>(here));
    if (all > 0)
      throw fccda::RunError(
          fmt::format("The moving window of body {} has reached body {}: {} of its particles are where new material begins. Start the body elsewhere, end the "
                      "run before, or use "
                      "a body of the whole track without moving_window.",
                      name_, bodies[b].name, all));
  }
}

std::vector<std::string> MovingWindow::warnings() const {
  if (front_damage_ == 0) return {};
  return {fmt::format(
      "The moving window of body {} moved although the material at its front was damaged (up to {:.3g}); the material attached to it is not. Make the "
      "body longer, or reduce moving_window.start_after, so that the impactor stays further from the front.",
      name_, front_damage_)};
}

std::vector<MovingWindow> moving_windows_of(const Setup& setup, std::span<const Body> bodies, std::span<const Impactor> impactors) {
  std::vector<MovingWindow> windows;
  for (std::size_t b = 0; b < bodies.size(); ++b)
    if (setup.bodies[b].moving_window) windows.emplace_back(setup, b, bodies[b], impactors);
  return windows;
}

}  // namespace perimpact
