/// What an impactor has besides its rigid body if its surface deforms: structure, surface, coupling and a detector for each deformable body.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "fccda/deforming/deforming.hpp"
#include "fccda/elastic/elastic_body.hpp"
#include "fccda/elastic/external_structure.hpp"
#include "fccda/elastic/structure_coupling.hpp"
#include "perimpact/particles/shared_numbers.hpp"

namespace perimpact {

using fccda::Vec3d;

class DeformingPart {
 public:
  using AnyStructure = std::variant<std::unique_ptr<fccda::ElasticBody>, std::unique_ptr<fccda::ExternalStructure>>;

  /// `surface` in the body frame; `vertices` [m] in the world frame at t = 0; `radii` [m]: contact radius of each body's particles.
  DeformingPart(AnyStructure structure, const fccda::Surface& surface, std::span<const Vec3d> vertices, std::span<const double> radii);

  /// Null if another program advances the structure.
  const fccda::ElasticBody* elastic() const;
  /// Null if it has modes.
  const fccda::ExternalStructure* external() const;

  fccda::StructureCoupling& iteration() { return *coupling_; }  ///< of the step in progress
  fccda::Deforming& detector(std::size_t body) { return detectors_[body]; }
  const fccda::Deforming& detector(std::size_t body) const { return detectors_[body]; }
  std::vector<fccda::DeformingContact>& contacts() { return contacts_; }  ///< of the latest detection

  std::span<const Vec3d> vertices() const { return coupling_->vertices(); }  ///< [m] of the panels, in the world frame, at the end of the last step

  double kinetic_energy() const;            ///< [J] of vibration at the end of the last step, with half of the impulse of the last step
  double kinetic_energy_of_scheme() const;  ///< [J] without it
  double elastic_energy() const;            ///< [J]
  double damping_dissipation() const;       ///< [J] cumulative
  double largest_deflection() const;        ///< [m] of a vertex; 0 without modes

  /// See base/state.hpp.
  template <class Visitor>
  void visit_state(Visitor&& visit) {
    if (const auto* modes = std::get_if<std::unique_ptr<fccda::ElasticBody>>(&structure_)) (*modes)->visit_state(visit), follow(**modes);
    for (std::size_t b = 0; b < detectors_.size(); ++b) {
      const auto its = fccda::under(std::to_string(b) + ".deforming", visit);
      detectors_[b].visit_state(of_detector(b, its));
    }
  }
  template <class Visitor>
  void visit_record(Visitor&& visit) {
    for (std::size_t b = 0; b < detectors_.size(); ++b) {
      const auto its = fccda::under(std::to_string(b) + ".deforming", visit);
      detectors_[b].visit_record(of_counts(its));
    }
  }

 private:
  void follow(const fccda::ElasticBody& body);

  AnyStructure structure_;
  std::shared_ptr<fccda::DeformingSurface> surface_;
  std::unique_ptr<fccda::StructureCoupling> coupling_;
  std::vector<fccda::Deforming> detectors_;
  std::vector<fccda::DeformingContact> contacts_;
};

}  // namespace perimpact
