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
  const Stencil stencil(setup.family.as<FamilyRule>(), setup.spacing, setup.horizon_ratio);
  // of the dilatation only the material knows, so the least is counted; a detector keeps a due distance and a guess for each slot
  const BodyArrays arrays{slots, static_cast<double>(stencil.size()), setup.surface_correction.as<SurfaceCorrection>(), false};
  return arrays.bytes() + static_cast<double>(impactors * (sizeof(double) + sizeof(int))) * slots;
}

}  // namespace

double BodyArrays::bytes() const {
  const double vectors = 3 + (correction == SurfaceCorrection::energy ? 2 : 0);
  const double scalars = 1 + (correction == SurfaceCorrection::volume ? 1 : 0) + (needs_dilatation ? 1 : 0);
  return slots * (sizeof(double) * (3 * vectors + scalars) + stencil_bonds / 8 + sizeof(std::uint32_t));
}

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
