/// A simulation in Python, with the locations of its set-up for messages, user forces, history and output files.
#pragma once

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "arrays.hpp"
#include "io/deck/deck.hpp"
#include "perimpact/simulation/simulation.hpp"
#include "run/run_folder.hpp"
#include "run/run_loop.hpp"
#include "structures.hpp"

namespace perimpact::python {

/// The argument `forces`: {"plate": {"spring": function}}.
struct UserForceFunction {
  std::string body, name;
  py::function function;
};

class Run : public std::enable_shared_from_this<Run> {
 public:
  /// Throws InputError with the location in the deck, and whatever the functions throw.
  static std::shared_ptr<Run> of(deck::Deck deck, const std::vector<UserForceFunction>& forces, const std::vector<StructureOfPython>& structures);
  explicit Run(deck::Deck deck) : deck_(std::move(deck)) {}

  const Setup& setup() const { return deck_.setup; }
  Simulation& simulation() const { return *simulation_; }
  const Body& body(std::size_t index) const;
  bool is_made() const { return simulation_ != nullptr; }

  /// Performs one step or increment. Other Python threads continue meanwhile, here and in run().
  void step();

  /// Runs until the time [s] or the end of the run. The callback is called with `self` after every `every` steps; if it returns False, the
  /// function returns. On a signal (Ctrl-C) a checkpoint is written if output is enabled, and Python's exception is thrown.
  void run(std::optional<double> until, const py::object& after_steps, long every, const py::object& self);

  void write_results(const std::optional<std::string>& folder, bool resume, bool overwrite);
  void close_results();

  const std::vector<std::vector<double>>& rows() const { return rows_; }  ///< rows of the history

 private:
  UserForceOnBody given(std::size_t body, const UserForceFunction& force);
  void add_user_force(std::size_t index, const std::string& name, const py::function& function, double time, const Body& body, VectorArray& density);
  void expect_usable() const;
  bool is_there(std::optional<double> until) const;
  void advance(std::optional<double> until, long most);
  void note_step();
  void throw_if_interrupted();

  deck::Deck deck_;
  std::vector<const Body*> being_made_;  // bodies so far, while the constructor of the simulation calls user forces
  std::unique_ptr<Simulation> simulation_;
  std::vector<std::vector<double>> rows_;
  std::optional<RunFolder> folder_;  // while results are written
  std::optional<RunLoop> loop_;
  bool has_structures_ = false;  // whose state checkpoints lack
  bool is_busy_ = false;         // during a step
  bool is_whole_ = true;         // false after a step was aborted by an exception
};

/// Handle of a body of a run in Python.
struct BodyOfRun {
  std::shared_ptr<Run> run;
  std::size_t index;
  const Body& get() const { return run->body(index); }
};

/// Handle of an impactor of a run in Python.
struct ImpactorOfRun {
  std::shared_ptr<Run> run;
  std::size_t index;
  const Impactor& get() const { return run->simulation().impactors()[index]; }
};

}  // namespace perimpact::python
