#include "cli/setup_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <variant>

#include "cli/contact_bounds_text.hpp"
#include "cli/remesh_text.hpp"
#include "cli/row.hpp"
#include "cli/strength_text.hpp"
#include "cli/surface_text.hpp"
#include "cli/water_text.hpp"
#include "io/results/run_report.hpp"
#include "perimpact/diagnostics/approach.hpp"
#include "perimpact/integrate/stable_step.hpp"

namespace perimpact {

using output::Json;

namespace {

double bonds_of_particle(const Body& body) {
  if (const Stencil* stencil = body.family.stencil()) return static_cast<double>(stencil->size());
  return 2 * static_cast<double>(body.family.initial_bonds()) / static_cast<double>(body.particles.size());
}

std::string advice(const BendingOfLayers& thin) {
  constexpr double good = 0.95;  // eight layers
  return thin.relative >= good ? "" : fmt::format("; eight have 0.95, or bending_calibration: {} compensates for it", "xyz"[thin.axis]);
}

std::string body_text(const BodySetup& setup, const Body& body, const std::optional<FilledMass>& filled) {
  const Particles& particles = body.particles;
  std::string text = fmt::format("body {}\n", body.name);
  if (const Lattice* lattice = particles.lattice())
    text += row("particles", fmt::format("{} ({} x {} x {} cells of {:.4g} m)", particles.size(), lattice->cells[0], lattice->cells[1], lattice->cells[2],
                                         lattice->spacing));
  else
    text += row("particles", fmt::format("{} (a point cloud; mean particle size {:.4g} m)", particles.size(), particles.spacing()));
  text += row("bonds", fmt::format("{} ({:.0f} {} particle, horizon {:.4g} m)", body.family.initial_bonds(), bonds_of_particle(body),
                                   body.family.stencil() ? "an interior" : "a mean", body.family.horizon()));
  if (body.bending)
    text += row("bending", fmt::format("all bonds stiffened by a factor of {:.4g}, so that these layers have the bending stiffness of a plate", *body.bending));
  else if (const auto thin = bending_of_thin(setup, particles))
    text += row("bending",
                fmt::format("{} layers along {} have {:.2f} of a plate's stiffness{}", thin->layers, "xyz"[thin->axis], thin -> relative, advice(*thin)));
  text += strength_text(setup, body);
  const bool is_exact = !filled || std::fabs(filled->excess()) < 1e-9;  // a box of whole spacings
  text += row("mass", fmt::format("{:.5g} kg{}", particles.total_mass(),
                                  is_exact ? "" : fmt::format("; {:+.2g} % relative to the solid ({:.5g} kg)", 100 * filled->excess(), filled->solid)));
  if (particles.mass_scaling() != 1)
    text += row("mass scaling", fmt::format("inertia {:.4g} times that of the material; weight is not scaled", particles.mass_scaling()));
  for (const CrackCut& crack : body.cracks) text += fmt::format("  {:<18}{} bonds cut\n", "crack " + crack.name, crack.bonds);
  return text;
}

std::string boundary_conditions_text(const BoundaryConditions& boundary_conditions) {
  std::string text;
  for (const NamedBoundaryCondition& one : boundary_conditions.all()) {
    text += fmt::format("  {:<18}{}, {} particles", one.name, one.kind, one.particles());
    if (const auto* floating = std::get_if<Floating>(&one.boundary))
      text += fmt::format(
          "; water level {:.4g} m, {}", floating->water().level,
          std::isnan(floating->floats_at()) ? "heavier than the water it displaces" : fmt::format("in equilibrium at {:.4g} m", floating->floats_at()));
    text += '\n';
  }
  return text;
}

/// What decides forces of contact, given or by default.
std::string contact_text(const ContactSetup& contact, bool has_impactors) {
  const ImpactorContactSetup& impactors = contact.impactors;
  const FragmentContactSetup& fragments = contact.fragments;
  std::string text;
  if (has_impactors)
    text +=
        row("impactors", fmt::format("friction {:g}, {}", impactors.friction,
                                     impactors.crushing_pressure ? fmt::format("material is crushed at {:.4g} Pa", *impactors.crushing_pressure) : "rigid"));
  if (const auto law = fragments.law.as<FragmentLaw>(); law != FragmentLaw::none)
    text += row("fragments", fmt::format("{}, friction {:g}, stiffness factor {:g}, restitution {:g}", fragments.law.word(), fragments.friction,
                                         fragments.stiffness_factor, fragments.restitution));
  return text.empty() ? "" : "contact\n" + text;
}

/// Smallest exact critical step of the bodies [s].
double exact_step(const Simulation& simulation) {
  if (const auto& known = simulation.stability().exact) return *known;
  double exact = std::numeric_limits<double>::infinity();
  for (const Body& body : simulation.bodies()) exact = std::min(exact, exact_stable_step(body));
  return exact;
}

std::string step_text(const Simulation& simulation) {
  const Stability& stability = simulation.stability();
  const Clock& clock = simulation.clock();
  if (simulation.relaxation()) return "time\n" + row("increments", fmt::format("{} of {:.4g} s", clock.steps, clock.dt));
  const double exact = exact_step(simulation);
  return "time\n" +
         row("step", fmt::format("{:.4g} s, {} steps: {:.2f} of the estimated stable step ({:.4g} s), {:.2f} of the exact critical step ({:.4g} s)",
                                 stability.step, clock.steps, stability.step / stability.estimate, stability.estimate, stability.step / exact, exact));
}

std::string rigid_body_text(const Impactor& impactor) {
  const fccda::RigidBodyProperties& body = impactor.body().properties();
  const Vec3d com = body.centre_of_mass, products = fccda::products_of_inertia(body);
  const fccda::Mat3& inertia = body.inertia;
  const std::string moments = inertia.row[0] == Vec3d{} ? "not given, and undefined for an open surface"
                                                        : fmt::format("xx {:.5g}, yy {:.5g}, zz {:.5g}, yz {:.3g}, zx {:.3g}, xy {:.3g} kg m2",
                                                                      inertia.row[0].x, inertia.row[1].y, inertia.row[2].z, products.x, products.y, products.z);
  return row("mass", fmt::format("{:.5g} kg", body.mass)) +
         row("centre of mass", fmt::format("({:.4g}, {:.4g}, {:.4g}) m from the surface's origin", com.x, com.y, com.z)) + row("inertia", moments);
}

/// One line on the modes of an elastic impactor. Of modes of unit modal mass the mean of φ² over a uniform structure is one over its mass.
std::string modes_text(const Impactor& impactor) {
  const fccda::ElasticBody* const elastic = impactor.deforming() ? impactor.deforming()->elastic() : nullptr;
  if (!elastic) return "";
  double lowest = std::numeric_limits<double>::infinity(), highest = 0, lightest = lowest, heaviest = 0;
  for (const fccda::Mode& mode : elastic->modes()) {
    lowest = std::min(lowest, mode.angular_frequency), highest = std::max(highest, mode.angular_frequency);
    double sum = 0;
    for (const Vec3d& phi : mode.shape) sum += squared_norm(phi);
    const double mass = static_cast<double>(mode.shape.size()) / sum;
    lightest = std::min(lightest, mass), heaviest = std::max(heaviest, mass);
  }
  constexpr double turn = 2 * std::numbers::pi;
  return row("modes", fmt::format("{}, {:.4g} to {:.4g} Hz; of a uniform structure of {:.3g} to {:.3g} kg, if they have unit modal mass",
                                  elastic->modes().size(), lowest / turn, highest / turn, lightest, heaviest));
}

/// One line on initial buoyancy, weight and the equilibrium draft.
std::string hydrostatics_text(const Impactor& impactor) {
  if (!impactor.water()) return "";
  const PlacedInWater& placed = *impactor.placed_in_water();
  constexpr double none = 1e-6;  // of the weight
  const double weight = impactor.body().mass() * impactor.water()->gravity;
  const double force = std::fabs(placed.hydrostatics.force) <= none * weight ? 0 : placed.hydrostatics.force;
  const char* const behaviour = force == 0 ? "floats at rest" : force > 0 ? "rises" : placed.rise ? "settles" : "sinks";
  const std::string at_rest = placed.rise ? fmt::format("in this attitude it floats at a draft of {:.4g} m", placed.draft - *placed.rise)
                                          : "it is heavier than the water that it can displace";
  return row("in water", fmt::format("{}: displaces {:.5g} kg at a draft of {:.4g} m, net force {:+.4g} N upward; {}", behaviour,
                                     impactor.water()->density * placed.hydrostatics.volume, placed.draft, force, at_rest));
}

/// Predicted first contact of an impactor that no table or load moves.
std::optional<Approach> approach_of(const Simulation& simulation, const Impactor& impactor, const Body& body) {
  if (!impactor.coasts()) return std::nullopt;
  const double end = static_cast<double>(simulation.clock().steps) * simulation.clock().dt;
  return approach(impactor, body.particles, simulation.setup().contact.impactors.radius_ratio * body.particles.spacing(), end);
}

long step_at(const Simulation& simulation, double time) { return std::lround(std::ceil(time / simulation.clock().dt)); }

std::string approach_text(const Simulation& simulation, const Impactor& impactor) {
  std::string text;
  for (const Body& body : simulation.bodies()) {
    const std::optional<Approach> found = approach_of(simulation, impactor, body);
    if (!found)
      text += row("first contact", fmt::format("not predicted for {}: motion tables or loads change the velocity", body.name));
    else if (found->time)
      text += row("first contact", fmt::format("with {} at {:.4g} s (step {}), initial distance {:.4g} m", body.name, *found->time,
                                               step_at(simulation, *found->time), found->gap));
    else
      text += row("first contact",
                  fmt::format("none with {} before the end, initial distance {:.4g} m; check position, velocity and units", body.name, found->gap));
  }
  return text;
}

}  // namespace

std::string setup_text(const Simulation& simulation) {
  std::string text;
  for (std::size_t b = 0; b < simulation.bodies().size(); ++b)
    text += body_text(simulation.setup().bodies[b], simulation.bodies()[b], simulation.filled_mass(b)) +
            boundary_conditions_text(simulation.boundary_conditions()[b]) + water_text(simulation, b);
  for (const Impactor& impactor : simulation.impactors())
    text += fmt::format("impactor {}\n", impactor.name()) + remesh_text(impactor) + surface_text(impactor.surface().report()) + rigid_body_text(impactor) +
            modes_text(impactor) + hydrostatics_text(impactor) + contact_bounds_text(impactor) + approach_text(simulation, impactor);
  return text + contact_text(simulation.setup().contact, !simulation.impactors().empty()) + step_text(simulation);
}

Json setup_json(const Simulation& simulation) {
  Json json = Json::object();
  json["bodies"] = bodies_report(simulation);
  json["impactors"] = impactors_report(simulation);
  for (const Impactor& impactor : simulation.impactors())
    for (const Body& body : simulation.bodies()) {
      const std::optional<Approach> found = approach_of(simulation, impactor, body);
      if (!found) continue;
      Json& contact = json["impactors"][impactor.name()]["first_contact"][body.name];
      contact["distance [m]"] = found->gap;
      contact["time [s]"] = found->time ? Json(*found->time) : Json();
      contact["step"] = found->time ? Json(step_at(simulation, *found->time)) : Json();
    }
  const Clock& clock = simulation.clock();
  Json& time = json["time"];
  if (simulation.relaxation()) {
    time["increments"] = clock.steps;
    time["increment [s]"] = clock.dt;
  } else {
    time["steps"] = clock.steps;
    time["step [s]"] = simulation.stability().step;
    time["estimate [s]"] = simulation.stability().estimate;
    time["exact [s]"] = exact_step(simulation);
  }
  return json;
}

}  // namespace perimpact
