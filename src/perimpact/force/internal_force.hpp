/// What the bonds of a body do to its particles: one pass over all bonds (two where the material has a dilatation).
#pragma once

#include <optional>
#include <vector>

#include "perimpact/damage/critical_stretch.hpp"
#include "perimpact/family/lattice_family.hpp"
#include "perimpact/family/surface_correction.hpp"
#include "perimpact/material/ordinary_state.hpp"

namespace perimpact {

class InternalForce {
 public:
  InternalForce(OrdinaryState material, const std::optional<CriticalStretch>& breaking, CorrectionFactors correction, const LatticeFamily& family,
                const Particles& particles);

  /// Writes particles.force_density [N/m³], the sum over intact bonds at the current positions, in stencil order for each particle,
  /// so that the result is the same to the last bit for any number of threads. Bonds that are too long break on the way.
  void evaluate(Particles& particles, LatticeFamily& family);

  /// The same, and returns the elastic energy at these positions [J].
  double evaluate_with_energy(Particles& particles, LatticeFamily& family);

  /// The same as evaluate(), one particle at a time: the oracle of the tests.
  void evaluate_scalar(Particles& particles, LatticeFamily& family);

  std::size_t broken_bonds() const;  ///< since construction, each counted once

  const OrdinaryState& material() const { return material_; }
  const CorrectionFactors& correction() const { return correction_; }
  std::span<const Vec3d> half_squares() const { return half_squares_; }
  const ScalarArray& dilatation() const { return theta_; }  ///< θ [-] of the last evaluation; empty where the material needs none

  template <class Visitor>
  void visit_state(const std::string& name, Visitor&& visit) {
    visit(name + ".broken_ends_of_row", std::span<std::size_t>(broken_ends_of_row_));
  }

 private:
  template <class Pack>
  void pass(Particles& particles, LatticeFamily& family, bool with_energy);
  double sum_of_rows(const Particles& particles) const;

  OrdinaryState material_;
  bool breaking_;
  CorrectionFactors correction_;
  std::vector<OrdinaryState::Folded> folded_;  // of each stencil bond
  std::vector<double> squared_limits_;         // [m²] of each stencil bond
  std::vector<Vec3d> half_squares_;            // of each stencil bond
  ScalarArray theta_;
  std::vector<double> energy_of_row_;  // [J/m³] summed over a row
  std::vector<std::size_t> broken_ends_of_row_;
};

}  // namespace perimpact
