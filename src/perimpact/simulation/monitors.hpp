/// What is watched while a run goes on: one row of history.csv at a time, and the checks that end a run that has gone wrong.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "perimpact/boundary/boundaries.hpp"
#include "perimpact/force/short_range.hpp"
#include "perimpact/impact/impactor.hpp"
#include "perimpact/simulation/body.hpp"
#include "perimpact/simulation/clock.hpp"
#include "perimpact/simulation/relax.hpp"
#include "perimpact/simulation/sample.hpp"

namespace perimpact {

class Monitors {
 public:
  /// Throws SetupError where a probe lies outside its body.
  Monitors(const OutputSetup& setup, std::span<const Body> bodies, const Clock& clock);

  /// True where a row ends with this step, so that forces() must also say the elastic energy.
  bool is_due(const Clock& clock) const { return clock.step % interval_ == 0 || clock.is_finished(); }

  /// Elastic energy [J] of each body, for the row that is due.
  std::vector<double>& elastic_energy() { return elastic_; }

  /// Makes the row of this step and checks it. `relaxed`: how the increment ended, where bodies are relaxed; `fragments`: where they touch. Throws RunError
  /// where numbers are not finite or energy appeared from nowhere.
  void record(std::span<const Body> bodies, std::span<Boundaries> boundaries, std::span<Impactor> impactors, const Clock& clock,
              const Relaxed* relaxed = nullptr, const std::optional<ShortRange>& fragments = {});

  const std::vector<std::string>& columns() const { return columns_; }  ///< "cylinder.velocity_y [m/s]"
  std::span<const double> row() const { return row_; }                  ///< the latest

  /// As fccda/core/state.hpp says. The first row has been made.
  template <class Visitor>
  void visit_state(Visitor&& visit) {
    visit("row_time", row_time_);
    visit("first_energy", first_energy_);
    visit("first_balance", first_balance_);
    visit("row", std::span<double>(row_));
  }

 private:
  void add(const std::string& column, double value);
  void add_vector(const std::string& owner, const char* quantity, const char* unit, const Vec3d& value);
  void check_numbers(std::span<const Body> bodies, const Clock& clock, double energy) const;
  void check_energy(std::span<const Body> bodies, const Clock& clock, double energy, double work, double unpaid, double contact_loss) const;

  long interval_;  // steps between rows
  double row_time_ = 0;
  struct Probe {
    std::string name;
    std::size_t body;
    Sample sample;
  };
  std::vector<Probe> probes_;
  std::vector<double> elastic_;
  std::vector<std::string> columns_;
  std::vector<double> row_;
  bool is_first_ = true;
  double first_energy_ = 0;   // [J]
  double first_balance_ = 0;  // [J]
};

}  // namespace perimpact
