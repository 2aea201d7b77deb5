#include "perimpact/simulation/body.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <limits>

#include "perimpact/force/stencil_sums.hpp"
#include "perimpact/particles/fill.hpp"
#include "perimpact/setup/setup_error.hpp"
#include "perimpact/simulation/memory.hpp"

namespace perimpact {

namespace {

bool is_plane(const BodySetup& setup) { return setup.plane.as<PlaneState>() != PlaneState::none; }

Stencil stencil_of(const BodySetup& setup) {
  const double thickness = std::get<BoxSolid>(setup.shape).size.z;
  return Stencil(setup.family.as<FamilyRule>(), setup.spacing, setup.horizon_ratio, is_plane(setup) ? std::optional(thickness) : std::nullopt);
}

/// Bonds that know nothing of one another fix Poisson's ratio.
double poissons_ratio_of(const BodySetup& setup) {
  if (!std::holds_alternative<BondBasedSetup>(setup.material)) return setup.elastic().poissons_ratio;
  return setup.plane.as<PlaneState>() == PlaneState::stress ? 1.0 / 3 : 0.25;
}

Influences influences_of(const BodySetup& setup) {
  const auto* solid = std::get_if<LinearSolidSetup>(&setup.material);
  return solid ? Influences{solid->influence.as<Influence>(), solid->influence.as<Influence>()} : madenci_oterkus_influences;
}

CorrectionKind correction_of(const BodySetup& setup) {
  if (std::holds_alternative<LinearSolidSetup>(setup.material)) return CorrectionKind::family;
  switch (setup.surface_correction.as<SurfaceCorrection>()) {
    case SurfaceCorrection::volume:
      return CorrectionKind::volume;
    case SurfaceCorrection::none:
      return CorrectionKind::none;
    default:
      return CorrectionKind::energy;
  }
}

/// Sums f(slot) over the particles, in rows, so that rounding does not grow with their number.
template <class Value, class F>
Value sum_over(const Particles& particles, Value total, const F& f) {
  constexpr std::size_t block = 256;
  const auto slots = particles.slot_of();
  for (std::size_t begin = 0; begin < slots.size(); begin += block) {
    Value part = f(slots[begin]);
    for (std::size_t i = begin + 1; i < std::min(begin + block, slots.size()); ++i) part += f(slots[i]);
    total += part;
  }
  return total;
}

}  // namespace

double slots_of(const BodySetup& setup) {
  const Vec3d& size = std::get<BoxSolid>(setup.shape).size;
  return std::ceil(size.x / setup.spacing / fccda::byte_lanes) * fccda::byte_lanes * (size.y / setup.spacing) * (is_plane(setup) ? 1 : size.z / setup.spacing);
}

IsotropicElastic elastic_of(const BodySetup& setup) {
  return IsotropicElastic::in(setup.plane.as<Plane>(), setup.elastic().youngs_modulus, poissons_ratio_of(setup));
}

Particles make_particles(const BodySetup& setup) {
  const int reach = stencil_of(setup).reach();
  const double density = setup.elastic().density;
  const BoxSolid& box = std::get<BoxSolid>(setup.shape);
  const double slots = slots_of(setup);
  constexpr double most = std::numeric_limits<std::uint32_t>::max();
  if (!(slots < most))
    throw SetupError("bodies." + setup.name + ".spacing",
                     fmt::format("a spacing of {} m takes {:.3g} cells to fill body {}, more than the {:.2g} that can be numbered; make it larger.",
                                 setup.spacing, slots, setup.name, most));
  Particles particles(lattice_of_box(box.size, setup.position, setup.spacing, is_plane(setup)), reach, density, [](const Vec3d&) { return true; });
  for (const std::uint32_t slot : particles.slot_of()) particles.velocity.set(slot, setup.velocity);
  return particles;
}

Body make_body(const BodySetup& setup, Particles particles) {
  const IsotropicElastic elastic = elastic_of(setup);
  const Influences influences = influences_of(setup);
  const double horizon = setup.horizon_ratio * particles.spacing();

  std::optional<FamilySums> lattice;
  std::optional<Family> family;
  if (particles.lattice()) {
    Stencil stencil = stencil_of(setup);
    if (setup.normalisation.as<Normalisation>() == Normalisation::lattice) lattice = sums_of(stencil, influences, elastic.poissons_ratio);
    family.emplace(std::move(stencil), particles);
  } else {
    family.emplace(find_bonds(setup.family.as<FamilyRule>(), horizon, particles), particles);
  }
  const OrdinaryState law(elastic, influences, horizon, particles.thickness().value_or(1), lattice);

  const auto failure = failure_criterion(setup, law, *family, particles);
  Breaking breaking;
  if (failure) breaking = Breaking(breaking_rule(setup.failure, *failure), strength_of(setup.failure, particles, {}), *family, particles);

  CorrectionFactors correction(correction_of(setup), basis_of(law), *family, particles);
  InternalForce internal(OrdinaryStateForce(law, std::move(breaking), std::move(correction), *family, particles), particles);
  return {setup.name, std::move(particles), std::move(*family), std::move(internal), failure};
}

Vec3d Body::momentum() const {
  return sum_over(particles, Vec3d{}, [&](std::size_t slot) { return particles.mass(slot) * particles.velocity.at(slot); });
}

double Body::kinetic_energy(double dt) const {
  const double half_kick = 0.5 * dt / particles.density();
  return 0.5 * sum_over(particles, 0.0, [&](std::size_t slot) {
           return particles.mass(slot) * fccda::squared_norm(particles.velocity.at(slot) + half_kick * particles.force_density.at(slot));
         });
}

double Body::memory() const {
  const double arrays = static_cast<double>(particles.slots() * 3 * sizeof(Vec3d) + particles.size() * sizeof(std::uint32_t));
  return arrays + family.bytes() + internal.bytes();
}

}  // namespace perimpact
