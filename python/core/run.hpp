/// A simulation in Python, with the locations of its set-up for messages, user forces, history and output files.
#pragma once

#include <chrono>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "arrays.hpp"
#include "io/deck/deck.hpp"
#include "perimpact/simulation/simulation.hpp"
#include "run/run_folder.hpp"
#include "run/run_loop.hpp"
#include "structures.hpp"
#include "turns.hpp"
#include "user_calls.hpp"

namespace perimpact::python {

/// The argument `forces`: {"plate": {"spring": function}}.
struct UserForceFunction {
  std::string body, name;
  std::shared_ptr<py::object> function;  // kept()
};

class Run : public std::enable_shared_from_this<Run> {
 public:
  /// Throws InputError with the location in the deck, and whatever the functions throw.
  static std::shared_ptr<Run> of(deck::Deck deck, const std::vector<UserForceFunction>& forces, const std::vector<StructureOfPython>& structures);
  explicit Run(deck::Deck deck) : deck_(std::move(deck)) {}

  const Setup& setup() const { return deck_.setup; }
  Simulation& simulation() const { return *simulation_; }  ///< whose state may change during a step
  Simulation& between_steps() const;                       ///< after waiting for the end of a step; for as long as the caller keeps the GIL
  const Body& body(std::size_t index) const;               ///< between steps
  bool is_made() const { return simulation_ != nullptr; }
  Clock clock() const;  ///< after the last complete step, without waiting

  /// Performs one step or increment. Other Python threads continue meanwhile, here and in run().
  void step();

  /// Runs until the time [s] or the end of the run. The callback is called with `self` after every `every` steps; if it returns something
  /// false other than None, the function returns. On a signal (Ctrl-C) a checkpoint is written if output is enabled, and Python's exception is thrown.
  void run(std::optional<double> until, const py::object& after_steps, long every, const py::object& self);

  void write_results(const std::optional<std::filesystem::path>& folder, bool resume, bool overwrite);
  void close_results();

  const std::vector<std::vector<double>>& rows() const { return rows_; }  ///< rows of the history

  /// For the garbage collector (collected.hpp): user forces and structures.
  int traverse(visitproc visit, void* arg) const;
  void release();

 private:
  UserForceOnBody given(std::size_t body, const UserForceFunction& force);
  void add_user_force(std::size_t index, const std::string& name, const py::object& function, double time, const Body& body, VectorArray& density);
  void expect_usable() const;
  bool is_there(std::optional<double> until) const;
  void advance(std::optional<double> until, long most);
  void take_steps(std::optional<double> until, long most);
  void note_clock();
  void note_step();
  void throw_if_interrupted();
  void end_results();
  void end_failed_results(const std::string& failure);
  void report_on(RunFolder folder) const;

  deck::Deck deck_;
  Turns turns_;
  UserCalls calls_{turns_};
  std::vector<std::shared_ptr<py::object>> of_python_;  // user forces and structures
  std::vector<const Body*> being_made_;                 // bodies so far, while the constructor of the simulation calls user forces
  std::unique_ptr<Simulation> simulation_;
  std::vector<std::vector<double>> rows_;
  mutable std::mutex clock_mutex_;
  Clock clock_{};                    // copy for other threads
  std::optional<RunFolder> folder_;  // while results are written
  std::optional<RunLoop> loop_;
  bool has_structures_ = false;  // whose state checkpoints lack
  bool is_busy_ = false;         // during a step, and before it while other threads read
  bool is_whole_ = true;         // false after a step was aborted by an exception
};

/// What belongs to a run in Python. It refers to the object of Python, which alone owns the run, so that the garbage collector sees every reference.
struct PartOfRun {
  py::object simulation;
  Run* run;
  std::size_t index;

  int traverse(visitproc visit, void* arg) const {
    Py_VISIT(simulation.ptr());
    return 0;
  }
  void release() {}  // of a cycle, the run releases its references
};

/// Handle of a body of a run in Python.
struct BodyOfRun : PartOfRun {
  const Body& get() const { return run->body(index); }
};

/// Handle of an impactor of a run in Python.
struct ImpactorOfRun : PartOfRun {
  const Impactor& get() const { return run->between_steps().impactors()[index]; }
};

}  // namespace perimpact::python
