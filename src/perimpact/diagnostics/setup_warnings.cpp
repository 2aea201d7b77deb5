#include "perimpact/diagnostics/setup_warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <variant>

#include "base/grouped_sentences.hpp"
#include "perimpact/boundary_conditions/boundary_conditions.hpp"
#include "perimpact/diagnostics/diagnosis.hpp"
#include "perimpact/impactor/may_move.hpp"
#include "perimpact/impactor/rigid_body_of.hpp"

namespace perimpact {

using fccda::GroupedSentences;

namespace {

/// A bond reaches three particles: thinner bodies consist of surface only, beyond any correction.
void warn_of_thin_bodies(std::span<const Body> bodies, GroupedSentences& warnings) {
  constexpr int enough = 4;
  for (const Body& body : bodies) {
    if (!body.particles.lattice() || body.bending) continue;  // calibrated in bending
    const auto& cells = body.particles.whole_lattice()->cells;
    const int thinnest = *std::min_element(cells.begin(), cells.end() - (body.particles.is_plane() ? 1 : 0));
    if (thinnest < enough)
      warnings.add(
          "thin", body.name,
          fmt::format("Body {} is only {} particles thick, which makes its stiffness inaccurate, especially in bending. Use a spacing that gives at least {} "
                      "layers, preferably 6.",
                      body.name, thinnest, enough));
  }
}

/// The heaviest solid, osmium, has 22 590 kg/m3: a density in g/cm3 or t/mm3 without its unit is below 23, unlike one in kg/m3.
void warn_of_density(std::string_view of, double density, GroupedSentences& warnings) {
  constexpr double lightest = 23, heaviest = 23000;  // [kg/m3]
  if (density >= lightest && density <= heaviest) return;
  warnings.add(
      "density", std::string(of),
      fmt::format(
          "The density of {} is {:.4g} kg/m3, but solids have {:g} to {:g} kg/m3. If it is in another unit, append the unit, as in 7.8 g/cm3 or 7.8e-9 t/mm3.",
          of, density, lightest, heaviest));
}

/// Staircase surfaces, and features thinner than the spacing.
void warn_of_mass(const std::string& body, const std::optional<FilledMass>& mass, GroupedSentences& warnings) {
  constexpr double much = 0.05;
  if (!mass || std::fabs(mass->excess()) <= much) return;
  warnings.add(
      "mass", body,
      fmt::format(
          "The mass of the particles of body {} is {:.4g} kg, {:+.1f} % relative to its solid of {:.4g} kg: the lattice is too coarse. Use a smaller spacing.",
          body, mass->particles, 100 * mass->excess(), mass->solid));
}

void warn_of_loose_particles(const Body& body, GroupedSentences& warnings) {
  std::size_t loose = 0;
  for (const std::uint32_t slot : body.particles.slot_of()) loose += body.family.initial_volume(slot) > 0 ? 0 : 1;
  loose = static_cast<std::size_t>(body.particles.share().ranks().sum(static_cast<std::int64_t>(loose)));
  if (loose > 0)
    warnings.add(
        "loose", body.name,
        fmt::format("{} particles of body {} have no bonds, because the solid is too thin there or they are too far apart, and are unconstrained. Use a "
                    "smaller spacing, or a larger horizon_ratio.",
                    loose, body.name));
}

void warn_of_overlaps(const Setup& setup, std::span<const Impactor> impactors, GroupedSentences& warnings) {
  for (std::size_t i = 0; i < impactors.size(); ++i) {
    const fccda::Surface& surface = impactors[i].surface();
    const std::size_t count = surface.report().may_overlap;
    const bool is_moved_by_contact = !setup.impactors[i].free_dofs.empty();  // the mass of others has no effect
    if (count > 0 && surface.is_closed() && is_moved_by_contact && is_weighed_by_volume(setup.impactors[i]))
      warnings.add(
          "overlap", impactors[i].name(),
          fmt::format("The surface of {} has {} components whose bounding boxes meet: overlaps count twice in mass, centre of mass and inertia. If they "
                      "overlap, give mass, centre_of_mass and inertia.",
                      impactors[i].name(), count));
  }
}

void warn_of_surfaces(const Setup& setup, std::span<const Body> bodies, std::span<const Impactor> impactors, double dt, GroupedSentences& warnings) {
  for (const Impactor& impactor : impactors) {
    const auto add = [&](std::string_view kind, const std::string& subject, const Diagnosis& found) {
      if (found) warnings.add(kind, subject, *found);
    };
    add("inside out", impactor.name(), inside_out(impactor));
    add("through itself", impactor.name(), goes_through_itself(impactor));
    add("cut", impactor.name(), is_cut(impactor));
    for (std::size_t b = 0; b < bodies.size(); ++b) {
      const double spacing = bodies[b].particles.spacing();
      const Target target{bodies[b].name, spacing, setup.contact.impactors.radius_ratio * spacing, extent(bodies[b].particles), setup.bodies[b].velocity};
      const std::string pair = fmt::format("{} with {}", impactor.name(), target.name);
      for (auto& [kind, sentence] : diagnose(impactor, target, dt)) warnings.add(kind, pair, std::move(sentence));
      add("behind", pair, starts_behind(impactor, target, bodies[b].particles));
    }
  }
}

/// What to do about a number outside its range: one that is too small was probably meant in the larger `unit`.
std::string advice_on_unit(bool is_too_small, double number, std::string_view unit) {
  return is_too_small ? fmt::format("If it is in another unit, append the unit, as in {:.4g} {}.", number, unit) : "Check its unit.";
}

/// Gels have some kPa, diamond 1.2 TPa.
void warn_of_modulus(const BodySetup& setup, GroupedSentences& warnings) {
  constexpr double softest = 1e3, stiffest = 2e12;  // [Pa]
  const double modulus = elastic_of(setup).youngs_modulus;
  if (modulus >= softest && modulus <= stiffest) return;
  warnings.add("modulus", setup.name,
               fmt::format("Young's modulus of body {} is {:.4g} Pa, but solids have 1 kPa to 2 TPa. {}", setup.name, modulus,
                           advice_on_unit(modulus < softest, modulus, "GPa")));
}

std::optional<double> given_compressive_strength(const BodySetup& setup) {
  const std::optional<PlasticitySetup>& plasticity = setup.elastic().plasticity;
  return plasticity ? plasticity->compressive_strength : std::nullopt;
}

/// No solid is stronger than a tenth of its Young's modulus, by theory of its atomic bonds; of 1 kPa are the weakest soils and gels.
void warn_of_strength(std::string_view of, const std::string& subject, double strength, double modulus, GroupedSentences& warnings) {
  constexpr double weakest = 1e3, ideal = 0.1;  // [Pa], of the modulus
  if (strength >= weakest && strength <= ideal * modulus) return;
  warnings.add("strength", subject,
               fmt::format("The {} is {:.4g} Pa, but solids have 1 kPa to a tenth of Young's modulus, {:.4g} Pa here. {}", of, strength, ideal * modulus,
                           advice_on_unit(strength < weakest, strength, "MPa")));
}

void warn_of_strengths(const Setup& setup, GroupedSentences& warnings) {
  double stiffest = 0;
  for (const BodySetup& body : setup.bodies) {
    const ElasticSetup& material = body.elastic();
    const double modulus = elastic_of(body).youngs_modulus;
    stiffest = std::max(stiffest, modulus);
    const auto warn = [&](std::string_view name, std::optional<double> strength) {
      if (strength) warn_of_strength(fmt::format("{} of body {}", name, body.name), body.name, *strength, modulus, warnings);
    };
    warn("flexural_strength", material.flexural_strength);
    warn("compressive_strength", given_compressive_strength(body));
  }
  if (const std::optional<double> pressure = setup.contact.impactors.crushing_pressure)
    warn_of_strength("crushing_pressure of the contact with impactors", "contact", *pressure, stiffest, warnings);
}

/// As the deck refuses for a given flexural_strength: here that of a given stretch or fracture energy, which depends on horizon and layers.
void warn_of_yielding_in_bending(const BodySetup& setup, const Body& body, GroupedSentences& warnings) {
  const std::optional<double> strength = given_compressive_strength(setup);
  if (!strength || !body.failure || setup.elastic().flexural_strength || body.failure->flexural_strength < *strength) return;
  warnings.add("bending", body.name,
               fmt::format("The compressive_strength of body {} is {:.4g} Pa, not above its flexural strength of {:.4g} Pa, which follows from the stretch at "
                           "which bonds break: it yields before it breaks in bending. Use a larger compressive_strength, or a smaller critical_stretch or "
                           "fracture_energy.",
                           body.name, *strength, body.failure->flexural_strength));
}

/// A body at another level than that of its equilibrium is accelerated from the first step on.
void warn_of_floating_level(const BodySetup& setup, const Body& body, const BoundaryConditions& conditions, GroupedSentences& warnings) {
  constexpr double tolerance = 0.02;  // of its height; positions in decks are rounded
  const double height = extent(body.particles).z;
  for (const NamedBoundaryCondition& one : conditions.all()) {
    const auto* floating = std::get_if<Floating>(&one.boundary);
    if (!floating || setup.velocity.z != 0) continue;  // one that falls or rises is not to be in equilibrium
    const double level = floating->water().level, equilibrium = floating->floats_at();
    if (std::isnan(equilibrium))
      warnings.add("floating", one.name,
                   fmt::format("The particles of {} are heavier than the water that they displace, and sink. If the body is to float, check its density and "
                               "that of the water.",
                               one.name));
    else if (std::fabs(level - equilibrium) > tolerance * height)
      warnings.add("floating", one.name,
                   fmt::format("The water level of {} is {:.4g} m, but in its position the body floats at a level of {:.4g} m: it will heave. Move the body by "
                               "{:+.4g} m in z, or give it level: {:.4g}.",
                               one.name, level, equilibrium, level - equilibrium, equilibrium));
  }
}

/// From α = ν on, bonds across a compressed specimen never reach their critical stretch (damage.md).
void warn_of_hardening(const BodySetup& setup, GroupedSentences& warnings) {
  if (!setup.failure || setup.failure->compression.as<CompressionFailure>() != CompressionFailure::none) return;
  const double hardening = setup.failure->compression_hardening, ratio = elastic_of(setup).poissons_ratio;
  if (hardening == 0 || hardening < ratio) return;
  warnings.add("hardening", setup.name,
               fmt::format("The compression_hardening of body {} is {:g}, not below Poisson's ratio, {:g}: it carries any uniaxial compression. Use a smaller "
                           "one, or plasticity with the compressive_strength of the material.",
                           setup.name, hardening, ratio));
}

void warn_of_interpenetration(const Setup& setup, const Body& body, GroupedSentences& warnings) {
  if (!body.failure || setup.time.relax || setup.contact.fragments.is_chosen || setup.contact.fragments.law.as<FragmentLaw>() != FragmentLaw::none) return;
  warnings.add("fragments", body.name,
               fmt::format("Body {} may break, but there is no contact between its fragments: they pass through one another. Add contact: {{fragments: {{law: "
                           "repulsive}}}}, or law: none, if this does not matter.",
                           body.name));
}

void warn_of_still_windows(const Setup& setup, std::span<const Impactor> impactors, GroupedSentences& warnings) {
  for (const BodySetup& body : setup.bodies) {
    if (!body.moving_window) continue;
    const auto axis = static_cast<std::size_t>(body.moving_window->axis.index);
    for (std::size_t i = 0; i < impactors.size(); ++i)
      if (impactors[i].name() == body.moving_window->follow && !may_move(setup.impactors[i], impactors[i], axis))
        warnings.add("window", body.name,
                     fmt::format("The moving window of body {} follows impactor {}, which does not move along {}: give it a velocity or a motion there, or "
                                 "remove moving_window.",
                                 body.name, impactors[i].name(), degree_words[axis]));
  }
}

}  // namespace

std::vector<std::string> warnings_about_bodies(const Setup& setup, std::span<const Body> bodies, std::span<const std::optional<FilledMass>> masses) {
  GroupedSentences warnings;
  for (const BodySetup& body : setup.bodies) warn_of_modulus(body, warnings);
  warn_of_strengths(setup, warnings);
  for (const Body& body : bodies) warn_of_density(body.name, body.particles.material_density(), warnings);
  for (const ImpactorSetup& impactor : setup.impactors)
    if (impactor.density) warn_of_density(impactor.name, *impactor.density, warnings);
  warn_of_thin_bodies(bodies, warnings);
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    warn_of_mass(bodies[b].name, masses[b], warnings);
    warn_of_loose_particles(bodies[b], warnings);
    for (std::string& warning : warnings_of(bodies[b].cracks, bodies[b].name)) warnings.add("cracks", bodies[b].name, std::move(warning));
    warn_of_hardening(setup.bodies[b], warnings);
    warn_of_yielding_in_bending(setup.bodies[b], bodies[b], warnings);
    warn_of_interpenetration(setup, bodies[b], warnings);
  }
  return warnings.sentences();
}

std::vector<std::string> warnings_about_floating(const Setup& setup, std::span<const Body> bodies, std::span<const BoundaryConditions> conditions) {
  GroupedSentences warnings;
  for (std::size_t b = 0; b < bodies.size(); ++b) warn_of_floating_level(setup.bodies[b], bodies[b], conditions[b], warnings);
  return warnings.sentences();
}

std::vector<std::string> warnings_about_impactors(const Setup& setup, std::span<const Body> bodies, std::span<const Impactor> impactors, double dt) {
  GroupedSentences warnings;
  warn_of_still_windows(setup, impactors, warnings);
  warn_of_overlaps(setup, impactors, warnings);
  warn_of_surfaces(setup, bodies, impactors, dt, warnings);
  return warnings.sentences();
}

}  // namespace perimpact
