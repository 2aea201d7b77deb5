#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <limits>

#include "base/parallel.hpp"
#include "cli/commands.hpp"
#include "cli/contact_bounds_text.hpp"
#include "cli/open_deck.hpp"
#include "cli/progress.hpp"
#include "cli/remesh_text.hpp"
#include "cli/strength_text.hpp"
#include "cli/surface_text.hpp"
#include "fccda/contact_bounds/bounds_panels.hpp"
#include "io/output/results_folder.hpp"
#include "io/output/vtp.hpp"
#include "io/results/lines.hpp"
#include "io/results/results_writer.hpp"
#include "perimpact/diagnostics/approach.hpp"
#include "perimpact/integrate/stable_step.hpp"
#include "perimpact/simulation/memory.hpp"

namespace perimpact {

namespace {

std::string bytes_in_words(double bytes) { return bytes < 1e9 ? fmt::format("{:.0f} MB", std::ceil(bytes / 1e6)) : fmt::format("{:.1f} GB", bytes / 1e9); }

double bonds_of_particle(const Body& body) {
  if (const Stencil* stencil = body.family.stencil()) return static_cast<double>(stencil->size());
  return 2 * static_cast<double>(body.family.initial_bonds()) / static_cast<double>(body.particles.size());
}

std::string advice(const BendingOfLayers& thin) {
  constexpr double good = 0.95;  // eight layers
  return thin.relative >= good ? "" : fmt::format("; eight have 0.95, or bending_calibration: {} compensates for it", "xyz"[thin.axis]);
}

void print_body(const BodySetup& setup, const Body& body, const std::optional<FilledMass>& filled) {
  fmt::print("body {}\n", body.name);
  if (const Lattice* lattice = body.particles.lattice())
    fmt::print("  {:<18}{} ({} x {} x {} cells of {:.4g} m)\n", "particles", body.particles.size(), lattice->cells[0], lattice->cells[1], lattice->cells[2],
               lattice->spacing);
  else
    fmt::print("  {:<18}{} (a point cloud; mean particle size {:.4g} m)\n", "particles", body.particles.size(), body.particles.spacing());
  fmt::print("  {:<18}{} ({:.0f} {} particle, horizon {:.4g} m)\n", "bonds", body.family.initial_bonds(), bonds_of_particle(body),
             body.family.stencil() ? "an interior" : "a mean", body.family.horizon());
  if (body.bending)
    fmt::print("  {:<18}all bonds stiffened by a factor of {:.4g}, so that these layers have the bending stiffness of a plate\n", "bending", *body.bending);
  else if (const auto thin = bending_of_thin(setup, body.particles))
    fmt::print("  {:<18}{} layers along {} have {:.2f} of a plate's stiffness{}\n", "bending", thin->layers, "xyz"[thin->axis], thin -> relative,
               advice(*thin));
  fmt::print("{}", strength_text(setup, body));
  const bool is_exact = !filled || std::fabs(filled->excess()) < 1e-9;  // a box of whole spacings
  fmt::print("  {:<18}{:.5g} kg{}\n", "mass", body.particles.total_mass(),
             is_exact ? "" : fmt::format("; {:+.2g} % relative to the solid ({:.5g} kg)", 100 * filled->excess(), filled->solid));
  for (const CrackCut& crack : body.cracks) fmt::print("  {:<18}{} bonds cut\n", "crack " + crack.name, crack.bonds);
}

void print_boundary_conditions(const BoundaryConditions& boundary_conditions) {
  for (const NamedBoundaryCondition& one : boundary_conditions.all()) fmt::print("  {:<18}{}, {} particles\n", one.name, one.kind, one.particles());
}

void print_step(const Simulation& simulation) {
  const Stability& stability = simulation.stability();
  if (simulation.relaxation()) {
    fmt::print("time\n  {:<18}{} of {:.4g} s\n", "increments", simulation.clock().steps, simulation.clock().dt);
    return;
  }
  double exact = stability.exact.value_or(std::numeric_limits<double>::infinity());
  if (!stability.exact)
    for (const Body& body : simulation.bodies()) exact = std::min(exact, exact_stable_step(body));
  fmt::print("time\n  {:<18}{:.4g} s, {} steps: {:.2f} of the estimated stable step ({:.4g} s), {:.2f} of the exact critical step ({:.4g} s)\n", "step",
             stability.step, simulation.clock().steps, stability.step / stability.estimate, stability.estimate, stability.step / exact, exact);
}

void print_rigid_body(const Impactor& impactor) {
  const fccda::RigidBodyProperties& body = impactor.body().properties();
  const Vec3d com = body.centre_of_mass, products = fccda::products_of_inertia(body);
  const fccda::Mat3& inertia = body.inertia;
  fmt::print("  {:<18}{:.5g} kg\n", "mass", body.mass);
  fmt::print("  {:<18}({:.4g}, {:.4g}, {:.4g}) m from the surface's origin\n", "centre of mass", com.x, com.y, com.z);
  if (inertia.row[0] == Vec3d{})
    fmt::print("  {:<18}not given, and undefined for an open surface\n", "inertia");
  else
    fmt::print("  {:<18}xx {:.5g}, yy {:.5g}, zz {:.5g}, yz {:.3g}, zx {:.3g}, xy {:.3g} kg m2\n", "inertia", inertia.row[0].x, inertia.row[1].y,
               inertia.row[2].z, products.x, products.y, products.z);
}

/// One line on initial buoyancy, weight and the equilibrium draft.
void print_hydrostatics(const Impactor& impactor) {
  if (!impactor.water()) return;
  const PlacedInWater& placed = *impactor.placed_in_water();
  constexpr double none = 1e-6;  // of the weight
  const double weight = impactor.body().mass() * impactor.water()->gravity;
  const double force = std::fabs(placed.hydrostatics.force) <= none * weight ? 0 : placed.hydrostatics.force;
  const char* const behaviour = force == 0 ? "floats at rest" : force > 0 ? "rises" : placed.rise ? "settles" : "sinks";
  const std::string at_rest = placed.rise ? fmt::format("in this attitude it floats at a draft of {:.4g} m", placed.draft - *placed.rise)
                                          : "it is heavier than the water that it can displace";
  fmt::print("  {:<18}{}: displaces {:.5g} kg at a draft of {:.4g} m, net force {:+.4g} N upward; {}\n", "in water", behaviour,
             impactor.water()->density * placed.hydrostatics.volume, placed.draft, force, at_rest);
}

void print_approach(const Simulation& simulation, const Impactor& impactor) {
  const double end = static_cast<double>(simulation.clock().steps) * simulation.clock().dt;
  for (const Body& body : simulation.bodies()) {
    const double radius = simulation.setup().contact.impactors.radius_ratio * body.particles.spacing();
    if (!impactor.coasts()) {
      fmt::print("  {:<18}not predicted for {}: motion tables or loads change the velocity\n", "first contact", body.name);
      continue;
    }
    const Approach found = approach(impactor, body.particles, radius, end);
    if (found.touch)
      fmt::print("  {:<18}with {} at {:.4g} s (step {}), initial distance {:.4g} m\n", "first contact", body.name, *found.touch,
                 std::lround(std::ceil(*found.touch / simulation.clock().dt)), found.gap);
    else
      fmt::print("  {:<18}none with {} before the end, initial distance {:.4g} m; check position, velocity and units\n", "first contact", body.name, found.gap);
  }
}

/// Memory of the whole run, before any of it is allocated.
Memory memory_needed(const Setup& setup) {
  std::vector<Discretisation> bodies;
  for (const BodySetup& body : setup.bodies) bodies.push_back(discretise(body));
  return memory_of(setup, bodies);
}

void print_memory(const Memory& memory) {
  fmt::print("memory\n  {:<18}about {}: {} from the first step on, up to {} more during set-up, {} while an output frame is written\n", "peak",
             bytes_in_words(memory.peak()), bytes_in_words(memory.at_rest), bytes_in_words(memory.setting_up), bytes_in_words(memory.pictures));
  if (memory.rubble > 0) fmt::print("  {:<18}up to {} more if all bonds break\n", "fragments", bytes_in_words(memory.rubble));
}

void print_lines(const std::vector<Line>& lines, const Simulation& simulation) {
  for (const Line& line : lines)
    fmt::print("line {}\n  {:<18}{} points of {}, written after step {}\n", line.name, "samples", line.samples.size(), simulation.bodies()[line.body].name,
               fmt::join(line.steps, ", "));
}

/// Estimated duration of the run from a few steps.
void print_duration(Simulation& simulation) {
  constexpr int trial_steps = 5;
  simulation.step();  // warms caches
  const auto begin = std::chrono::steady_clock::now();
  const long first = simulation.clock().step;
  while (simulation.clock().step < first + trial_steps && !simulation.clock().is_finished()) simulation.step();
  const long done = simulation.clock().step - first;
  if (done == 0) return;
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() / static_cast<double>(done) *
                         static_cast<double>(simulation.clock().steps);
  fmt::print("duration\n  about {} on {} threads, without output frames (from {} steps)\n", duration_in_words(seconds), fccda::thread_count(), done);
}

void write_frames(const Simulation& simulation, const std::filesystem::path& folder) {
  output::prepare_folder(folder);
  remove_defect_files(simulation, folder);
  for (const Body& body : simulation.bodies()) write_particles(folder / (body.name + ".vtp"), body, std::nullopt);
  for (const Impactor& impactor : simulation.impactors()) {
    write_impactor(folder / (impactor.name() + "_surface.vtp"), impactor);
    fccda::Panels region = fccda::bounds_panels(impactor.region().region);
    if (region.panels.empty()) continue;
    for (Vec3d& vertex : region.vertices) vertex = impactor.body().pose().to_world(vertex);
    output::write_vtp(folder / (impactor.name() + "_contact_bounds.vtp"), {.points = output::coordinates(region.vertices), .panels = region.panels},
                      output::Compression::zlib);
  }
}

}  // namespace

int check_command(const DeckArguments& arguments) {
  const deck::Deck deck = open_deck(arguments);
  const std::filesystem::path folder = results_folder(arguments, deck.setup) / "check";
  return with_places(deck, {folder}, [&] {
    const Memory memory = memory_needed(deck.setup);
    Simulation simulation(deck.setup);
    const std::vector<Line> lines = lines_of(simulation);
    fmt::print("{}\n", deck.setup.title);
    for (std::size_t b = 0; b < simulation.bodies().size(); ++b) {
      print_body(simulation.setup().bodies[b], simulation.bodies()[b], simulation.filled_mass(b));
      print_boundary_conditions(simulation.boundary_conditions()[b]);
    }
    for (const Impactor& impactor : simulation.impactors()) {
      fmt::print("impactor {}\n{}{}", impactor.name(), remesh_text(impactor), surface_text(impactor.surface().report()));
      print_rigid_body(impactor);
      print_hydrostatics(impactor);
      fmt::print("{}", contact_bounds_text(impactor));
      print_approach(simulation, impactor);
    }
    print_step(simulation);
    print_memory(memory);
    print_lines(lines, simulation);
    for (const std::string& warning : simulation.warnings()) fmt::print("warning: {}\n", warning);
    write_frames(simulation, folder);
    if (!simulation.relaxation()) print_duration(simulation);  // the durations of increments are unrelated
    fmt::print("surfaces, contact bounds and bodies are in {} as VTP\n", folder.string());
    return 0;
  });
}

}  // namespace perimpact
