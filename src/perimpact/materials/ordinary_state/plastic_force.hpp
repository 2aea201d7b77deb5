/// Forces of a bond-based or ordinary state-based material that yields under pressure: one plastic strain tensor a particle
/// (materials/plasticity/plasticity.hpp, docs/theory/ice_plasticity.md).
///
///   bond strain   s_e = (|y|² - |ξ|²)/(2 |ξ|²) - ½ n·(ε^p_i + ε^p_j)·n,  n = ξ/|ξ|                                      [-]
///   energy        W_i = a θ_i² + b Σ ω_e |ξ|² s_e² v V,  θ_i = (D/m_θ) Σ ω_θ |ξ|² s_e v V                               [J/m³]
///   force         f = [4 b ω_e s_e + 2 a (D/m_θ) ω_θ (θ_i + θ_j)] y, along the bond                                     [N/m⁶]
///   stress        σ_i = ½ Σ (f·y/|y|²) ξ⊗ξ v V = -(1/V_i) ∂E/∂ε^p_i                                                     [Pa]
///
/// A step evaluates forces and stresses with the plastic strain at its beginning; particles outside of the yield surface then flow. Where one was outside by
/// more than `overshoot_tolerance`, forces and stresses of those that flowed and of their families are evaluated again in the same step, and they flow
/// again, with at most `max_returns` flows; what is left acts in the next step. What flow dissipates is ½ (σ_n + σ_{n+1}) : Δε^p V, which closes the balance
/// of the time stepping as the trapezoidal rule does for forces (docs/theory/energy.md).
///
/// A bond breaks where s_e exceeds s_c k + ¾ max(0, p)/E, p the mean pressure of its two particles at the step before; once either has yielded, only where
/// p <= 0; a particle whose plastic strain has reached ε_f(p) has k = 0, and its shear strength is that of friction alone. Both ends decide from the same
/// numbers.
///
/// Cost: packs that know no plastic strain take a kernel without it, and compute their stresses only where their energy may reach the surface,
/// W > a0/(4 µ): with the stiffness C of a particle J2/(2 µ) + p²/(2 κ) <= ½ σ:C⁻¹:σ <= W (Cauchy-Schwarz).
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "perimpact/damage/breaking.hpp"
#include "perimpact/family/family.hpp"
#include "perimpact/family/surface_correction.hpp"
#include "perimpact/force/pass.hpp"
#include "perimpact/materials/ordinary_state/corrected_bond.hpp"
#include "perimpact/materials/ordinary_state/ordinary_state.hpp"
#include "perimpact/materials/plasticity/plasticity.hpp"
#include "perimpact/particles/shared_numbers.hpp"

namespace perimpact {

/// What makes a material yield, and when what has yielded loses its cohesion.
struct Plasticity {
  YieldEllipse ellipse;
  FailureStrain failure = {};
  double residual = std::numeric_limits<double>::infinity();  ///< [-] J2 <= residual p² of particles beyond ε_f; infinite: cohesion alone is lost
};

/// Elastic constants of the interior of a lattice, or of the isotropic material where the particles are a cloud.
ReturnModuli return_moduli(const OrdinaryState& law, const Stencil* stencil);

class PlasticForce {
 public:
  static constexpr double overshoot_tolerance = 0.05;  ///< [-] over the compressive strength: the equivalent stress and the pressure that flow removes
  static constexpr int max_returns = 12;               ///< flows in a step

  /// `strength` [-] of each slot (damage/strength.hpp) multiplies the critical stretch; where empty, 1 everywhere.
  PlasticForce(OrdinaryState law, const Plasticity& plasticity, const std::optional<BreakingRule>& rule, const std::vector<double>& strength,
               CorrectionFactors correction, const Family& family, const Particles& particles);

  /// Writes particles.force_density and the sums of the eights; unless bonds are held together (options.may_break), particles flow.
  template <class Pack>
  void pass(Particles& particles, Family& family, const PassOptions& options, SumsOfEights& sums);

  /// Which packs are evaluated: all, or again those whose plastic strain, or that of their families, has changed since.
  enum class Packs { all, affected };
  /// The same pass, in which evaluate(which) evaluates forces and stresses, by a device.
  template <class Evaluate>
  void pass_with(const Particles& particles, const Family& family, const PassOptions& options, const Evaluate& evaluate);
  /// f(view, corrections): what the kernels read of a body on a lattice, with these bonds of `rows` rows (plastic_kernels.hpp).
  template <class Bonds, class F>
  void with_view_of_lattice(const Particles& particles, const Bonds& bonds, std::size_t rows, double dt, const F& f);
  /// What an evaluation writes, or reads beside the view.
  struct Evaluation {
    std::array<double*, 6> stress;                      ///< [Pa] of hot slots
    double* pressure;                                   ///< [Pa]
    std::span<std::uint8_t> is_hot;                     ///< of each eight: bit l for slot 8 n + l
    std::span<double> dissipation;                      ///< [J] of each eight
    std::span<const std::uint8_t> is_plastic;           ///< of each eight: its kernels are those with plastic strain
    std::span<const std::uint8_t> affected;             ///< of each eight
    double elastic_limit;                               ///< [J/m³] beyond it slots without plastic strain are hot too
    std::span<const std::uint8_t> flows;                ///< of each eight: not 0 where the last flow has changed `of_flow`
    std::array<const double*, 14> of_flow;              ///< what flow changes and the view refers to, by slot
    std::array<std::span<const double>, 4> with_slack;  ///< the same, whole arrays
  };
  Evaluation evaluation() {
    return {stress_.writable_pointers(),
            latest_pressure_.component(0),
            is_hot_,
            dissipation_,
            is_plastic_,
            affected_,
            elastic_limit_,
            flows_,
            arrays_of_flow(),
            {strain_.with_slack(), increment_.with_slack(), pressure_slope_.with_slack(), resistance_.with_slack()}};
  }
  std::span<const double> pressures() const { return pressure_.with_slack(); }  ///< [Pa] of each slot, which the view refers to

