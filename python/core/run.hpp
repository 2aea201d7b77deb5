/// A simulation with what goes along with it: where its set-up says what, own forces in Python, its history so far, and the files that it leaves.
#pragma once

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "arrays.hpp"
#include "io/checkpoint/checkpoints.hpp"
#include "io/deck/deck.hpp"
#include "io/results/results_writer.hpp"
#include "perimpact/simulation/simulation.hpp"

namespace perimpact::python {

/// What the keyword `forces` holds: {"plate": {"spring": function}}
struct OwnForceFunction {
  std::string body, name;
  py::function function;
};

class Run : public std::enable_shared_from_this<Run> {
 public:
  /// Throws InputError, which names the place in the deck, and what the functions throw.
  static std::shared_ptr<Run> of(deck::Deck deck, const std::vector<OwnForceFunction>& forces);
  explicit Run(deck::Deck deck) : deck_(std::move(deck)) {}

  const Setup& setup() const { return deck_.setup; }
  Simulation& simulation() const { return *simulation_; }
  const Body& body(std::size_t index) const;
  bool is_made() const { return simulation_ != nullptr; }

  /// One step or increment. The other threads of Python go on meanwhile, here and in run().
  void step();

  /// Steps until the time is reached [s] or the run is over. `after_steps` is called with `self` after each such number of steps; where it returns False,
  /// this is left. Where a signal came (Ctrl-C), a checkpoint is written if results are, and Python's exception thrown.
  void run(std::optional<double> until, const py::object& after_steps, long every, const py::object& self);

  void write_results(const std::optional<std::string>& folder, bool resume);
  void close_results();

  const std::vector<std::vector<double>>& rows() const { return rows_; }  ///< of the history

 private:
  using Instant = std::chrono::steady_clock::time_point;

  UserForceOnBody given(std::size_t body, const OwnForceFunction& force);
  void add_own_force(std::size_t index, const std::string& name, const py::function& function, double time, const Body& body, VectorArray& density);
  void expect_usable() const;
  bool is_there(std::optional<double> until) const;
  void advance(std::optional<double> until, long most);
  bool step_once(Instant leave_at);
  void note_step();
  void throw_if_interrupted();

  deck::Deck deck_;
  std::vector<const Body*> being_made_;  // while the constructor of the simulation calls own forces
  std::unique_ptr<Simulation> simulation_;
  std::vector<std::vector<double>> rows_;
  std::optional<Checkpoints> checkpoints_;
  std::optional<ResultsWriter> results_;
  std::filesystem::path results_folder_;
  double seconds_ = 0;    // on the wall, spent in steps
  bool is_busy_ = false;  // in a step
  bool is_whole_ = true;  // no step was left by an exception
};

/// A body of a run, as Python holds it.
struct BodyOfRun {
  std::shared_ptr<Run> run;
  std::size_t index;
  const Body& get() const { return run->body(index); }
};

/// An impactor likewise.
struct ImpactorOfRun {
  std::shared_ptr<Run> run;
  std::size_t index;
  const Impactor& get() const { return run->simulation().impactors()[index]; }
};

}  // namespace perimpact::python
