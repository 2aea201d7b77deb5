#include "perimpact/diagnostics/setup_warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "perimpact/diagnostics/diagnosis.hpp"
#include "perimpact/impactor/rigid_body_of.hpp"

namespace perimpact {

namespace {

/// A bond reaches three particles: thinner bodies consist of surface only, beyond any correction.
void warn_of_thin_bodies(std::span<const Body> bodies, std::vector<std::string>& warnings) {
  constexpr int enough = 4;
  for (const Body& body : bodies) {
    if (!body.particles.lattice() || body.bending) continue;  // calibrated in bending
    const auto& cells = body.particles.lattice()->cells;
    const int thinnest = *std::min_element(cells.begin(), cells.end() - (body.particles.is_plane() ? 1 : 0));
    if (thinnest < enough)
      warnings.push_back(
          fmt::format("Body {} is only {} particles thick, which makes its stiffness inaccurate, especially in bending. Use a spacing that gives at least {} "
                      "layers, preferably 6.",
                      body.name, thinnest, enough));
  }
}

/// The heaviest solid, osmium, has 22 590 kg/m3: a density in g/cm3 or t/mm3 without its unit is below 23, unlike one in kg/m3.
void warn_of_density(std::string_view of, double density, std::vector<std::string>& warnings) {
  constexpr double lightest = 23, heaviest = 23000;  // [kg/m3]
  if (density >= lightest && density <= heaviest) return;
  warnings.push_back(fmt::format(
      "The density of {} is {:.4g} kg/m3, but solids have {:g} to {:g} kg/m3. If it is in another unit, append the unit, as in 7.8 g/cm3 or 7.8e-9 t/mm3.", of,
      density, lightest, heaviest));
}

/// Staircase surfaces, and features thinner than the spacing.
void warn_of_mass(const std::string& body, const std::optional<FilledMass>& mass, std::vector<std::string>& warnings) {
  constexpr double much = 0.05;
  if (!mass || std::fabs(mass->excess()) <= much) return;
  warnings.push_back(fmt::format(
      "The mass of the particles of body {} is {:.4g} kg, {:+.1f} % relative to its solid of {:.4g} kg: the lattice is too coarse. Use a smaller spacing.",
      body, mass->particles, 100 * mass->excess(), mass->solid));
}

void warn_of_loose_particles(const Body& body, std::vector<std::string>& warnings) {
  std::size_t loose = 0;
  for (const std::uint32_t slot : body.particles.slot_of()) loose += body.family.initial_volume(slot) > 0 ? 0 : 1;
  if (loose > 0)
    warnings.push_back(
        fmt::format("{} particles of body {} have no bonds, because the solid is too thin there or they are too far apart, and are unconstrained. Use a "
                    "smaller spacing, or a larger horizon_ratio.",
                    loose, body.name));
}

void warn_of_overlaps(const Setup& setup, std::span<const Impactor> impactors, std::vector<std::string>& warnings) {
  for (std::size_t i = 0; i < impactors.size(); ++i) {
    const fccda::Surface& surface = impactors[i].surface();
    const std::size_t count = surface.report().may_overlap;
    const bool is_moved_by_contact = !setup.impactors[i].free_dofs.empty();  // the mass of others has no effect
    if (count > 0 && surface.is_closed() && is_moved_by_contact && is_weighed_by_volume(setup.impactors[i]))
      warnings.push_back(
          fmt::format("The surface of {} has {} components whose bounding boxes meet: overlaps count twice in mass, centre of mass and inertia. If they "
                      "overlap, give mass, centre_of_mass and inertia.",
                      impactors[i].name(), count));
  }
}

void warn_of_surfaces(const Setup& setup, std::span<const Body> bodies, std::span<const Impactor> impactors, double dt, std::vector<std::string>& warnings) {
  for (const Impactor& impactor : impactors) {
    for (const Diagnosis& of_surface : {inside_out(impactor), goes_through_itself(impactor), is_cut(impactor)})
      if (of_surface) warnings.push_back(*of_surface);
    for (std::size_t b = 0; b < bodies.size(); ++b) {
      const double spacing = bodies[b].particles.spacing();
      const Target target{bodies[b].name, spacing, setup.contact.impactors.radius_ratio * spacing, extent(bodies[b].particles), setup.bodies[b].velocity};
      for (std::string& sentence : diagnose(impactor, target, dt)) warnings.push_back(std::move(sentence));
      if (Diagnosis behind = starts_behind(impactor, target, bodies[b].particles)) warnings.push_back(std::move(*behind));
    }
  }
}

}  // namespace

std::vector<std::string> warnings_about_bodies(const Setup& setup, std::span<const Body> bodies, std::span<const std::optional<FilledMass>> masses) {
  std::vector<std::string> warnings;
  for (const Body& body : bodies) warn_of_density(body.name, body.particles.density(), warnings);
  for (const ImpactorSetup& impactor : setup.impactors)
    if (impactor.density) warn_of_density(impactor.name, *impactor.density, warnings);
  warn_of_thin_bodies(bodies, warnings);
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    warn_of_mass(bodies[b].name, masses[b], warnings);
    warn_of_loose_particles(bodies[b], warnings);
    for (std::string& warning : warnings_of(bodies[b].cracks, bodies[b].name)) warnings.push_back(std::move(warning));
  }
  return warnings;
}

std::vector<std::string> warnings_about_impactors(const Setup& setup, std::span<const Body> bodies, std::span<const Impactor> impactors, double dt) {
  std::vector<std::string> warnings;
  warn_of_overlaps(setup, impactors, warnings);
  warn_of_surfaces(setup, bodies, impactors, dt, warnings);
  return warnings;
}

}  // namespace perimpact