  /// Calls visit(span) for each array of this object that kernels on a lattice read or write.
  template <class Visit>
  void visit_arrays(const Visit& visit) const {
    for (const TensorArray* array : {&strain_, &increment_, &stress_}) visit(array->with_slack());
    for (const ScalarArray* array : {&pressure_, &latest_pressure_, &pressure_slope_, &resistance_, &theta_}) visit(array->with_slack());
    for (const auto* marks : {&is_plastic_, &affected_}) visit(std::span(*marks));
    visit(std::span(constants_)), visit(std::span(half_squares_)), visit(std::span(projection_));
    correction_.visit_arrays(visit);
  }

  const Breaking& breaking() const { return breaking_; }
  const OrdinaryState& law() const { return law_; }
  const Plasticity& plasticity() const { return plasticity_; }
  const CorrectionFactors& correction() const { return correction_; }
  const ReturnModuli& moduli() const { return moduli_; }
  /// [N/m⁷] what the force density of a bond gains by each metre of its length at no strain, its dilatation left aside.
  double bond_stiffness(std::size_t slot, const FamilyBond& bond) const { return corrected_stiffness(law_, correction_, slot, bond); }
  /// [1/m⁴] what each metre of a bond's length, and cubic metre of its volume, adds to the dilatation of the particle.
  double dilatation_slope(std::size_t slot, const FamilyBond& bond) const { return corrected_dilatation_slope(law_, correction_, slot, bond); }
  double family_factor(std::size_t) const { return 1; }

  double equivalent_strain(std::size_t slot) const { return equivalent_.component(0)[slot]; }  ///< [-] Σ √(2/3 Δε^p:Δε^p)
  SymmetricTensor plastic_strain(std::size_t slot) const { return tensor_at(strain_, slot); }  ///< [-]
  double pressure(std::size_t slot) const { return pressure_.component(0)[slot]; }             ///< [Pa] at the last pass
  bool has_lost_cohesion(std::size_t slot) const { return has_failed_[slot] != 0; }
  /// [Pa] at the last pass, before flow; up to date where is_stress_known().
  SymmetricTensor stress(std::size_t slot) const { return tensor_at(stress_, slot); }
  bool is_stress_known(std::size_t slot) const { return (is_hot_[slot / fccda::byte_lanes] >> (slot % fccda::byte_lanes)) & 1u; }
  double dissipation(Ranks& ranks = alone()) const;  ///< [J] by plastic flow on these ranks, up to the last pass
  double bytes() const;                              ///< [bytes] of memory
  StepMessages messages() const;                     ///< of a pass in which no particle comes near its yield surface

  /// Gives a particle a plastic strain, as if it had flowed: for tests.
  void set_plastic_strain(std::size_t slot, const SymmetricTensor& strain, const Family& family);

  /// What the next step depends on, and `visit_record` what is only summed (base/state.hpp).
  template <class Visitor>
  void visit_state(const std::string& name, Visitor&& visit) {
    constexpr const char* component[] = {"_xx", "_yy", "_zz", "_xy", "_yz", "_xz"};
    const std::size_t slots = equivalent_.slots();
    for (std::size_t c = 0; c < 6; ++c) visit(name + ".plastic_strain" + component[c], std::span<double>(strain_.component(c), slots));
    for (std::size_t c = 0; c < 6; ++c) visit(name + ".plastic_increment" + component[c], std::span<double>(increment_.component(c), slots));
    visit(name + ".equivalent_plastic_strain", std::span<double>(equivalent_.component(0), slots));
    visit(name + ".pressure", std::span<double>(pressure_.component(0), slots));
    visit(name + ".pressure_slope", std::span<double>(pressure_slope_.component(0), slots));
    visit(name + ".has_failed", std::span<std::uint8_t>(has_failed_));
    visit(name + ".knows_plastic_strain", std::span<std::uint8_t>(is_plastic_));
  }
  /// To be called after visit_state(), whose visitor may have written: restores what follows from the state. Strength belongs to slots, while cohesion that is
  /// lost belongs to the material, which a moving window carries from slot to slot; new material has not yet seen the plastic strain beside it. Collective.
  void derive_from_state(const Particles& particles, const Family& family);
  template <class Visitor>
  void visit_record(const std::string& name, Visitor&& visit) {
    visit(name + ".dissipation_of_eight", SumsSinceBeginning(std::span<double>(dissipation_)));
    visit(name + ".pending_dissipation_of_eight", SumsSinceBeginning(std::span<double>(pending_)));
  }

