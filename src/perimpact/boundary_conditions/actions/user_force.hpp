/// User force: a force density computed by user code in every step from the particle positions, in Python or with the library.
///
///   F_i(t_n) = V_i f_i(t_n, x_n)        [N]
///
/// Its work is Σ ½ (F_n + F_{n+1})·v_{n+1/2} dt, the work in symplectic Euler (reaction_ledger.hpp).
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "fccda/rigid_body/step.hpp"
#include "perimpact/boundary_conditions/actions/reaction_ledger.hpp"
#include "perimpact/particles/particles.hpp"

namespace perimpact {

class UserForce {
 public:
  /// Writes the force density [N/m³] at that time [s] into the slots of particles; initially all are 0.
  using Function = std::function<void(double time, VectorArray& density)>;

  /// `name`: for messages.
  UserForce(std::string name, const Particles& particles, Function function);

  std::span<const std::uint32_t> slots() const { return slots_; }

  /// Adds the user force to the force densities at the beginning of the next step. Throws RunError if it is not finite, InputError if it has
  /// a z component in a plane body.
  void apply_load(Particles& particles, const fccda::Step& next);

  /// [J] see Load::half_kick().
  double half_kick(double time, double dt) const;

  ReactionLedger account;

  template <class Visitor>
  void visit_record(const std::string& name, Visitor&& visit) {
    account.visit_record(name, visit);
    constexpr const char* axis[] = {"_x", "_y", "_z"};
    for (std::size_t c = 0; c < 3; ++c) visit(name + ".density" + axis[c], std::span<double>(density_.component(c), density_.slots()));
  }

 private:
  std::string name_;
  std::vector<std::uint32_t> slots_;
  Function function_;
  VectorArray density_, before_;          // [N/m³] current, and at the beginning of the previous step
  double squared_force_per_density_ = 0;  // [N m] Σ V f²/ρ
};

}  // namespace perimpact
