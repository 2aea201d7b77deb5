#include "io/results/run_report.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/parallel.hpp"
#include "io/deck/setup_to_text.hpp"
#include "io/results/contact_bounds_report.hpp"
#include "io/results/fragment_tables.hpp"
#include "io/results/json_vector.hpp"
#include "perimpact/simulation/ranks_report.hpp"

namespace perimpact {

using output::Json;

namespace {

Json body_report(const Body& body, const BoundaryConditions& boundary_conditions, const std::optional<FilledMass>& filled) {
  Json json = Json::object();
  const Share& share = body.particles.share();
  json["particles"] = body.particles.size_of_body();
  json["bonds"] = body.family.initial_bonds();
  json["intact_bonds"] = body.family.intact_bonds(share);
  if (const Stencil* stencil = body.family.stencil()) json["interior_family"] = stencil->size();
  json["spacing [m]"] = body.particles.spacing();
  json["horizon [m]"] = body.family.horizon();
  if (body.particles.mass_scaling() != 1) json["mass_scaling"] = body.particles.mass_scaling();
  if (body.bending) json["bending_calibration"] = *body.bending;
  if (const auto& failure = body.failure) {
    json["failure"]["critical_stretch"] = failure->stretch;
    json["failure"]["fracture_energy [J/m2]"] = failure->fracture_energy;
    json["failure"]["flexural_strength [Pa]"] = failure->flexural_strength;
    json["failure"]["layers"] = failure->layers;
    json["fragments"] = fragment_report(Fragments(body.particles, body.family).count());
  }
  json["memory [byte]"] = static_cast<double>(share.ranks().sum(std::llround(body.memory())));
  json["mass [kg]"] = body.particles.total_mass();
  if (filled) json["mass_of_solid [kg]"] = filled->solid;
  for (const CrackCut& crack : body.cracks) json["cracks"][crack.name]["bonds"] = crack.bonds;
  for (const NamedBoundaryCondition& one : boundary_conditions.all()) {
    Json& entry = json["boundary_conditions"][one.name.substr(body.name.size() + 1)];
    entry["kind"] = one.kind;
    entry["particles"] = share.ranks().sum(static_cast<std::int64_t>(one.particles()));
    entry["work [J]"] = one.account().work();
    if (const auto* floating = std::get_if<Floating>(&one.boundary)) {
      entry["level [m]"] = floating->water().level;
      entry["floats_at [m]"] = floating->floats_at();
    }
  }
  return json;
}

std::size_t particles_initially_inside(const Simulation& simulation, std::size_t impactor, std::size_t body) {
  for (const InitialPenetration& inside : simulation.initial_penetrations())
    if (inside.impactor == impactor && inside.body == body) return inside.particles;
  return 0;
}

Json floating_report(const Impactor& impactor) {
  const double density = impactor.water()->density;
  const PlacedInWater& placed = *impactor.placed_in_water();
  const fccda::Hydrostatics now = impactor.hydrostatics();
  Json json = Json::object();
  json["level [m]"] = impactor.water()->level;
  json["mass [kg]"] = impactor.body().mass();
  json["added_mass [kg]"] = impactor.body().properties().added_mass.z;
  json["displaced_at_start [kg]"] = density * placed.hydrostatics.volume;
  json["force_at_start [N]"] = placed.hydrostatics.force;
  json["draft_at_start [m]"] = placed.draft;
  if (placed.rise) json["draft_at_rest [m]"] = placed.draft - *placed.rise;
  json["displaced [kg]"] = density * now.volume;
  json["draft [m]"] = impactor.draft();
  json["potential [J]"] = now.potential;
  json["work [J]"] = impactor.water_work();
  return json;
}

Json impactor_report(const Simulation& simulation, std::size_t number) {
  const Impactor& impactor = simulation.impactors()[number];
  Json json = Json::object();
  json["surface"] = surface_report(impactor.surface().report());
  json["surface"]["buried_triangles"] = impactor.buried_triangles();
  if (const auto& remeshing = impactor.remeshing()) {
    json["surface_as_given"] = surface_report(remeshing->given);
    if (const auto& coarsened = remeshing->coarsened) {
      json["coarsened"]["triangles"] = coarsened->panels;
      json["coarsened"]["moved_at_most [m]"] = coarsened->distance;
      json["coarsened"]["volume_change [m3]"] = coarsened->volume_change;
    }
  }
  const fccda::RigidBodyProperties& properties = impactor.body().properties();
  const fccda::Mat3& inertia = properties.inertia;
  json["mass [kg]"] = properties.mass;
  json["centre_of_mass [m]"] = json_vector(properties.centre_of_mass);
  json["inertia [kg m2]"] = json_vector({inertia.row[0].x, inertia.row[1].y, inertia.row[2].z});
  json["products_of_inertia [kg m2]"] = json_vector(fccda::products_of_inertia(properties));
  json["contact_bounds"] = contact_bounds_report(impactor);
  for (std::size_t b = 0; b < simulation.bodies().size(); ++b) {
    const fccda::Effort effort = impactor.effort(b);
    const auto of_all = [&](std::size_t count) { return simulation.ranks().sum(static_cast<std::int64_t>(count)); };
    Json& against = json["detection"][simulation.bodies()[b].name];
    against["points_in_bounds"] = of_all(effort.points_in_bounds);
    against["points_tested"] = of_all(effort.points_tested);
    against["panels_tested"] = of_all(effort.panels_tested);
    if (const fccda::Published* published = impactor.published(b)) {
      const fccda::Rejections& rejections = published->rejections();
      against["rejected_by"]["eq. 14"] = of_all(rejections.by_eq14);
      against["rejected_by"]["eq. 15"] = of_all(rejections.by_eq15);
      against["rejected_by"]["eq. 17"] = of_all(rejections.by_eq17);
      against["rejected_by"]["eq. 20"] = of_all(rejections.by_eq20);
    }
    against["initial_overlap"] = particles_initially_inside(simulation, number, b);
    against["entered_inside"] = of_all(impactor.entered_inside(b));
    against["unresolved_penetrations"] = impactor.unresolved(b).count;
  }
  json["constraint_work [J]"] = impactor.constraint_work();
  json["load_work [J]"] = impactor.load_work();
  if (impactor.water()) json["floating"] = floating_report(impactor);
  return json;
}

Json communication_report(const RanksReport& ranks) {
  Json json = Json::object();
  json["messages"] = ranks.all.messages;
  json["sent [byte]"] = ranks.all.bytes;
  json["largest_sent [byte]"] = ranks.most_bytes;
  json["reductions"] = ranks.all.reductions;
  json["reduced [byte]"] = ranks.all.reduced_bytes;
  json["collections"] = ranks.all.collections;
  json["collected [byte]"] = ranks.all.collected_bytes;
  json["waiting [s]"] = ranks.all.seconds;
  json["forces_mean [s]"] = ranks.mean_forces;
  json["forces_largest [s]"] = ranks.largest_forces;
  json["imbalance"] = ranks.imbalance();
  return json;
}

/// The largest energy balance error, and that over the energy exchanged: the sum of the largest magnitudes of the works of contact and of boundary conditions.
Json energy_balance_report(const Monitors& monitors) {
  const std::span<const double> largest = monitors.largest();
  double error = 0, exchanged = 0;
  for (std::size_t c = 0; c < largest.size(); ++c) {
    const std::string& name = monitors.columns()[c].name;
    if (name == "total.energy_balance_error") error = largest[c];
    if (name.ends_with(".contact_work") || name.ends_with(".work")) exchanged += largest[c];
  }
  Json json = Json::object();
  json["largest_error [J]"] = error;
  json["exchanged [J]"] = exchanged;
  if (exchanged > 0) json["relative"] = error / exchanged;
  return json;
}

std::string_view word_for(Outcome outcome) {
  switch (outcome) {
    case Outcome::finished:
      return "finished";
    case Outcome::interrupted:
      return "interrupted";
    case Outcome::failed:
      return "failed";
  }
  return "";
}

}  // namespace

std::string_view word_for(fccda::Closure closure) {
  switch (closure) {
    case fccda::Closure::closed:
      return "closed";
    case fccda::Closure::open:
      return "open";
  }
  return "";
}

Json surface_report(const fccda::SurfaceReport& report) {
  Json json = Json::object();
  json["panels"] = report.panels;
  json["triangles"] = report.triangles;
  json["vertices"] = report.vertices;
  json["welded"] = report.welded;
  json["degenerate"] = report.degenerate;
  json["duplicate"] = report.duplicate;
  json["back_to_back"] = report.back_to_back;
  json["non_manifold_edges"] = report.non_manifold_edge_count;
  json["cut_edges"] = report.cut_edges;
  json["rewound"] = report.rewound;
  json["flipped"] = report.flipped;
  json["components"] = report.components;
  json["cavities"] = report.cavities;
  json["solids"] = report.solids;
  json["may_overlap"] = report.may_overlap;
  for (const fccda::PartReport& part : report.parts) {
    if (report.parts.size() == 1 && part.name.empty()) break;  // a single unnamed part
    Json& entry = json["parts"][part.name];
    entry["panels"] = part.panels;
    entry["area [m2]"] = part.area;
  }
  json["closure"] = word_for(report.closure);
  json["boundary_edges"] = report.boundary_edges;
  json["area [m2]"] = report.area;
  json["volume [m3]"] = report.volume;
  json["centroid [m]"] = json_vector(report.centroid);
  json["shortest_edge [m]"] = report.shortest_edge;
  json["longest_edge [m]"] = report.longest_edge;
  json["low [m]"] = json_vector(report.bounds.low);
  json["high [m]"] = json_vector(report.bounds.high);
  return json;
}

Json bodies_report(const Simulation& simulation) {
  Json json = Json::object();
  for (std::size_t b = 0; b < simulation.bodies().size(); ++b)
    json[simulation.bodies()[b].name] = body_report(simulation.bodies()[b], simulation.boundary_conditions()[b], simulation.filled_mass(b));
  return json;
}

Json impactors_report(const Simulation& simulation) {
  Json json = Json::object();
  for (std::size_t i = 0; i < simulation.impactors().size(); ++i) json[simulation.impactors()[i].name()] = impactor_report(simulation, i);
  return json;
}

Json run_report(Simulation& simulation, Outcome outcome, const std::string& failure, double wall_seconds, std::span<const std::int64_t> resumed_at) {
  const Clock& clock = simulation.clock();
  Json json = Json::object();
  json["program"] = "perimpact " PERIMPACT_VERSION;
  json["outcome"] = word_for(outcome);
  if (!failure.empty()) json["failure"] = failure;
  json["title"] = simulation.setup().title;
  json["steps"] = clock.step;
  json["time [s]"] = clock.time();
  if (!resumed_at.empty()) json["resumed_at_steps"] = std::vector(resumed_at.begin(), resumed_at.end());
  json["threads"] = fccda::thread_count();
  if (simulation.ranks().size() > 1) json["ranks"] = simulation.ranks().size();
  if (const std::string device = simulation.device_name(); !device.empty()) json["device"] = device;
  json["wall_time [s]"] = wall_seconds;
  json["state_hash"] = fmt::format("{:016x}", simulation.state_hash());
  if (simulation.relaxation()) {
    json["increment [s]"] = clock.dt;
  } else {
    json["stability"]["step [s]"] = simulation.stability().step;
    json["stability"]["estimate [s]"] = simulation.stability().estimate;
    if (simulation.stability().exact) json["stability"]["exact [s]"] = *simulation.stability().exact;
    json["energy_balance"] = energy_balance_report(simulation.monitors());
  }
  json["bodies"] = bodies_report(simulation);
  if (!simulation.impactors().empty()) json["impactors"] = impactors_report(simulation);
  for (const auto& row : simulation.set_up_timers().rows()) json["set_up [s]"][row.name] = row.seconds;
  for (const auto& row : simulation.timers().rows()) json["timers [s]"][row.name] = row.seconds;
  if (simulation.ranks().size() > 1) json["communication"] = communication_report(report_of_ranks(simulation));
  json["warnings"] = simulation.warnings();
  for (std::string& warning : simulation.closing_warnings()) json["warnings"].push_back(std::move(warning));
  json["setup"] = Json::verbatim(deck::setup_to_text(simulation.setup()));
  return json;
}

}  // namespace perimpact