  /// The constants of a bond, or of a pack of bonds of a list.
  template <class Number>
  struct Constants {
    Number spring;        ///< 4 b ω_e v V            [N/m⁴]
    Number squared;       ///< |ξ|²                   [m²]
    Number half_inverse;  ///< 1/(2 |ξ|²)             [1/m²]
    Number push;          ///< 2 a d ω_θ v V          [N/m⁴]
    Number dilatation;    ///< d ω_θ |ξ|² v V         [-]
  };
  /// `stretch`, `dilatation` [m⁵]: ω_e |ξ|² v V and ω_θ |ξ|² v V.
  template <class Number>
  FCCDA_HD static Constants<Number> constants(const OrdinaryState& law, Number length, Number stretch, Number dilatation) {
    const Number squared = length * length, inverse = Number(1.0) / squared;
    return {Number(4 * law.b()) * stretch * inverse, squared, Number(0.5) * inverse, Number(2 * law.a() * law.d()) * dilatation * inverse,
            Number(law.d()) * dilatation};
  }

 private:
  using TensorArray = SlotArray<6>;
  static SymmetricTensor tensor_at(const TensorArray& array, std::size_t slot) {
    SymmetricTensor tensor;
    for (std::size_t c = 0; c < 6; ++c) tensor[c] = array.component(c)[slot];
    return tensor;
  }
  static void set(TensorArray& array, std::size_t slot, const SymmetricTensor& tensor) {
    for (std::size_t c = 0; c < 6; ++c) array.component(c)[slot] = tensor[c];
  }

  std::array<const double*, 14> arrays_of_flow() const;
  template <class Pack>
  void evaluate(Packs which, Particles& particles, Family& family, const PassOptions& options, SumsOfEights& sums);
  bool flow(const Particles& particles, const Family& family);
  double flow(std::size_t slot, const Particles& particles, const Family& family);
  void refresh_ghosts(const Particles& particles, const Family& family);
  void mark_ghosts(const Particles& particles, const Family& family);
  void find_resistance(const Particles& particles);
  void mark(std::size_t slot, const Family& family);
  void mark_affected(const Particles& particles, const Family& family);

  OrdinaryState law_;
  Plasticity plasticity_;
  ReturnModuli moduli_;
  double elastic_limit_;     // [J/m³] below it no particle can be outside of the surface
  double largest_pressure_;  // [Pa] p₂
  double tolerated_;         // [Pa] overshoot
  Breaking breaking_;        // the rule; it is evaluated under pressure, in plastic_kernels.hpp
  CorrectionFactors correction_;

  // of each bond of the stencil
  std::vector<Constants<double>> constants_;  // for each table of factors
  std::vector<Vec3d> half_squares_;
  std::vector<SymmetricTensor> projection_;  // n_x²/2 … n_x n_y …: ½ n·A·n of a tensor A

  // of each entry of the list
  fccda::AlignedVector<double> stretch_, dilatation_;  // [m⁵] with the factors of the surface correction
  VectorArray direction_;                              // n

  double half_limit_;             // [-] s_c/2 by bond strain
  std::vector<double> strength_;  // [-] of each slot; empty: 1 everywhere

  // of each slot
  TensorArray strain_;                        // ε^p
  TensorArray increment_;                     // the latest Δε^p, contained in ε^p
  TensorArray stress_;                        // [Pa] of packs that are hot
  ScalarArray equivalent_;                    // Σ √(2/3 Δε^p:Δε^p)
  ScalarArray pressure_, latest_pressure_;    // [Pa] of the pass before, and of this one
  ScalarArray pressure_slope_;                // [1/Pa] what the limit of a bond gains by each pressure of its two particles; half at each end
  ScalarArray resistance_;                    // [-] s_c k/2; 0 beyond ε_f
  ScalarArray theta_;                         // [-] elastic dilatation; empty where the material has none
  std::vector<std::uint8_t> has_failed_;      // beyond ε_f
  std::vector<std::uint8_t> is_known_ghost_;  // ghosts with plastic strain that is known here; empty where the body is whole

  // of each eight slots
  std::vector<std::uint8_t> is_plastic_;       // one of them, or one that is bonded to them, has plastic strain
  std::vector<std::uint8_t> is_hot_;           // bit l: the stress of slot l was computed in the last pass
  std::vector<std::uint8_t> affected_;         // by the last flow (mark_affected)
  std::vector<std::uint8_t> flows_;            // bit 0: particles flowed in the last flow; bit 1: in the one before
  std::vector<double> dissipation_, pending_;  // [J] to the last pass; half of the latest flow, which belongs to the next step
};

}  // namespace perimpact
