#include "perimpact/simulation/body.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <limits>

#include "perimpact/particles/fill.hpp"
#include "perimpact/setup/setup_error.hpp"
#include "perimpact/simulation/memory.hpp"

namespace perimpact {

namespace {

Stencil stencil_of(const BodySetup& setup) { return Stencil(setup.family.as<FamilyRule>(), setup.spacing, setup.horizon_ratio); }

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
  return std::ceil(size.x / setup.spacing / fccda::byte_lanes) * fccda::byte_lanes * (size.y / setup.spacing) * (size.z / setup.spacing);
}

Particles make_particles(const BodySetup& setup) {
  const int reach = stencil_of(setup).reach();
  const double density = std::get<OrdinaryStateSetup>(setup.material).density;
  const BoxSolid& box = std::get<BoxSolid>(setup.shape);
  const double slots = slots_of(setup);
  constexpr double most = std::numeric_limits<std::uint32_t>::max();
  if (!(slots < most))
    throw SetupError("bodies." + setup.name + ".spacing",
                     fmt::format("a spacing of {} m takes {:.3g} cells to fill body {}, more than the {:.2g} that can be numbered; make it larger.",
                                 setup.spacing, slots, setup.name, most));
  Particles particles(lattice_of_box(box.size, setup.position, setup.spacing), reach, density, [](const Vec3d&) { return true; });
  for (const std::uint32_t slot : particles.slot_of()) particles.velocity.set(slot, setup.velocity);
  return particles;
}

Body make_body(const BodySetup& setup, Particles particles) {
  const OrdinaryStateSetup& material = std::get<OrdinaryStateSetup>(setup.material);
  Stencil stencil = stencil_of(setup);

  std::optional<LatticeSums> lattice;
  if (setup.normalisation.as<Normalisation>() == Normalisation::lattice) {
    const StencilSums sums = stencil.sums(material.poissons_ratio);
    lattice = LatticeSums{sums.dilatation, sums.energy};
  }
  const OrdinaryState law({material.youngs_modulus, material.poissons_ratio}, stencil.horizon(), lattice);

  std::optional<CriticalStretch> breaking;
  if (material.critical_stretch) breaking = CriticalStretch(*material.critical_stretch);

  LatticeFamily family(std::move(stencil), particles);
  CorrectionFactors correction(setup.surface_correction.as<SurfaceCorrection>(), material.poissons_ratio, family, particles);
  InternalForce internal(law, breaking, std::move(correction), family, particles);
  return {setup.name, std::move(particles), std::move(family), std::move(internal)};
}

Vec3d Body::momentum() const {
  return particles.mass() * sum_over(particles, Vec3d{}, [&](std::size_t slot) { return particles.velocity.at(slot); });
}

double Body::kinetic_energy(double dt) const {
  const double half_kick = 0.5 * dt / particles.density();
  return 0.5 * particles.mass() * sum_over(particles, 0.0, [&](std::size_t slot) {
           return fccda::squared_norm(particles.velocity.at(slot) + half_kick * particles.force_density.at(slot));
         });
}

double Body::memory() const {
  return BodyArrays{static_cast<double>(particles.lattice().slots()), static_cast<double>(family.stencil().size()), internal.correction().kind(),
                    internal.material().needs_dilatation()}
      .bytes();
}

}  // namespace perimpact
