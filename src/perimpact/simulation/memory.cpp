#include "perimpact/simulation/memory.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "perimpact/family/stencil.hpp"
#include "perimpact/setup/setup_error.hpp"
#include "perimpact/simulation/body.hpp"

namespace perimpact {

namespace {

double bytes_of(const BodySetup& setup, std::size_t impactors) {
  const double slots = slots_of(setup);
  const bool is_plane = setup.plane.as<PlaneState>() != PlaneState::none;
  const Stencil stencil(setup.family.as<FamilyRule>(), setup.spacing, setup.horizon_ratio, is_plane ? std::optional(1.0) : std::nullopt);
  const SurfaceCorrection correction = setup.surface_correction.as<SurfaceCorrection>();
  const bool own_family = std::holds_alternative<LinearSolidSetup>(setup.material);
  const bool correspondence = std::holds_alternative<CorrespondenceSetup>(setup.material);
  // of the dilatation only the material knows, so the least is counted
  const double vectors = 3 + (!own_family && !correspondence && correction <= SurfaceCorrection::energy ? 2 : 0);
  const double scalars = 1 + (own_family || (!correspondence && correction == SurfaceCorrection::volume) ? 1 : 0) + (!correspondence ? 0 : is_plane ? 10 : 18);
  const double of_slot =
      sizeof(double) * (3 * vectors + scalars) + (correspondence ? 2 : 1) * static_cast<double>(stencil.size()) / 8 + 2 * sizeof(std::uint32_t);
  // a detector keeps a due distance and a guess for each slot
  return (of_slot + static_cast<double>(impactors * (sizeof(double) + sizeof(int)))) * slots;
}

}  // namespace

double physical_memory() { return static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE)); }

double memory_of(const Setup& setup) {
  double sum = 0;
  for (const BodySetup& body : setup.bodies) sum += bytes_of(body, setup.impactors.size());
  return sum;
}

void expect_to_fit(const Setup& setup, double available) {
  const double needed = memory_of(setup);
  if (!(needed > available)) return;
  const auto largest =
      std::max_element(setup.bodies.begin(), setup.bodies.end(), [](const BodySetup& a, const BodySetup& b) { return bytes_of(a, 0) < bytes_of(b, 0); });
  const std::string key = "bodies." + largest->name + ".spacing";
  if (!std::isfinite(needed))
    throw SetupError(key, fmt::format("a spacing of {} m fills body {} with more cells than can be counted; make it larger.", largest->spacing, largest->name));
  throw SetupError(key,
                   fmt::format("with a spacing of {} m for body {} the run needs {:.3g} GB of memory, but this machine has {:.3g} GB; take a spacing of at "
                               "least {:.2g} m, or a smaller body.",
                               largest->spacing, largest->name, needed / 1e9, available / 1e9, 1.05 * largest->spacing * std::cbrt(needed / available)));
}

}  // namespace perimpact
