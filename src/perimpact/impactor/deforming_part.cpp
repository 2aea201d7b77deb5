#include "perimpact/impactor/deforming_part.hpp"

#include <algorithm>
#include <cmath>

namespace perimpact {

using namespace fccda;

DeformingPart::DeformingPart(AnyStructure structure, const Surface& surface, std::span<const Vec3d> vertices, std::span<const double> radii)
    : structure_(std::move(structure)), surface_(std::make_shared<DeformingSurface>(surface)) {
  surface_->place(vertices);
  std::visit([&](auto& one) { coupling_ = std::make_unique<StructureCoupling>(*one, *surface_); }, structure_);
  coupling_->start_at(vertices);
  for (const double radius : radii) detectors_.emplace_back(surface_, radius);
}

const ElasticBody* DeformingPart::elastic() const {
  const auto* body = std::get_if<std::unique_ptr<ElasticBody>>(&structure_);
  return body ? body->get() : nullptr;
}

const ExternalStructure* DeformingPart::external() const {
  const auto* structure = std::get_if<std::unique_ptr<ExternalStructure>>(&structure_);
  return structure ? structure->get() : nullptr;
}

double DeformingPart::kinetic_energy() const { return elastic() ? elastic()->kinetic_energy() : 0; }
double DeformingPart::kinetic_energy_of_scheme() const { return elastic() ? elastic()->kinetic_energy_of_scheme() : 0; }
double DeformingPart::elastic_energy() const { return elastic() ? elastic()->elastic_energy() : 0; }
double DeformingPart::damping_dissipation() const { return elastic() ? elastic()->damping_dissipation() : 0; }

double DeformingPart::largest_deflection() const {
  double largest = 0;
  if (const ElasticBody* body = elastic())
    for (std::size_t v = 0; v < body->vertex_count(); ++v) largest = std::max(largest, squared_norm(body->deflection(v)));
  return std::sqrt(largest);
}

// After a restart the surface is where the structure is; otherwise it is there already.
void DeformingPart::follow(const ElasticBody& body) {
  std::vector<Vec3d> vertices(body.vertex_count());
  body.place(vertices);
  if (std::ranges::equal(vertices, coupling_->vertices())) return;
  surface_->place(vertices);
  coupling_->start_at(vertices);
}

}  // namespace perimpact
