/// What is watched while a run goes on: one row of history.csv at a time, and the checks that end a run that has gone wrong. Both look at ledgers that
/// sum from the start, and take differences; neither changes what it looks at, and neither depends on the other.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "perimpact/body/body.hpp"
#include "perimpact/body/sample.hpp"
#include "perimpact/boundary_conditions/boundary_conditions.hpp"
#include "perimpact/history/column.hpp"
#include "perimpact/impactor/impactor.hpp"
#include "perimpact/integrate/clock.hpp"
#include "perimpact/integrate/relax.hpp"
#include "perimpact/self_contact/short_range.hpp"

namespace perimpact {

class Monitors {
 public:
  /// Throws SetupError where a probe lies outside its body.
  Monitors(const OutputSetup& setup, std::span<const Body> bodies, const Clock& clock);

  /// True where a row ends with this step.
  bool is_due(const Clock& clock) const { return clock.step % interval_ == 0 || clock.is_finished(); }
  /// True where this step is checked. No setting of the output changes when.
  bool is_checked(const Clock& clock) const { return clock.step % check_interval_ == 0 || clock.is_finished(); }
  /// True where one of both is so, and the elastic energy is needed.
  bool samples_step(const Clock& clock) const { return is_due(clock) || is_checked(clock); }

  /// Elastic energy [J] of each body, for a step that is watched.
  std::vector<double>& elastic_energy() { return elastic_; }

  /// What is watched.
  struct Scene {
    std::span<const Body> bodies;
    std::span<const BoundaryConditions> boundary_conditions;  // of each body
    std::span<const Impactor> impactors;
    const Clock& clock;
    const std::optional<ShortRange>& fragments;  // where they touch
    const Relaxed* relaxed;                      // how the increment ended, where bodies are relaxed
  };

  /// Checks a step that is watched, where it is its turn, and makes its row, where one is due. Throws RunError where numbers are not finite or
  /// energy appeared from nowhere.
  void watch(const Scene& scene);

  const std::vector<Column>& columns() const { return columns_; }
  std::span<const double> row() const { return row_; }  ///< the latest
  double row_time() const { return row_time_; }         ///< [s] of it

  /// As base/state.hpp says. The first row has been made.
  template <class Visitor>
  void visit_state(Visitor&& visit) {
    visit("row_time", row_time_);
    visit("first_energy", first_energy_);
    visit("first_balance", first_balance_);
    visit("row", std::span<double>(row_));
    visit("sums", std::span<double>(sums_));
    visit("sound_until", sound_until_);
  }

 private:
  /// Energy and momentum at the latest step.
  struct Balance {
    Vec3d momentum{};
    double energy = 0, work = 0;    // [J] there is, put in from outside
    double taken = 0, contact = 0;  // [J] by breaking and by friction of fragments, by contact with impactors
    double unpaid = 0;              // [J] Boundaries::half_kick()
    double ripple = 0;              // [J] of interpolated velocities
    double since_amid = 0;          // [J] that the half kick to this instant gave

    double sum() const { return energy - ripple + taken + contact - work; }  // constant but for the order of the scheme
  };
  /// What a column says beside its value.
  struct Of {
    std::string_view name, unit;
    ColumnKind kind;
    std::string_view meaning;
    bool is_load = false;
  };
  Balance balance_of(const Scene& scene);
  void make_row(const Scene& scene, const Balance& balance);
  void add_impactor(const Impactor& impactor);
  void add_body(const Scene& scene, std::size_t body);
  void add(std::string_view owner, const Of& of, double value);
  void add(std::string_view owner, const Of& of, const Vec3d& value);
  void add_mean(std::string_view owner, const Of& of, double sum);
  void add_mean(std::string_view owner, const Of& of, const Vec3d& sum);
  void check_numbers(const Scene& scene, double energy) const;
  void check_energy(const Scene& scene, double energy, double work, double unpaid, double contact_dissipation) const;

  long interval_, check_interval_;  // steps between rows, and between checks
  double row_time_ = 0;
  double per_second_ = 0;     // one over the interval of the row that is made
  std::vector<double> sums_;  // of the means, at the row before
  std::size_t next_sum_ = 0;  // in the row that is made
  long sound_until_ = 0;      // step of the latest check
  struct Probe {
    std::string name;
    std::size_t body;
    Sample sample;
  };
  std::vector<Probe> probes_;
  std::vector<double> elastic_, kinetic_;  // [J] of each body, at the step that is watched
  std::vector<Column> columns_;
  std::vector<double> row_;
  bool is_first_ = true;
  double first_energy_ = 0;   // [J]
  double first_balance_ = 0;  // [J]
};

}  // namespace perimpact
