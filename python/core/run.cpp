#include "run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <limits>

#include "base/error.hpp"
#include "io/deck/did_you_mean.hpp"
#include "io/output/file.hpp"
#include "io/output/results_folder.hpp"
#include "io/report/report.hpp"
#include "io/results/run_report.hpp"
#include "perimpact/deck_model/setup_error.hpp"
#include "run/stop_signals.hpp"
#include "threads.hpp"
#include "words.hpp"

namespace perimpact::python {

namespace {

using fccda::InputError;
using fccda::RunError;

constexpr std::chrono::milliseconds between_looks_for_signals{50};

template <class F>
auto with_places(const deck::Deck& deck, const F& f) {
  return worded([&] {
    try {
      return f();
    } catch (const SetupError& error) {
      throw InputError(deck.places.of(error.key()) + ": " + error.what());
    }
  });
}

/// Converts the return value of a user force to force densities of the slots.
void spread(const py::object& returned, const std::string& name, const Particles& particles, VectorArray& density) {
  Numbers numbers = Numbers::ensure(returned);
  if (!numbers) PyErr_Clear();
  const auto is_shape = [&](std::size_t rows) { return numbers.ndim() == 2 && numbers.shape(1) == 3 && static_cast<std::size_t>(numbers.shape(0)) == rows; };
  const bool is_one_for_all = numbers && numbers.ndim() == 1 && numbers.shape(0) == 3;
  const std::string what = returned.is_none() ? "nothing"
                           : numbers          ? "an array of the shape " + shape_in_words(numbers)
                                              : "an object that is not an array of numbers";
  if (!numbers || !(is_one_for_all || is_shape(particles.size()) || is_shape(particles.slots())))
    throw InputError(fmt::format(
        "the user force {} returned {}, but must return force densities [N/m3] of the shape (3,) for all particles, ({}, 3) per particle or ({}, 3) per slot.",
        name, what, particles.size(), particles.slots()));
  const std::span<const std::uint32_t> slots = particles.slot_of();
  if (is_one_for_all) {
    const Vec3d force{numbers.at(0), numbers.at(1), numbers.at(2)};
    for (const std::uint32_t slot : slots) density.set(slot, force);
    return;
  }
  const bool is_by_slot = is_shape(particles.slots());
  const fccda::ConstVectors forces = vectors_in(numbers, "the user force " + name);
  for (std::size_t i = 0; i < slots.size(); ++i) density.set(slots[i], forces[is_by_slot ? slots[i] : i]);
}

/// Sets a flag while in scope.
class Flag {
 public:
  explicit Flag(bool& flag) : flag_(flag) { flag_ = true; }
  ~Flag() { flag_ = false; }
  Flag(const Flag&) = delete;
  Flag& operator=(const Flag&) = delete;

