#include "perimpact/body/body.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "perimpact/body/bending.hpp"
#include "perimpact/deck_model/setup_error.hpp"
#include "perimpact/discretisation/particle_set.hpp"
#include "perimpact/materials/ordinary_state/stencil_sums.hpp"
#include "perimpact/particles/sum_over_eights.hpp"

namespace perimpact {

namespace {

Stencil stencil_of(const BodySetup& setup, const Lattice& lattice) {
  return Stencil(setup.family.as<FamilyRule>(), lattice.spacing, setup.horizon_ratio, lattice.thickness);
}

int layers_along(std::size_t axis, const Particles& particles) { return static_cast<int>(std::lround(extent(particles)[axis] / particles.spacing())); }

/// Share of this rank in the lattice of a body.
Share share_of(const BodySetup& setup, const BodySolid& solid, Ranks& ranks, int first_rank, const MeasuredLoad& load) {
  const Lattice lattice = lattice_that_fills(setup, solid);
  return Share(ranks, lattice, partition_rule_of(setup, lattice, load), first_rank);
}

Density density_of(const BodySetup& setup) { return {setup.elastic().density, setup.mass_scaling}; }

/// Particles of this rank in a cloud.
Particles particles_of(const BodySetup& setup, const Cloud& cloud, Ranks& ranks, int first_rank, const MeasuredLoad& load) {
  const Density density = density_of(setup);
  if (ranks.size() == 1) return Particles(cloud, density);
  return Particles(cloud, density, Share(ranks, parts_of(setup, cloud, ranks.size(), first_rank, load).of(ranks.rank())));
}

/// One particle in each cell of the lattice whose centre is inside the solid.
Particles filled(const BodySetup& setup, const BodySolid& solid, Share share) {
  const Lattice lattice = share.is_whole() ? lattice_that_fills(setup, solid) : share.lattice();
  const std::vector<std::uint8_t> inside = cells_inside(lattice, solid);
  if (!share.ranks().any(std::find(inside.begin(), inside.end(), 1) != inside.end()))
    throw SetupError("bodies." + setup.name + ".spacing",
                     fmt::format("no particle of a lattice of {} m is inside body {}; take a smaller spacing, or check the units of its shape and holes.",
                                 lattice.spacing, setup.name));
  return Particles(lattice, stencil_of(setup, lattice).reach(), density_of(setup), inside, std::move(share));
}

Particles with_velocity(const BodySetup& setup, Particles particles) {
  for (const std::uint32_t slot : particles.slot_of()) particles.velocity.set(slot, setup.velocity);
  return particles;
}

Influences influences_of(const BodySetup& setup) {
  return with_material(setup, [](const auto& its, auto kind) { return kind.influences(its); });
}

CorrectionKind correction_of(const BodySetup& setup) {
  return with_material(setup, [&](const auto&, auto kind) { return kind.correction(setup); });
}

constexpr int most_layers_that_bend = 40;  // beyond, the deficit is below 1 %

double relative_bending_stiffness(const BodySetup& setup, std::size_t axis, int layers) {
  const IsotropicElastic elastic = elastic_of(setup);
  const std::optional<double> thickness = setup.is_plane() ? std::optional(1.0) : std::nullopt;  // cancels
  const ThinLattice plate{*setup.spacing, thickness, axis, layers};
  const Stencil stencil(setup.family.as<FamilyRule>(), plate.spacing, setup.horizon_ratio, thickness);
  std::optional<FamilySums> sums;
  if (setup.normalisation.as<Normalisation>() == Normalisation::lattice) sums = sums_of(stencil, influences_of(setup), elastic.poissons_ratio);
  const OrdinaryState law(elastic, influences_of(setup), stencil.horizon(), thickness.value_or(1), sums);
  return perimpact::relative_bending_stiffness(plate, law, correction_of(setup), stencil);
}

std::vector<std::size_t> never_failing(const BodySetup& setup, const Particles& particles) {
  std::vector<std::size_t> slots;
  if (!setup.failure) return slots;
  for (const std::string& region : setup.failure->no_fail) {
    const auto more = slots_in(region, setup, particles, "bodies." + setup.name + ".failure.no_fail");
    slots.insert(slots.end(), more.begin(), more.end());
  }
  return slots;
}

}  // namespace

double bending_calibration(const BodySetup& setup, int layers) {
  const std::size_t axis = axis_of_calibration(setup);
  const auto refuse = [&](const std::string& reason) { throw SetupError("bodies." + setup.name + ".bending_calibration", reason); };
  if (layers < 2 || layers > most_layers_that_bend)
    refuse(fmt::format("body {} has {} layers of particles along {}, but bending_calibration is for plates of 2 to {} layers; {}.", setup.name, layers,
                       setup.bending_calibration.word(), most_layers_that_bend,
                       layers < 2 ? "take a smaller spacing" : "remove it, or name the thin direction"));
  const double relative = relative_bending_stiffness(setup, axis, layers);
  constexpr double least = 0.2;  // two layers have 0.11
  if (relative < least)
    refuse(fmt::format("{} layers of body {} have only {:.2g} of the bending stiffness of a plate, too little for calibration; use three layers or more.",
                       layers, setup.name, relative));
  return 1 / relative;
}

std::optional<BendingOfLayers> bending_of_thin(const BodySetup& setup, const Particles& particles) {
  const bool has_bonds = with_material(setup, [](const auto&, auto kind) { return kind.has_bonds; });
  if (!particles.lattice() || !has_bonds) return {};
  const Vec3d size = extent(particles);
  std::size_t thin = 0;
  for (std::size_t axis = 1; axis < (particles.is_plane() ? 2u : 3u); ++axis)
    if (size[axis] < size[thin]) thin = axis;
  double next = std::numeric_limits<double>::infinity();
  for (std::size_t axis = 0; axis < (particles.is_plane() ? 2u : 3u); ++axis)
    if (axis != thin) next = std::min(next, size[axis]);
  constexpr double slender = 4;  // less slender bodies hardly bend
  const int layers = layers_along(thin, particles);
  if (layers < 2 || layers > most_layers_that_bend || next < slender * size[thin]) return {};
  return BendingOfLayers{thin, layers, relative_bending_stiffness(setup, thin, layers)};
}

PartitionRule partition_rule_of(const BodySetup& setup, const Lattice& whole, const MeasuredLoad& load) {
  const bool floats = std::ranges::any_of(setup.boundary_conditions, [](const auto& one) { return std::holds_alternative<FloatingSetup>(one.kind); });
  return {whole.cells, stencil_of(setup, whole).reach(), floats, load};
}

CloudParts parts_of(const BodySetup& setup, const Cloud& cloud, int ranks, int first_rank, const MeasuredLoad& load) {
  const std::size_t eights = fccda::eights_of(cloud.points.size());
  return {cloud, largest_reach(setup.family.as<FamilyRule>(), setup.horizon_ratio, cloud), CloudPartition(eights, ranks, first_rank, load)};
}

IsotropicElastic elastic_of(const BodySetup& setup) {
  const std::optional<double> modulus = setup.elastic().youngs_modulus;
  if (!modulus) throw SetupError("bodies." + setup.name + ".material.youngs_modulus", fmt::format("body {} has no Young's modulus; give it.", setup.name));
  const Plane plane = setup.plane.as<Plane>();
  return IsotropicElastic::in(plane, *modulus, std::visit([&](const auto& material) { return material.poissons_ratio_in(plane); }, setup.material));
}

Particles make_particles(const BodySetup& setup, const Discretisation& discretisation, Ranks& ranks, int first_rank, const MeasuredLoad& load) {
  if (const auto* cloud = std::get_if<Cloud>(&discretisation)) return with_velocity(setup, particles_of(setup, *cloud, ranks, first_rank, load));
  const BodySolid& solid = std::get<BodySolid>(discretisation);
  return with_velocity(setup, filled(setup, solid, share_of(setup, solid, ranks, first_rank, load)));
}

Particles make_particles(const BodySetup& setup, Share share) { return with_velocity(setup, filled(setup, BodySolid(setup), std::move(share))); }

Body make_body(const BodySetup& setup, Particles particles, fccda::Stages& stages) {
  stages.begin("bonds", setup.name);
  IsotropicElastic elastic = elastic_of(setup);
  const Influences influences = influences_of(setup);
  const double horizon = setup.horizon_ratio * particles.spacing();

  std::optional<FamilySums> lattice;
  std::optional<Family> family;
  if (particles.lattice()) {
    Stencil stencil = stencil_of(setup, *particles.lattice());
    if (setup.normalisation.as<Normalisation>() == Normalisation::lattice) lattice = sums_of(stencil, influences, elastic.poissons_ratio);
    family.emplace(std::move(stencil), particles);
  } else {
    family.emplace(find_bonds(setup.family.as<FamilyRule>(), horizon, particles), particles);
  }
  std::optional<double> bending;
  if (setup.bending_calibration.as<ThinAxis>() != ThinAxis::none)
    elastic.youngs_modulus *= bending.emplace(bending_calibration(setup, layers_along(axis_of_calibration(setup), particles)));
  const OrdinaryState law(elastic, influences, horizon, particles.thickness().value_or(1), lattice);

  stages.begin("surface correction", setup.name);
  const auto failure = failure_criterion(setup, law, *family, particles);
  const MaterialParts parts{.body = setup,
                            .elastic = elastic,
                            .linear_law = law,
                            .correction = correction_of(setup),
                            .particles = particles,
                            .family = *family,
                            .rule = failure ? std::optional(breaking_rule(setup.failure, *failure)) : std::nullopt,
                            .strength = strength_of(setup.failure, particles, never_failing(setup, particles))};
  InternalForce::Kind force = with_material(
      setup, [&](const auto& its, auto kind) { return std::visit([](auto one) { return InternalForce::Kind(std::move(one)); }, kind.make_force(its, parts)); });
  InternalForce internal(std::move(force), particles);
  stages.begin("initial cracks", setup.name);
  std::vector<CrackCut> cracks = cut_first_cracks(setup, particles, *family);  // after the force: initial cracks act as cracks that grow
  stages.end();
  return {setup.name, std::move(particles), std::move(*family), std::move(internal), failure, std::move(cracks), bending};
}

MotionSums Body::motion(double dt) const {
  const double kick = dt / particles.density();
  return exact_sum_over_eights(
      particles, [&](std::size_t slot) { return motion_of(particles.mass(slot), particles.velocity.at(slot), kick * particles.force_density.at(slot)); });
}

double Body::memory() const {
  const double arrays = static_cast<double>(particles.slots() * 3 * sizeof(Vec3d) + particles.size() * sizeof(std::uint32_t));
  return arrays + family.bytes() + internal.bytes();
}

}  // namespace perimpact
