/// What the bonds of a body do to its particles, whatever its material.
#pragma once

#include <variant>

#include "perimpact/materials/correspondence/correspondence_force.hpp"
#include "perimpact/materials/ordinary_state/ordinary_state_force.hpp"
#include "perimpact/materials/ordinary_state/plastic_force.hpp"

namespace perimpact {

class InternalForce {
 public:
  using Kind = std::variant<OrdinaryStateForce, CorrespondenceForce<3>, CorrespondenceForce<2>, PlasticForce>;  // by material

  InternalForce(Kind kind, const Particles& particles);

  /// Writes particles.force_density [N/m³], the sum over intact bonds at the current positions, in the order of the family for each
  /// particle, so that the result is the same to the last bit for any number of threads. Bonds that are too long break on the way; `dt` [s] is that of the step
  /// that led here, in whose middle they are taken to break, and 0 where none did.
  void evaluate(Particles& particles, Family& family, double dt = 0);

  /// The same, and returns the elastic energy at these positions [J].
  double evaluate_with_energy(Particles& particles, Family& family, double dt = 0);

  /// The same as evaluate(), and breaks no bond.
  void evaluate_unbroken(Particles& particles, Family& family);

  /// The same as evaluate(), one particle at a time: the oracle of the tests.
  void evaluate_scalar(Particles& particles, Family& family, double dt = 0);

  std::size_t broken_bonds() const;                                               ///< since construction, each counted once
  std::span<const std::size_t> broken_ends() const { return rows_.broken_ends; }  ///< since construction, of the particles of each row

  /// [J] what breaking took of the elastic energy since construction (docs/theory/energy.md).
  double fracture_energy() const;

  /// [N/m⁷] what the force density of a bond gains by each metre of its length, its family's share left aside.
  double bond_stiffness(std::size_t slot, const FamilyBond& bond) const {
    return std::visit([&](const auto& force) { return force.bond_stiffness(slot, bond); }, kind_);
  }

  const Breaking& breaking() const {
    return std::visit([](const auto& force) -> const Breaking& { return force.breaking(); }, kind_);
  }
  const OrdinaryStateForce* ordinary_state() const { return std::get_if<OrdinaryStateForce>(&kind_); }
  const Correspondence* correspondence() const;  ///< null of other materials
  const PlasticForce* plastic() const { return std::get_if<PlasticForce>(&kind_); }
  PlasticForce* plastic() { return std::get_if<PlasticForce>(&kind_); }
  double plastic_dissipation() const { return plastic() ? plastic()->dissipation() : 0; }  ///< [J] since construction
  double bytes() const;                                                                    ///< [bytes] of memory

  template <class Visitor>
  void visit_state(const std::string& name, Visitor&& visit) {
    visit(name + ".broken_ends_of_row", std::span<std::size_t>(rows_.broken_ends));
    if (plastic()) plastic()->visit_state(name, visit);
  }

  /// What was noted of the run so far; no step depends on it.
  template <class Visitor>
  void visit_record(const std::string& name, Visitor&& visit) {
    visit(name + ".fracture_energy_of_row", std::span<double>(rows_.fracture_energy));
    if (plastic()) plastic()->visit_record(name, visit);
  }

 private:
  Kind kind_;
  RowSums rows_;
};

}  // namespace perimpact
