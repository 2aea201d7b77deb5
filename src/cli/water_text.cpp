#include "cli/water_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <variant>

#include "perimpact/boundary_conditions/floating/floating_sheet.hpp"

namespace perimpact {

std::string water_text(const Simulation& simulation, std::size_t body) {
  const Body& its = simulation.bodies()[body];
  const Vec3d size = extent(its.particles);
  if (!its.particles.lattice() || size.z >= std::min(size.x, size.y)) return "";
  std::string text;
  for (const NamedBoundaryCondition& one : simulation.boundary_conditions()[body].all()) {
    const auto* floating = std::get_if<Floating>(&one.boundary);
    if (!floating) continue;
    const Water& water = floating->water();
    const double length = characteristic_length(elastic_of(simulation.setup().bodies[body]), size.z, water.density * water.gravity);
    text += fmt::format("  {:<18}characteristic length l = {:.4g} m; entrained depth of a bending wave of wavenumber k: 1/k, of a patch of radius R: 0.64 R",
                        "water", length);
    text += water.entrained_depth > 0 ? fmt::format("; given: {:.4g} m\n", water.entrained_depth) : "\n";
  }
  return text;
}

}  // namespace perimpact
