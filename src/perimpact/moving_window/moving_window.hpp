/// Moving window: a body on a lattice that follows an impactor, so that a long track costs no more than the material around the impactor
/// (docs/theory/moving_window.md).
///
/// The lattice is a window onto an unbounded one. When it moves by whole cells, each slot takes over the state of the slot ahead of it; the slots at the front
/// get new material, and the state of those behind is discarded. What belongs to slots stays in place: boundary conditions, surface correction,
/// edges that do not break.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "perimpact/body/body.hpp"
#include "perimpact/boundary_conditions/boundary_conditions.hpp"
#include "perimpact/deck_model/setup.hpp"
#include "perimpact/impactor/impactor.hpp"

namespace perimpact {

class MovingWindow {
 public:
  static constexpr int cells_of_move = 8;  ///< slots that share bytes of bonds stay together

  /// `body`: index of a body with a moving window; `impactors` before the first step. Throws SetupError if this body cannot be a moving window. Collective.
  MovingWindow(const Setup& setup, std::size_t body, const Body& its, std::span<const Impactor> impactors);

  std::size_t body() const { return body_; }                                       ///< index
  const std::string& name() const { return name_; }                                ///< of the body
  std::array<int, 3> first() const;                                                ///< Lattice::first of the body on all ranks
  double travel() const { return static_cast<double>(moves_) * length_of_move_; }  ///< [m] along its axis, with its sign

  /// Moves due with the impactors where they are, with the sign of the direction; the window never moves back.
  long moves_due(std::span<const Impactor> impactors) const;
  void move(long moves) { moves_ += moves; }

  /// To be called before a move: throws RunError if a boundary condition would fix, in its initial position, material that was free. Collective.
  void expect_fixed_along(const BoundaryConditions& boundary_conditions, const Particles& particles, long moves) const;
  /// To be called before a move: examines the material at the front, to which new material is going to be attached. Collective.
  void inspect_front(const Body& body, long moves);
  /// To be called after a move: gives new material the displacement and the velocity of the front, continued linearly along each line of cells from the front
  /// and the second cell behind it. Where a line is damaged there, both are interpolated between the undamaged lines beside it in its layer. New material stays
  /// undeformed and at rest where a whole layer is damaged, and everywhere if fewer than three cells of the window are left of a move. Collective.
  void continue_front(Body& body, long moves) const;
  /// To be called after a move: throws RunError if new material is inside an impactor, or nearer to it than the contact radius, or overlaps particles of
  /// another body. Collective.
  void expect_clear(std::span<Body> bodies, std::span<const Impactor> impactors, const ImpactorContactSetup& contact, long moves) const;
  /// A warning if the material at the front was damaged in any move so far.
  std::vector<std::string> warnings() const;

  /// Displacement of the window by these moves, in cells along each axis.
  std::array<int, 3> cells_of(long moves) const;

  /// See base/state.hpp.
  template <class Visitor>
  void visit_state(Visitor&& visit) {
    visit(name_ + ".window_moves", moves_);
  }

  /// Record, which does not affect steps.
  template <class Visitor>
  void visit_record(Visitor&& visit) {
    visit(name_ + ".window_front_damage", front_damage_);
  }

 private:
  double position(std::span<const Impactor> impactors) const;                            // [m] of the impactor along the axis
  int cells_from_front(const Particles& particles, std::size_t slot, long moves) const;  // with this direction of the moves

  std::string name_;
  std::size_t body_, impactor_, axis_;
  double start_after_, length_of_move_;  // [m]
  double start_;                         // [m] initial position of the impactor
  long moves_ = 0;
  double front_damage_ = 0;  // [-] largest
};

/// Of all bodies that have one. Throws SetupError.
std::vector<MovingWindow> moving_windows_of(const Setup& setup, std::span<const Body> bodies, std::span<const Impactor> impactors);

}  // namespace perimpact
