/// Monitors of a run: rows of history.csv, and checks of finite values and energy balance that end an invalid run. Both take differences of
/// cumulative ledgers, do not modify the state, and are independent of each other.
#pragma once

#include <cstdint>
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
#include "perimpact/moving_window/moving_window.hpp"
#include "perimpact/self_contact/short_range.hpp"

namespace perimpact {

class Monitors {
 public:
  /// Throws SetupError if a probe lies outside its body.
  Monitors(const OutputSetup& setup, std::span<const Body> bodies, const Clock& clock);

  long interval() const { return interval_; }  ///< steps between rows
  /// True if a row ends with this step.
  bool is_due(const Clock& clock) const { return clock.step % interval_ == 0 || clock.is_finished(); }
  /// True if this step is checked, independent of output settings.
  bool is_checked(const Clock& clock) const { return clock.step % check_interval_ == 0 || clock.is_finished(); }
  /// True if either applies, so that the elastic energy is needed.
  bool samples_step(const Clock& clock) const { return is_due(clock) || is_checked(clock) || is_renewed_; }

  /// To be called after a sampled step in which material was added and discarded by moving windows. What energy changes by in the next step, which
  /// is sampled, is that of this material, and no error of the balance.
  void renew_balance() { is_renewed_ = true; }

  /// Elastic energy [J] of each body, for a sampled step.
  std::vector<double>& elastic_energy() { return elastic_; }

  /// Objects to be sampled.
  struct Scene {
    std::span<const Body> bodies;
    std::span<const MotionSums> motion;                       // of each
    std::span<const BoundaryConditions> boundary_conditions;  // of each
    std::span<const Impactor> impactors;
    const Clock& clock;
    const std::optional<ShortRange>& fragments;  // if contact of fragments is enabled
    std::span<const MovingWindow> windows;
    const Relaxed* relaxed;  // convergence of the increment, with time.relax
  };

  /// Slots of a body whose position, velocity and force density are read in this sampled step, but where sums are not finite: then all are.
  std::vector<std::uint32_t> slots_read(std::size_t body, std::span<const Impactor> impactors, const Clock& clock) const;

  /// Samples a step: checks it and creates a row if these are due. Throws RunError if values are not finite or energy increases without a
  /// source.
  void watch(const Scene& scene);

  const std::vector<Column>& columns() const { return columns_; }
  std::span<const double> row() const { return row_; }  ///< the latest
  double row_time() const { return row_time_; }         ///< [s] of the latest row
  /// The largest magnitude of each column so far, of all rows; NaN if one was.
  std::span<const double> largest() const { return largest_; }

  /// See base/state.hpp. Requires the first row.
  template <class Visitor>
  void visit_state(Visitor&& visit) {
    visit("row_time", row_time_);
    visit("first_energy", first_energy_);
    visit("first_balance", first_balance_);
    visit("row", std::span<double>(row_));
    visit("largest", std::span<double>(largest_));
    visit("sums", std::span<double>(sums_));
    visit("sound_until", sound_until_);
    visit("latest_balance", latest_balance_);
    visit("discarded_energy", discarded_energy_);
  }

 private:
  /// Energy and momentum at the latest step.
  struct Balance {
    Vec3d momentum{};
    double energy = 0, work = 0;    // [J] current, and external work
    double taken = 0, contact = 0;  // [J] dissipated by fracture and friction of fragments, and by contact with impactors
    double unpaid = 0;              // [J] BoundaryConditions::half_kick()
    double ripple = 0;              // [J] of interpolated velocities
    double since_amid = 0;          // [J] of the half kick to this instant
    double elsewhere = 0;           // [J] of structures that another program moves and loads
    double from_elsewhere = 0;      // [J] done by them in contact

    double sum() const { return energy - ripple + taken + contact - work; }  // constant up to the order of the scheme
  };
  static void add_structure(const DeformingPart& part, double contact_work, Balance& of);
  void add_structure_columns(const std::string& name, const DeformingPart& part);
  /// Description of a column.
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
  void renew_balance(double change);
  void check_numbers(const Scene& scene, double energy) const;
  void check_energy(const Scene& scene, double energy, double work, double unpaid, double contact_dissipation) const;

  long interval_, check_interval_;  // steps between rows, and between checks
  double row_time_ = 0;
  double per_second_ = 0;     // one over the interval of the current row
  std::vector<double> sums_;  // of interval means, at the previous row
  std::size_t next_sum_ = 0;  // in the current row
  long sound_until_ = 0;      // step of the latest check
  struct Probe {
    std::string name;
    std::size_t body;
    Sample sample;
  };
  std::vector<Probe> probes_;
  std::vector<double> elastic_, kinetic_;  // [J] of each body, at the sampled step
  std::vector<Column> columns_;
  std::vector<double> row_, largest_;
  bool is_first_ = true;
  double first_energy_ = 0;      // [J]
  double first_balance_ = 0;     // [J]
  double latest_balance_ = 0;    // [J] Balance::sum() of the latest sampled step
  double discarded_energy_ = 0;  // [J] cumulative, with material of moving windows
  bool is_renewed_ = false;      // material was added and discarded since the latest sampled step
};

}  // namespace perimpact
