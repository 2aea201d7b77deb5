#include "perimpact/simulation/memory.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <cstdint>

#include "perimpact/family/stencil.hpp"
#include "perimpact/material/correspondence.hpp"
#include "perimpact/setup/setup_error.hpp"

namespace perimpact {

namespace {

/// Doubles that CorrespondenceForce keeps of each slot.
double numbers_of_gradients(const BodySetup& setup, const CorrespondenceSetup& material) {
  const int dimension = setup.is_plane() ? 2 : 3, square = dimension * dimension;
  const bool breaks = material.critical_stretch || material.fracture_energy || material.flexural_strength;
  const int bond_level = material.stabilisation.as<Stabilisation>() == Stabilisation::bond_level ? square * (breaks ? 3 : 2) : 0;
  return dimension * (dimension + 1) / 2 + 3 + square + 1 + bond_level;
}

double bytes_of(const BodySetup& setup, const Discretisation& discretisation, std::size_t impactors) {
  const bool is_list = std::holds_alternative<Cloud>(discretisation);
  const Stencil stencil(setup.family.as<FamilyRule>(), setup.spacing.value_or(1), setup.horizon_ratio, setup.is_plane() ? std::optional(1.0) : std::nullopt);
  const SurfaceCorrection correction = setup.surface_correction.as<SurfaceCorrection>();
  const bool own_family = std::holds_alternative<LinearSolidSetup>(setup.material);
  const auto* of_gradients = std::get_if<CorrespondenceSetup>(&setup.material);
  const bool correspondence = of_gradients != nullptr;
  // of the dilatation only the material knows, so the least is counted
  const double vectors = 3 + (!own_family && !correspondence && correction <= SurfaceCorrection::energy ? 2 : 0);
  const double scalars = 1 + (own_family || (!correspondence && correction == SurfaceCorrection::volume) ? 1 : 0) +
                         (of_gradients ? numbers_of_gradients(setup, *of_gradients) : 0) + (correspondence && is_list ? 3 : 0);
  const double of_bond =
      1.0 / 8 + (correspondence ? 1.0 / 8 + (is_list ? sizeof(double) : 0) : 0) + (is_list ? 1.0 / 8 + sizeof(std::int32_t) + 2 * sizeof(double) : 0);
  const double of_place = is_list ? 2 * sizeof(Vec3d) + sizeof(double) + sizeof(std::uint32_t) : 0;
  const double of_slot = sizeof(double) * (3 * vectors + scalars) + static_cast<double>(stencil.size()) * of_bond + 2 * sizeof(std::uint32_t) + of_place;
  // a detector keeps a due distance and a guess for each slot
  return (of_slot + static_cast<double>(impactors * (sizeof(double) + sizeof(int)))) * slots_of(setup, discretisation);
}

}  // namespace

double physical_memory() { return static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE)); }

double memory_of(const Setup& setup, std::span<const Discretisation> bodies) {
  double sum = 0;
  for (std::size_t b = 0; b < bodies.size(); ++b) sum += bytes_of(setup.bodies[b], bodies[b], setup.impactors.size());
  return sum;
}

void expect_to_fit(const Setup& setup, std::span<const Discretisation> bodies, double available) {
  const double needed = memory_of(setup, bodies);
  if (!(needed > available)) return;
  std::size_t largest = 0;
  for (std::size_t b = 1; b < bodies.size(); ++b)
    if (bytes_of(setup.bodies[b], bodies[b], 0) > bytes_of(setup.bodies[largest], bodies[largest], 0)) largest = b;
  const BodySetup& body = setup.bodies[largest];
  if (!body.spacing)
    throw SetupError(
        "bodies." + body.name + ".shape",
        fmt::format("with {:.3g} particles of body {} the run needs {:.3g} GB of memory, but this machine has {:.3g} GB; take fewer and larger ones.",
                    slots_of(body, bodies[largest]), body.name, needed / 1e9, available / 1e9));
  const std::string key = "bodies." + body.name + ".spacing";
  if (!std::isfinite(needed))
    throw SetupError(key, fmt::format("a spacing of {} m fills body {} with more cells than can be counted; make it larger.", *body.spacing, body.name));
  throw SetupError(key,
                   fmt::format("with a spacing of {} m for body {} the run needs {:.3g} GB of memory, but this machine has {:.3g} GB; take a spacing of at "
                               "least {:.2g} m, or a smaller body.",
                               *body.spacing, body.name, needed / 1e9, available / 1e9, 1.05 * *body.spacing * std::cbrt(needed / available)));
}

}  // namespace perimpact
