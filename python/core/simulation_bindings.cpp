#include "simulation_bindings.hpp"

#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "arguments.hpp"
#include "base/error.hpp"
#include "base/parallel.hpp"
#include "collected.hpp"
#include "io/deck/setup_to_text.hpp"
#include "kept.hpp"
#include "mesh.hpp"
#include "run.hpp"
#include "threads.hpp"
#include "tree.hpp"
#include "words.hpp"

namespace perimpact::python {

/// A particle contact of an impactor in the last step, as a NumPy record.
struct BlowRow {
  std::int32_t body;
  std::int32_t panel;
  std::int64_t slot;
  double time_fraction, depth;
  double position[3], normal[3], impulse[3];
};

namespace {

using namespace py::literals;

// ---- set-ups ----

/// Issues a FutureWarning for each deprecated key.
deck::Deck with_warnings(deck::Deck deck) {
  for (const std::string& warning : deck.warnings)
    if (PyErr_WarnEx(PyExc_FutureWarning, in_words_of_python(warning).c_str(), 2) != 0) throw py::error_already_set();
  return deck;
}

deck::Deck deck_of_file(const std::filesystem::path& file, const py::object& changes) {
  deck::YamlNode tree = deck::read_deck_tree(file);
  deck::SurfacesInMemory surfaces;
  if (!changes.is_none()) change(tree, dict_in(changes, "set", "such as {\"time.end\": \"10 us\"}"), surfaces);
  return with_warnings(worded([&] { return deck::deck_of_tree(std::move(tree), file.string(), file.parent_path(), surfaces); }));
}

deck::Deck deck_of_dict(const py::dict& setup, const std::filesystem::path& folder) {
  constexpr const char* whole = "the set-up";
  deck::SurfacesInMemory surfaces;
  deck::YamlNode tree = tree_of(setup, whole, surfaces);
  return with_warnings(worded([&] { return deck::deck_of_tree(std::move(tree), whole, folder, surfaces); }));
}

/// Replaces the names of meshes in memory by the meshes.
void insert_meshes(const py::dict& map, const deck::SurfacesInMemory& meshes) {
  for (const auto& [key, value] : map) {
    if (py::isinstance<py::dict>(value)) insert_meshes(py::reinterpret_borrow<py::dict>(value), meshes);
    if (!py::isinstance<py::str>(value)) continue;
    if (const auto mesh = meshes.find(py::cast<std::string>(value)); mesh != meshes.end()) map[key] = Mesh(mesh->second);
  }
}

py::object dict_of(const Setup& setup) {
  py::object dict = py::module_::import("json").attr("loads")(deck::setup_to_text(setup));
  if (const deck::SurfacesInMemory meshes = deck::surfaces_in_memory(setup); !meshes.empty()) insert_meshes(dict, meshes);
  return dict;
}

std::vector<UserForceFunction> user_forces(const py::object& forces) {
  std::vector<UserForceFunction> all;
  if (forces.is_none()) return all;
  for (const auto& [key, of_body] : dict_in(forces, "forces", "{\"body\": {\"name\": function}}")) {
    const std::string body = name_in(key, "forces", "bodies"), its = fmt::format("forces[\"{}\"]", body);
    for (const auto& [inner_key, function] : dict_in(of_body, its, "{\"name\": function}")) {
      const std::string name = name_in(inner_key, its, "user forces");
      if (!py::isinstance<py::function>(function))
        throw fccda::InputError(fmt::format("{}[\"{}\"] is {}, but it must be a function of time and body.", its, name, type_in_words(function)));
      all.push_back({body, name, kept(py::reinterpret_borrow<py::object>(function))});
    }
  }
  return all;
}

// ---- bodies ----

const Particles& particles_of(const BodyOfRun& body) { return body.get().particles; }

/// A view, or a copy while the simulation is being built, since construction may still fail.
py::object array_of_slots(const BodyOfRun& body, VectorArray Particles::*member) {
  const py::array view = view_of(particles_of(body).*member, body.simulation);
  return body.run->is_made() ? py::object(view) : view.attr("copy")();
}

template <class Value>
py::array_t<double> vectors_of_particles(const BodyOfRun& body, const Value& value) {
  const Particles& particles = particles_of(body);
  py::array_t<double> array({static_cast<py::ssize_t>(particles.slots()), py::ssize_t{3}});
  std::fill_n(array.mutable_data(), array.size(), 0.0);
  for (const std::uint32_t slot : particles.slot_of()) {
    const Vec3d vector = value(particles, slot);
    for (py::ssize_t c = 0; c < 3; ++c) array.mutable_at(slot, c) = vector[static_cast<std::size_t>(c)];
  }
  return array;
}

template <class Value>
py::array_t<double> numbers_of_particles(const BodyOfRun& body, const Value& value) {
  const Particles& particles = particles_of(body);
  py::array_t<double> array(static_cast<py::ssize_t>(particles.slots()));
  std::fill_n(array.mutable_data(), array.size(), 0.0);
  for (const std::uint32_t slot : particles.slot_of()) array.mutable_at(slot) = value(slot);
  return array;
}

py::array_t<bool> occupied(const BodyOfRun& body) {
  const Particles& particles = particles_of(body);
  py::array_t<bool> array(static_cast<py::ssize_t>(particles.slots()));
  for (std::size_t slot = 0; slot < particles.slots(); ++slot) array.mutable_at(static_cast<py::ssize_t>(slot)) = particles.is_occupied(slot);
  return array;
}

py::array_t<std::int64_t> slots(const BodyOfRun& body) {
  const std::span<const std::uint32_t> all = particles_of(body).slot_of();
  py::array_t<std::int64_t> array(static_cast<py::ssize_t>(all.size()));
  std::copy(all.begin(), all.end(), array.mutable_data());
  return array;
}

std::optional<std::array<std::size_t, 3>> lattice_shape(const BodyOfRun& body) {
  const Lattice* lattice = particles_of(body).lattice();
  if (!lattice) return std::nullopt;
  return std::array<std::size_t, 3>{static_cast<std::size_t>(lattice->cells[2]), static_cast<std::size_t>(lattice->cells[1]), lattice->row_slots()};
}

void bind_body(py::module_& module) {
  py::class_<BodyOfRun>(module, "Body", collected<BodyOfRun>(), R"(A deformable body of a simulation.

Arrays are indexed by *slots*: the cells of the filled lattice, x fastest, or the points of a point cloud, in both cases with some empty ones. `slots` lists
those of the particles in order, so `body.positions[body.slots]` has one row per particle. `positions`, `velocities` and `force_densities` are read-only
views of the simulation's memory and show every later step. The other arrays are computed on access, with 0 in empty slots.

The slots of a body with a moving window keep their numbers, but when the window moves their particles change: then row n is another particle than before.)")
      .def_property_readonly(
          "name", [](const BodyOfRun& body) { return body.get().name; }, "Name in the set-up.")
      .def("__len__", [](const BodyOfRun& body) { return particles_of(body).size(); })
      .def("__repr__", [](const BodyOfRun& body) { return fmt::format("<perimpact.Body {} of {} particles>", body.get().name, particles_of(body).size()); })
      .def_property_readonly("slots", &slots, "(particles,) slot of each particle, ascending.")
      .def_property_readonly("occupied", &occupied, "(slots,) bool: whether a slot contains a particle.")
      .def_property_readonly(
          "lattice_shape", &lattice_shape,
          "(nz, ny, nx) shape of the slots as a grid, with nx rounded up to a multiple of eight: `body.positions.reshape(*body.lattice_shape, 3)`. None for "
          "a point cloud.")
      .def_property_readonly(
          "positions", [](const BodyOfRun& body) { return array_of_slots(body, &Particles::position); }, "(slots, 3) current positions [m].")
      .def_property_readonly(
          "velocities", [](const BodyOfRun& body) { return array_of_slots(body, &Particles::velocity); },
          "(slots, 3) velocities [m/s], half a step before the positions (symplectic Euler).")
      .def_property_readonly(
          "force_densities", [](const BodyOfRun& body) { return array_of_slots(body, &Particles::force_density); },
          "(slots, 3) total force densities at the current positions [N/m3].")
      .def_property_readonly(
          "references",
          [](const BodyOfRun& body) { return vectors_of_particles(body, [](const Particles& p, std::size_t slot) { return p.reference(slot); }); },
          "(slots, 3) reference positions [m].")
      .def_property_readonly(
          "displacements",
          [](const BodyOfRun& body) { return vectors_of_particles(body, [](const Particles& p, std::size_t slot) { return p.displacement(slot); }); },
          "(slots, 3) displacements: positions minus references [m].")
      .def_property_readonly(
          "damages", [](const BodyOfRun& body) { return numbers_of_particles(body, [&](std::size_t slot) { return body.get().family.damage(slot); }); },
          "(slots,) damage: volume fraction of the broken bonds of each particle [-].")
      .def_property_readonly(
          "plastic_strains",
          [](const BodyOfRun& body) {
            return numbers_of_particles(body, [&](std::size_t slot) {
              const perimpact::PlasticForce* plastic = body.get().internal.plastic();
              return plastic ? plastic->equivalent_strain(slot) : 0.0;
            });
          },
          "(slots,) the equivalent plastic strain of each particle [-]; 0 where the material has no plasticity.")
      .def_property_readonly(
          "volumes", [](const BodyOfRun& body) { return numbers_of_particles(body, [&](std::size_t slot) { return particles_of(body).volume(slot); }); },
          "(slots,) particle volumes [m3].")
      .def_property_readonly(
          "density", [](const BodyOfRun& body) { return particles_of(body).density(); }, "Density [kg/m3] of inertia: that of the material times mass_scaling.")
      .def_property_readonly(
          "mass", [](const BodyOfRun& body) { return particles_of(body).total_mass(); },
          "Total mass of the particles [kg], of the material, without mass_scaling.")
      .def_property_readonly(
          "spacing", [](const BodyOfRun& body) { return particles_of(body).spacing(); }, "Lattice spacing [m]; for a point cloud, the mean particle size.")
      .def_property_readonly(
          "momentum", [](const BodyOfRun& body) { return body.get().motion().momentum; }, "(3,) total linear momentum [kg m/s].")
      .def_property_readonly(
          "broken_bonds", [](const BodyOfRun& body) { return body.get().internal.broken_bonds(); }, "Number of bonds broken so far.");
}

// ---- impactors ----

py::array_t<BlowRow> contacts_of(const ImpactorOfRun& impactor) {
  const std::vector<ContactImpulse>& contact_impulses = impactor.get().last_step().contact_impulses;  // while this thread has the GIL
  py::array_t<BlowRow> array(static_cast<py::ssize_t>(contact_impulses.size()));
  BlowRow* row = array.mutable_data();
  for (const ContactImpulse& contact_impulse : contact_impulses) {
    const fccda::Contact& contact = contact_impulse.contact;
    *row = {.body = static_cast<std::int32_t>(contact_impulse.body),
            .panel = contact.panel,
            .slot = static_cast<std::int64_t>(contact.point),
            .time_fraction = contact.time_fraction,
            .depth = contact.depth,
            .position = {contact.relocation.x, contact.relocation.y, contact.relocation.z},
            .normal = {contact.normal.x, contact.normal.y, contact.normal.z},
            .impulse = {contact_impulse.impulse.x, contact_impulse.impulse.y, contact_impulse.impulse.z}};
    ++row;
  }
  return array;
}

double step_of(const ImpactorOfRun& impactor) { return impactor.run->clock().dt; }

void bind_impactor(py::module_& module) {
  PYBIND11_NUMPY_DTYPE(BlowRow, body, panel, slot, time_fraction, depth, position, normal, impulse);
  py::class_<ImpactorOfRun>(module, "Impactor", collected<ImpactorOfRun>(), R"(An impactor of a simulation. Vectors are in world axes.

It has two sets of vertices: `current_vertices`, those of its panels as given, with `faces`; and `vertices`, those of its surface, welded, with `triangles`.)")
      .def_property_readonly(
          "name", [](const ImpactorOfRun& impactor) { return impactor.get().name(); }, "Name in the set-up.")
      .def("__repr__", [](const ImpactorOfRun& impactor) { return fmt::format("<perimpact.Impactor {}>", impactor.get().name()); })
      .def_property_readonly(
          "position", [](const ImpactorOfRun& impactor) { return impactor.get().body().position_of_com(); }, "(3,) position of the centre of mass [m].")
      .def_property_readonly(
          "origin", [](const ImpactorOfRun& impactor) { return impactor.get().body().pose().position(); }, "(3,) position of the surface's origin [m].")
      .def_property_readonly(
          "rotation", [](const ImpactorOfRun& impactor) { return array_of(impactor.get().body().pose().rotation()); },
          "(3, 3) rotation matrix from surface to world axes: `impactor.vertices @ impactor.rotation.T + impactor.origin`.")
      .def_property_readonly(
          "velocity", [](const ImpactorOfRun& impactor) { return impactor.get().body().velocity(); }, "(3,) velocity of the centre of mass [m/s].")
      .def_property_readonly(
          "angular_velocity", [](const ImpactorOfRun& impactor) { return impactor.get().body().angular_velocity(); }, "(3,) angular velocity [rad/s].")
      .def_property_readonly(
          "mass", [](const ImpactorOfRun& impactor) { return impactor.get().body().mass(); }, "Mass [kg].")
      .def_property_readonly(
          "kinetic_energy", [](const ImpactorOfRun& impactor) { return impactor.get().body().kinetic_energy(); },
          "Kinetic energy of translation and rotation [J].")
      .def_property_readonly(
          "force", [](const ImpactorOfRun& impactor) { return impactor.get().last_step().impulse / step_of(impactor); },
          "(3,) mean contact force over the last step [N]; `history` has means over its intervals.")
      .def_property_readonly(
          "moment", [](const ImpactorOfRun& impactor) { return impactor.get().last_step().angular_impulse / step_of(impactor); },
          "(3,) mean contact moment about the centre of mass over the last step [N m].")
      .def_property_readonly("contacts", &contacts_of,
                             R"(The particle contacts of the last step, as a structured array with the fields
body (index in the set-up), slot, panel (number in the given surface; -1 with the analytic detector), time_fraction (time of impact, 0 to 1), depth [m],
position (of the relocated particle) [m], normal (outward normal of the surface), impulse (on the impactor) [N s].)")
      .def_property_readonly(
          "current_vertices", [](const ImpactorOfRun& impactor) { return array_of(impactor.get().vertices()); },
          "(p, 3) current positions of the vertices of its panels in world axes, deformed where the impactor deforms [m], a copy. As many as in the file or "
          "Mesh, before welding; `faces` has their numbers.")
      .def_property_readonly(
          "faces", [](const ImpactorOfRun& impactor) { return array_of(impactor.get().surface().panels().panels); },
          "(q, 4) vertex numbers of each panel in `current_vertices`, the fourth -1 for triangles; a copy. The field panel of `contacts` is a row of it.")
      .def_property_readonly(
          "vertices", [](const ImpactorOfRun& impactor) { return array_of(impactor.get().surface().vertices()); },
          "(n, 3) vertices of the surface in its frame, welded and not deformed [m], a copy; `triangles` has their numbers.")
      .def_property_readonly(
          "triangles", [](const ImpactorOfRun& impactor) { return vertex_numbers_of(impactor.get().surface().triangles()); },
          "(m, 3) vertex numbers of each triangle in `vertices`, counterclockwise seen from outside; a copy.");
}

// ---- simulations ----

py::dict bodies_of(const py::object& self) {
  Run& run = self.cast<Run&>();
  py::dict bodies;
  for (std::size_t b = 0; b < run.setup().bodies.size(); ++b) bodies[py::str(run.setup().bodies[b].name)] = BodyOfRun{{self, &run, b}};
  return bodies;
}

py::dict impactors_of(const py::object& self) {
  Run& run = self.cast<Run&>();
  py::dict impactors;
  for (std::size_t i = 0; i < run.setup().impactors.size(); ++i) impactors[py::str(run.setup().impactors[i].name)] = ImpactorOfRun{{self, &run, i}};
  return impactors;
}

py::dict history_of(const Run& run) {
  const auto& columns = run.simulation().monitors().columns();
  const std::size_t rows = run.rows().size();  // one number for all columns: a step may add a row
  py::dict history;
  for (std::size_t c = 0; c < columns.size(); ++c) {
    py::array_t<double> column(static_cast<py::ssize_t>(rows));
    for (std::size_t r = 0; r < rows; ++r) column.mutable_at(static_cast<py::ssize_t>(r)) = run.rows()[r][c];
    history[py::str(columns[c].heading())] = column;
  }
  return history;
}

py::dict history_columns_of(const Run& run) {
  py::dict all;
  for (const Column& column : run.simulation().monitors().columns()) {
    py::dict one;
    one["unit"] = column.unit;
    one["kind"] = std::string(word_for(column.kind));
    one["meaning"] = column.meaning;
    all[py::str(column.heading())] = one;
  }
  return all;
}

py::dict timers_of(const Run& run) {
  py::dict timers;
  for (const auto& row : run.between_steps().timers().rows()) timers[py::str(row.name)] = row.seconds;
  return timers;
}

int thread_count() {
  use_chosen_threads();
  return fccda::thread_count();
}

std::string state_hash(const Run& run) {
  Simulation& simulation = run.between_steps();
  use_chosen_threads();
  return fmt::format("{:016x}", simulation.state_hash());
}

std::vector<std::string> warnings_of_run(const Run& run) {
  const Simulation& simulation = run.between_steps();
  std::vector<std::string> warnings = simulation.warnings();
  for (std::string& warning : simulation.closing_warnings()) warnings.push_back(std::move(warning));
  return warnings;
}

}  // namespace

void bind_simulation(py::module_& module) {
  bind_body(module);
  bind_impactor(module);
  py::class_<Run, std::shared_ptr<Run>>(module, "Simulation", collected<Run>(), R"(A simulation of peridynamic bodies and rigid impactors.

Created from a deck (`Simulation.from_deck`) or from a dict with the same keys. Both are bitwise identical to the command line in every step.

Other threads of Python may read it during `run`: what depends on the state waits for the end of the step in progress, and the run continues afterwards. `time`,
`step_number`, `is_finished` and `history` do not wait. Arrays that are views (Body) change during a step: copy what another thread reads later.)")
      .def(
          py::init([](const py::dict& setup, const std::filesystem::path& folder, const py::object& forces, const py::object& structures) {
            return Run::of(deck_of_dict(setup, folder), user_forces(forces), structures_of(structures));
          }),
          "setup"_a, py::kw_only(), "folder"_a = ".", "forces"_a = py::none(), "structures"_a = py::none(),
          R"(setup: a dict with the keys of a deck. Numbers are in SI units, strings have a unit ("9 mm"); vectors may be arrays; a Mesh may replace a surface file.
folder: base folder of relative file names.
forces: user forces, {"body": {"name": function}}. In every step `function(time, body)` must return the force density [N/m3] at the time [s] and
the positions of `body`, a Body: an array of shape (3,) for all particles, (particles, 3) or (slots, 3). Its sum and its work are columns of the history.
structures: {"impactor": object}: objects that move the surfaces of impactors, such as finite-element models. Each has `masses`, (n,) lumped masses of the
vertices [kg], inf where the motion is prescribed; `advance(time, dt)`, which returns the positions of the vertices at time + dt without the contact of
this step, (n, 3) [m]; `apply(impulses)`, which takes the contact impulses of the step, (n, 3) [N s], and changes velocities by impulses/masses and
positions by dt impulses/masses; and may have `energy` [J]: kinetic and elastic energy plus dissipation, less the work of supports and loads. n is the number of
vertices of the Mesh.

Raises InputError where the set-up is invalid.)")
      .def_static(
          "from_deck",
          [](const std::filesystem::path& file, const py::object& set, const py::object& forces, const py::object& structures) {
            return Run::of(deck_of_file(file, set), user_forces(forces), structures_of(structures));
          },
          "file"_a, py::kw_only(), "set"_a = py::none(), "forces"_a = py::none(), "structures"_a = py::none(),
          R"(Creates the simulation of a deck (YAML).

set: overrides as on the command line, {"time.end": "10 us"}; values may also be numbers, lists, dicts and meshes.
forces, structures: as for Simulation.)")
      .def("step", &Run::step, "Performs one time step, or one load increment with time.relax. Raises RunError where the run is over or has become unstable.")
      .def(
          "run",
          [](const py::object& self, std::optional<double> until, const py::object& callback, long every) {
            self.cast<Run&>().run(until, callback, every, self);
          },
          "until"_a = py::none(), "callback"_a = py::none(), "every"_a = 1,
          R"(Runs until the time `until` [s], or to the end of the set-up.

callback(simulation) is called after every `every` steps; if it returns something false other than None, run() returns and may be called again later.
Other Python threads continue meanwhile, and Ctrl-C ends the run after a complete step. An exception in a user force or structure ends the simulation, and its
results as those of a failed run.)")
      .def(
          "write_results", &Run::write_results, "folder"_a = py::none(), "resume"_a = false, "overwrite"_a = false,
          R"(Enables output to `folder`, or output.folder of the set-up, as by the command line: history, frames, checkpoints, and run.json and report.html at the end.

Call before the first step. resume: restarts from the checkpoint in the folder, as `perimpact run --resume` does. overwrite: replaces the run in the
folder, as `--force` does; without it a folder that contains a run is refused.)")
      .def("close_results", &Run::close_results,
           "Writes a checkpoint, run.json and report.html of an unfinished run, which `write_results(resume=True)` can resume later. Raises RunError in the "
           "middle "
           "of a step.")
      .def_property_readonly(
          "title", [](const Run& run) { return run.setup().title; }, "Title of the set-up.")
      .def_property_readonly(
          "time", [](const Run& run) { return run.clock().time(); }, "Current simulation time [s].")
      .def_property_readonly(
          "dt", [](const Run& run) { return run.clock().dt; }, "Time step [s].")
      .def_property_readonly(
          "step_number", [](const Run& run) { return run.clock().step; }, "Number of completed steps.")
      .def_property_readonly(
          "steps", [](const Run& run) { return run.clock().steps; }, "Total number of steps of the run.")
      .def_property_readonly(
          "is_finished", [](const Run& run) { return run.clock().is_finished(); }, "Whether the run has reached the end of the set-up.")
      .def_property_readonly("bodies", &bodies_of, "Bodies by name.")
      .def_property_readonly("impactors", &impactors_of, "Impactors by name.")
      .def_property_readonly("history", &history_of,
                             "The columns of history.csv since this simulation was created: {column: array}, such as \"cylinder.force_y [N]\".")
      .def_property_readonly(
          "history_columns", &history_columns_of,
          "Description of the history columns: {column: {\"unit\", \"kind\", \"meaning\"}}; the kind is instantaneous, interval mean or cumulative.")
      .def_property_readonly(
          "setup", [](const Run& run) { return dict_of(run.setup()); }, "The resolved set-up, a dict in SI units that gives the same simulation.")
      .def_property_readonly("warnings", &warnings_of_run, "Warnings about the set-up and the run so far.")
      .def_property_readonly("timers", &timers_of, "Wall-clock seconds per phase of the step so far: {phase: seconds}.")
      .def_property_readonly("state_hash", &state_hash, "Hash of the complete state, as in run.json: equal for bitwise identical states.")
      .def("__repr__", [](const Run& run) {
        const Clock clock = run.clock();
        return fmt::format("<perimpact.Simulation \"{}\", step {} of {}, t = {:.4g} s>", run.setup().title, clock.step, clock.steps, clock.time());
      });
  module.def(
      "read_deck", [](const std::filesystem::path& file, const py::object& set) { return dict_of(deck_of_file(file, set).setup); }, "file"_a, py::kw_only(),
      "set"_a = py::none(), "The set-up of a deck as a dict in SI units, to be modified and passed to Simulation. set: as for Simulation.from_deck.");
  module.def(
      "use_threads", &choose_threads, "count"_a,
      "Sets the number of threads of simulations and contact detection, 1 to 1024, whichever thread of Python runs them. Results are bitwise reproducible "
      "across thread counts.");
  module.def("thread_count", &thread_count, "Number of threads of simulations and contact detection.");
}

}  // namespace perimpact::python
