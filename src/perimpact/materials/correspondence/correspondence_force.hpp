/// Forces of a correspondence material: a first pass over all bonds for deformation gradients and bond failure, and a last pass for the forces. The
/// stabilisation bond-level has two passes between: one for F¹ and its stress, and its transpose, which maps this stress to the gradients F that
/// F¹ depends on.
///
/// K⁻¹, χ and the spring bound change only with the bonds. They are cached together with a copy of the bonds; a pass that finds other bonds recomputes
/// them, whatever the cause: this pass, a crack, or a checkpoint. They are therefore no part of the state.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "perimpact/damage/breaking.hpp"
#include "perimpact/family/family.hpp"
#include "perimpact/force/pass.hpp"
#include "perimpact/materials/correspondence/body_view.hpp"
#include "perimpact/materials/correspondence/correspondence.hpp"

namespace perimpact {

template <std::size_t D>
class CorrespondenceForce {
 public:
  static constexpr std::size_t symmetric = D * (D + 1) / 2, loads = D * D + 1;

  /// D: 2 for 2-D particles, else 3.
  CorrespondenceForce(const Correspondence& law, Breaking breaking, Family& family, const Particles& particles);

  /// Writes particles.force_density and the sums of the eights.
  template <class Pack>
  void pass(Particles& particles, Family& family, const PassOptions& options, SumsOfEights& sums);

  /// The view of a lattice with these bonds, and with copies of those for which K⁻¹ was computed: for a device.
  template <class Bonds>
  correspondence::BodyView<D, Bonds, correspondence::StencilShapes> view_of_lattice(Particles& particles, const Bonds& bonds, const Bonds& known, double dt) {
    return view(particles.view(), particles.force_density.writable_pointers(), bonds, known, stencil_shapes(), dt);
  }
  /// Calls visit(span) for each array of this object that the view of a lattice refers to, but for bonds and `broken`.
  template <class Visit>
  void visit_arrays(const Visit& visit) const {
    visit(shape_.with_slack()), visit(std::span(bound_at_first_)), visit(response_.with_slack());
    visit(gradient_.with_slack()), visit(carried_.with_slack()), visit(rate_.with_slack());
    visit(std::span(bonds_)), visit(std::span(weighted_volume_));
    breaking_.visit_arrays(visit);
  }

  const Breaking& breaking() const { return breaking_; }
  const Correspondence& law() const { return law_; }
  /// Inverse shape tensor K⁻¹ [1/m⁵] as of construction or the last pass; 0 if the family has no gradient.
  SmallMatrix<double, D> inverse_shape(std::size_t slot) const;
  /// χ [-]: fraction of the stress left by damage, as of construction or the last pass; 0 without a gradient.
  double remaining(std::size_t slot) const { return shape_.component(symmetric)[slot]; }
  /// [N/m⁷] upper bound on the stiffness of a bond, as an isotropic spring (Correspondence::spring_bound); as of construction or the last pass.
  double bond_stiffness(std::size_t slot, const FamilyBond& bond) const {
    const double* bound = shape_.component(symmetric + 1);
    return law_.weight(bond.length) * (bound[slot] + bound[bond.j]);
  }
  double bytes() const;           ///< [bytes] of memory
  StepMessages messages() const;  ///< of a pass in which no bond breaks

 private:
  using Vectors = std::array<double*, 3>;
  template <class Bonds, class Shapes>
  correspondence::BodyView<D, Bonds, Shapes> view(const ParticlesView& particles, const Vectors& force, const Bonds& bonds, const Bonds& known,
                                                  const Shapes& shapes, double dt);
  correspondence::StencilShapes stencil_shapes() const { return {bonds_.data(), weighted_volume_.data()}; }
  /// Calls visit(view) with that of a lattice, or of a list.
  template <class Visit>
  void with_view(const ParticlesView& particles, const Vectors& force, Family& family, double dt, const Visit& visit);
  template <class Pack, class View>
  void bond_level_pass(const View& body, Particles& particles, Family& family, const PassOptions& options, SumsOfEights& sums);
  /// Adds the elastic energy released by bond failure in this pass, and recomputes K⁻¹, χ and F of the particles affected.
  template <class Pack, class View>
  void account_for_broken(const View& body, const Particles& particles, const Family& family, SumsOfEights& sums);

  Correspondence law_;
  Breaking breaking_;
  std::vector<std::uint8_t> known_;     // copy of the bonds for which K⁻¹ was computed
  SlotArray<symmetric + 2> shape_;      // [1/m⁵] K⁻¹: its upper triangle by rows; then χ; then χ times the spring bound [N/m⁷]
  std::vector<double> bound_at_first_;  // [N/m⁷] spring bound of each particle
  SlotArray<loads> response_;           // [N/m⁷] B by rows, then c

  // for the stabilisation bond-level
  SlotArray<D * D> gradient_;         // [-] F by rows
  SlotArray<D * D> carried_;          // [Pa/m⁵] Q = χ P K⁻¹, the stress mapped to the gradients of neighbours
  SlotArray<D * D> rate_;             // [1/s] dF/dt of particles near broken bonds; only if bonds may break
  std::vector<std::uint8_t> broken_;  // of each eight slots: Nearness to bonds that broke in this pass

  // of each bond of the stencil
  std::vector<Vec3d> bonds_;             // [m] ξ
  std::vector<double> weighted_volume_;  // [m³] ω v V

  // of a list
  VectorArray reference_;                                      // [m] X
  fccda::UninitialisedVector<double> listed_weighted_volume_;  // [m³] ω v V of each entry
};

template <std::size_t D>
template <class Bonds, class Shapes>
correspondence::BodyView<D, Bonds, Shapes> CorrespondenceForce<D>::view(const ParticlesView& particles, const Vectors& force, const Bonds& bonds,
                                                                        const Bonds& known, const Shapes& shapes, double dt) {
  correspondence::BodyView<D, Bonds, Shapes> body{
      particles, bonds, known,          shapes, law_, shape_.writable_pointers(), bound_at_first_.data(), response_.writable_pointers(), {},
      {},        {},    broken_.data(), force,  dt};
  if (gradient_.slots() != 0) body.gradient = gradient_.writable_pointers(), body.carried = carried_.writable_pointers();
  if (rate_.slots() != 0) body.rate = rate_.writable_pointers();
  return body;
}

}  // namespace perimpact