 private:
  bool& flag_;
};

}  // namespace

std::shared_ptr<Run> Run::of(deck::Deck deck, const std::vector<UserForceFunction>& forces, const std::vector<StructureOfPython>& structures) {
  auto run = std::make_shared<Run>(std::move(deck));
  const Setup& setup = run->setup();
  std::vector<std::string> names;
  for (const BodySetup& body : setup.bodies) names.push_back(body.name);
  std::vector<UserForceOnBody> given;
  for (const UserForceFunction& force : forces) {
    const auto body = std::find(names.begin(), names.end(), force.body);
    if (body == names.end())
      throw InputError(fmt::format("forces refers to body {}, which does not exist; {}", force.body, deck::suggestion(force.body, names)));
    given.push_back(run->given(static_cast<std::size_t>(body - names.begin()), force));
    run->of_python_.push_back(force.function);
  }
  for (const StructureOfPython& structure : structures) run->of_python_.push_back(structure.object);
  run->being_made_.resize(names.size(), nullptr);
  use_chosen_threads();
  std::unique_ptr<Simulation> made;
  {
    const py::gil_scoped_release release;
    with_places(run->deck_, [&] {
      Start start(setup);
      if (!structures.empty()) {
        const py::gil_scoped_acquire acquire;
        attach(structures, start.impactors, run->calls_);
      }
      made = std::make_unique<Simulation>(setup, std::move(start), std::move(given));
    });
  }
  run->simulation_ = std::move(made);  // with the GIL: other threads may have a body that a user force was given
  run->note_clock();
  run->has_structures_ = !structures.empty();
  run->loop_.emplace(*run->simulation_);
  const auto row = run->simulation().monitors().row();
  run->rows_.emplace_back(row.begin(), row.end());
  return run;
}

UserForceOnBody Run::given(std::size_t body, const UserForceFunction& force) {
  return {body, force.name, [this, body, name = force.name, function = force.function](double time, const Body& particles, VectorArray& density) {
            add_user_force(body, name, *function, time, particles, density);
          }};
}

void Run::add_user_force(std::size_t index, const std::string& name, const py::object& function, double time, const Body& body, VectorArray& density) {
  const std::string full_name = body.name + "." + name;
  calls_.call("the user force " + full_name, [&] {
    if (!function) throw RunError(fmt::format("the user force {} was deleted with its simulation.", full_name));
    if (!is_made()) being_made_[index] = &body;
    try {
      spread(function(time, BodyOfRun{{py::cast(shared_from_this()), this, index}}), full_name, body.particles, density);
    } catch (...) {
      if (!is_made()) being_made_[index] = nullptr;
      throw;
    }
    if (!is_made()) being_made_[index] = nullptr;
  });
}

int Run::traverse(visitproc visit, void* arg) const {
  if (weak_from_this().use_count() > 1) return 0;  // another owner, which the collector does not see
  for (const std::shared_ptr<py::object>& object : of_python_) Py_VISIT(object->ptr());
  return 0;
}

void Run::release() {
  if (weak_from_this().use_count() > 1) return;
  for (const std::shared_ptr<py::object>& object : of_python_) *object = py::object();
}

Simulation& Run::between_steps() const {
  turns_.wait_for_step();
  return *simulation_;
}

Clock Run::clock() const {
  const std::lock_guard lock(clock_mutex_);
  return clock_;
}

const Body& Run::body(std::size_t index) const {
  if (is_made()) return between_steps().bodies()[index];
  if (being_made_[index]) return *being_made_[index];
  throw RunError("this body belongs to a simulation that failed to build.");
}

void Run::expect_usable() const {
  if (is_busy_) throw RunError("the simulation is in the middle of a step; a user force or another thread cannot start another one.");
  if (!is_whole_)
    throw RunError("the previous step was aborted by an error, so the state is inconsistent; create a new simulation, or resume from a checkpoint.");
}

bool Run::is_there(std::optional<double> until) const {
  const Clock& clock = simulation_->clock();
  constexpr double rounding = 1e-9;  // fraction of a step
  return clock.is_finished() || (until && clock.time() >= *until - rounding * clock.dt);
}

void Run::step() {
  expect_usable();
  const long step = simulation_->clock().step;
  if (simulation_->clock().is_finished())
    throw RunError(fmt::format("the run is over at {:.6g} s, after {} steps; set a later time.end to continue.", simulation_->clock().time(), step));
  while (simulation_->clock().step == step) advance({}, 1);  // an increment of a relaxation is paused to check for signals
}

void Run::run(std::optional<double> until, const py::object& after_steps, long every, const py::object& self) {
  if (every < 1) throw InputError(fmt::format("every is {}, but it must be a number of steps, at least 1.", every));
  if (until && std::isnan(*until)) throw InputError("until is nan, but it must be a time [s].");
  expect_usable();
  // With results, a signal that comes while the callback runs leaves a checkpoint, too; SIGINT raises KeyboardInterrupt within it.
  std::optional<StopSignals> signals;
  if (folder_) signals.emplace(StopSignals::Interrupts::left);
  long called_at = simulation_->clock().step;
  while (!is_there(until)) {
    const long to_call = called_at + every - simulation_->clock().step;
    advance(until, after_steps.is_none() ? std::numeric_limits<long>::max() : to_call);
    if (after_steps.is_none() || simulation_->clock().step < called_at + every) continue;
    called_at = simulation_->clock().step;
    const py::object go_on = after_steps(self);
    if (StopSignals::pending() != 0) throw_if_interrupted();
    if (!go_on.is_none() && !py::bool_(go_on)) return;
  }
}

void Run::advance(std::optional<double> until, long most) {
  expect_usable();  // the callback may have performed steps
  if (is_there(until)) return;
  {
    const Flag busy(is_busy_);
    turns_.let_others_read();
    use_chosen_threads();
    take_steps(until, most);
  }
  throw_if_interrupted();
}

void Run::take_steps(std::optional<double> until, long most) {
  // User forces run Python code, in which Python's handler would raise KeyboardInterrupt and leave the step incomplete. So signals are recorded
  // during steps, and handed to Python between them.
  const StopSignals signals(StopSignals::Interrupts::recorded);
  const Turns::Step step(turns_);
  const py::gil_scoped_release release;
  const auto leave_at = std::chrono::steady_clock::now() + between_looks_for_signals;
  const auto may_continue = [&] { return std::chrono::steady_clock::now() <= leave_at && !turns_.others_wait(); };
  long done = 0;
  is_whole_ = false;
  try {
    loop_->run({.after_step =
                    [&] {
                      note_clock();
                      note_step();
                      return ++done < most && !is_there(until) && may_continue();
                    },
                .in_increment = may_continue});
  } catch (const RunError&) {  // the loop has closed the results
    end_failed_results("");
    calls_.rethrow();
    throw;
  } catch (const std::exception& error) {
    end_failed_results(error.what());
    throw;
  }
  is_whole_ = true;
  if (folder_ && !loop_->has_results()) end_results();  // finished
}

void Run::note_clock() {
  const std::lock_guard lock(clock_mutex_);
  clock_ = simulation_->clock();
}

void Run::note_step() {
  const Monitors& monitors = simulation_->monitors();
  if (!monitors.is_due(simulation_->clock())) return;
  const py::gil_scoped_acquire acquire;  // other threads may read the rows
  rows_.emplace_back(monitors.row().begin(), monitors.row().end());
}

void Run::throw_if_interrupted() {
  const int signal = StopSignals::take();
  if (signal != 0 && signal != SIGINT) {  // Python would end at once
    loop_->interrupt();
    folder_.reset();
    std::signal(signal, SIG_DFL);  // as it was, but run() may still record it
    std::raise(signal);
  }
  if (signal == SIGINT) PyErr_SetInterrupt();
  if (PyErr_CheckSignals() == 0) return;
  const py::error_already_set exception;
  loop_->save();
  throw exception;
}

void Run::write_results(const std::optional<std::filesystem::path>& folder, bool resume, bool overwrite) {
  expect_usable();
  if (folder_) throw InputError("results are already being written; call write_results once, before the first step.");
  if (simulation_->clock().step > 0)
    throw InputError(fmt::format("step {} is done, but results begin at t = 0; call write_results before the first step.", simulation_->clock().step));
  if (resume && has_structures_)
    throw InputError("write_results was given resume=True, but checkpoints do not contain the state of structures; start the run again with overwrite=True.");
  if (resume && overwrite) throw InputError("write_results was given both resume and overwrite; a run is either resumed or replaced.");
  const std::filesystem::path path = worded([&] { return results_path(folder ? folder->string() : setup().output.folder, "write_results"); });
  use_chosen_threads();
  const EarlierRun earlier = resume ? EarlierRun::resume : overwrite ? EarlierRun::replace : EarlierRun::keep;
  with_places(deck_, [&] {
    std::optional<RunFolder> claimed(
        std::in_place, path, earlier,
        Requests{.resume = fmt::format("write_results(\"{}\", resume=True)", path.string()), .replace = "overwrite=True", .folder = "choose another folder"},
        setup());
    loop_->begin_results(*claimed);
    folder_.emplace(std::move(*claimed));
  });
  std::vector<std::string> notes = folder_->notes();
  if (!loop_->note().empty()) notes.push_back(loop_->note());
  for (const std::string& note : notes)
    if (PyErr_WarnEx(PyExc_UserWarning, note.c_str(), 1) != 0) throw py::error_already_set();
  if (!resume) return;
  note_clock();
  const auto row = simulation_->monitors().row();
  rows_.assign(1, {row.begin(), row.end()});
}

void Run::close_results() {
  if (is_busy_) throw RunError("the simulation is in the middle of a step; close the results between steps, such as in the callback of run.");
  use_chosen_threads();
  end_results();
}

void Run::end_results() {
  if (!folder_) return;
  if (is_whole_) loop_->interrupt();  // of a finished run, the results are closed
  report_on(*std::exchange(folder_, std::nullopt));
}

/// `failure`: where the loop has not closed the results as those of a failed run.
void Run::end_failed_results(const std::string& failure) {
  if (!folder_) return;
  RunFolder folder = *std::exchange(folder_, std::nullopt);
  try {
    if (!failure.empty()) {
      const double seconds = loop_->seconds();
      loop_.emplace(*simulation_);  // closes the files
      output::write_whole_file(output::ResultsFolder::run_in(folder.path()), run_report(*simulation_, Outcome::failed, failure, seconds, {}).text());
    }
    report_on(std::move(folder));
  } catch (const std::exception&) {
    // the first error is the one to report
  }
}

void Run::report_on(RunFolder folder) const { report::write_report(folder.path()); }

}  // namespace perimpact::python
