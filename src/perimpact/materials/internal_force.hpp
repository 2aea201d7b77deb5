/// Internal forces of a body, for any material.
#pragma once

#include <variant>

#include "base/typelist.hpp"
#include "perimpact/materials/all_materials.hpp"
#include "perimpact/particles/shared_numbers.hpp"
#include "perimpact/particles/sum_over_eights.hpp"

namespace perimpact {

/// The force kernels of all materials. Each has pass<Pack>(particles, family, options, sums), breaking(), bond_stiffness(slot, bond), bytes() and messages();
/// visit_state if the next step depends on more than particles and bonds, and visit_record for what is only summed.
template <class Setups>
struct ForcesOf;
template <class... Setups>
struct ForcesOf<std::variant<Setups...>> {
  using type = fccda::JoinedVariant<typename Material<Setups>::Force...>;
};

/// Internal force density from the bonds, with bond failure.
class InternalForce {
 public:
  using Kind = ForcesOf<MaterialSetup>::type;

  InternalForce(Kind kind, const Particles& particles);

  /// Writes particles.force_density [N/m³], the sum over intact bonds at the current positions. Each particle sums in the order of its family, so that
  /// results are bitwise reproducible across thread counts. Bonds beyond their limit break in this pass. `dt` [s]: last step, in whose middle they are
  /// assumed to break; 0 if there was none.
  void evaluate(Particles& particles, Family& family, double dt = 0);

  /// The same; returns the elastic energy at these positions [J].
  double evaluate_with_energy(Particles& particles, Family& family, double dt = 0);

  /// The same as evaluate(), without bond failure.
  void evaluate_unbroken(Particles& particles, Family& family);

  /// Breaks all bonds of a particle, which may be a ghost; their elastic energy is not accounted for.
  void isolate(std::size_t slot, const Particles& particles, Family& family) {
    family.isolate(slot, particles, [&](std::size_t of) { ++sums_.broken_ends[of / fccda::byte_lanes]; });
  }

  /// The same as evaluate(), one particle at a time: reference for the tests.
  void evaluate_scalar(Particles& particles, Family& family, double dt = 0);

  /// From now on kernels work on one particle at a time, which is the reference for devices.
  void use_scalar_kernel() { is_scalar_ = true; }
  /// f(kernel, sums): for a device, which performs the passes, and enters what they find in the sums.
  template <class F>
  void with_kernel_and_sums(const F& f) {
    std::visit([&](auto& force) { f(force, sums_); }, kind_);
  }
  double elastic_energy() const { return exact_sum(share_.ranks(), sums_.energy); }  ///< [J] at the last pass that summed it

  std::size_t broken_bonds() const;                                                 ///< since construction, each counted once
  std::span<const std::uint32_t> broken_ends() const { return sums_.broken_ends; }  ///< since construction, of each eight

  /// [J] elastic energy released by bond failure since construction (docs/theory/energy.md).
  double fracture_energy() const;

  /// [N/m⁷] derivative of a bond's force density with respect to its length, without the contribution of its family.
  double bond_stiffness(std::size_t slot, const FamilyBond& bond) const {
    return std::visit([&](const auto& force) { return force.bond_stiffness(slot, bond); }, kind_);
  }

  /// f(kernel) with the force kernel of the material.
  template <class F>
  auto with_kernel(const F& f) const {
    return std::visit(f, kind_);
  }

  const Breaking& breaking() const {
    return std::visit([](const auto& force) -> const Breaking& { return force.breaking(); }, kind_);
  }
  const OrdinaryStateForce* ordinary_state() const { return std::get_if<OrdinaryStateForce>(&kind_); }
  const Correspondence* correspondence() const;  ///< null for other materials
  const PlasticForce* plastic() const { return std::get_if<PlasticForce>(&kind_); }
  PlasticForce* plastic() { return std::get_if<PlasticForce>(&kind_); }
  double plastic_dissipation() const { return plastic() ? plastic()->dissipation(share_.ranks()) : 0; }  ///< [J] since construction
  double bytes() const;                                                                                  ///< [bytes] of memory
  StepMessages messages() const {                                                                        ///< of evaluate()
    return std::visit([](const auto& force) { return force.messages(); }, kind_);
  }

  template <class Visitor>
  void visit_state(const std::string& name, Visitor&& visit) {
    visit(name + ".broken_ends_of_eight", SumsSinceBeginning(std::span<std::uint32_t>(sums_.broken_ends)));
    std::visit(
        [&](auto& force) {
          if constexpr (requires { force.visit_state(name, visit); }) force.visit_state(name, visit);
        },
        kind_);
  }

  /// To be called after visit_state(): restores what follows from the state (PlasticForce::derive_from_state). Collective.
  void derive_from_state(const Particles& particles, const Family& family) {
    std::visit(
        [&](auto& force) {
          if constexpr (requires { force.derive_from_state(particles, family); }) force.derive_from_state(particles, family);
        },
        kind_);
  }

  /// Accumulated energies; they do not affect any step.
  template <class Visitor>
  void visit_record(const std::string& name, Visitor&& visit) {
    visit(name + ".fracture_energy_of_eight", SumsSinceBeginning(std::span<double>(sums_.fracture_energy)));
    std::visit(
        [&](auto& force) {
          if constexpr (requires { force.visit_record(name, visit); }) force.visit_record(name, visit);
        },
        kind_);
  }

 private:
  void pass(Particles& particles, Family& family, const PassOptions& options);

  Kind kind_;
  Share share_;  // of the particles, over which sums are taken
  SumsOfEights sums_;
  bool is_scalar_ = false;
};

}  // namespace perimpact
