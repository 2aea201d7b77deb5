/// Contact record of one impactor: panel loads, process pressure-area curve, and the bodies it has been in contact with. The process curve
/// uses the intervals between rows of the history; panel pressures and their peak use separate load intervals (Simulation), so that output
/// settings do not change them.
///
/// The process curve is the mean pressure over the whole contact while that grows (C. Daley, PERD/CHC Report 7-108, 2004, section 2):
///   p = F_n/A,   F_n = Σ J_n/T,   A = Σ Δ² (Δ h in a plane body of thickness h) over the particles in contact in the interval, each counted once
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "fccda/respond/panel_loads.hpp"

namespace perimpact {

class ContactRecord {
 public:
  struct Interval {
    double time = 0;               ///< [s] its end
    double contact_area = 0;       ///< [m²] faces of the particles in contact in it
    double mean_contact_area = 0;  ///< [m²] faces of the contacts of one step, mean over the steps
    double normal_force = 0;       ///< [N] into the surface, mean
    double mean_pressure() const { return contact_area > 0 ? normal_force / contact_area : 0; }  ///< [Pa]
  };

  /// The load interval of the largest normal force.
  struct Peak {
    double time = 0;                     ///< [s] its end
    double normal_force = 0;             ///< [N]
    std::vector<double> panel_pressure;  ///< [Pa]
  };

  /// `faces` [m²] of a particle of each body, in order.
  ContactRecord(const fccda::Surface& surface, std::span<const double> faces);

  void begin_step() { ++steps_; }
  void add(std::size_t body, const fccda::Contact& contact, const fccda::Vec3d& impulse);
  /// Adds particles newly in contact in this step; further passes may resolve a particle again.
  void count_in_contact(std::size_t body, std::size_t particles) { in_contact_[body].contacts += particles; }
  /// Closes the interval of the process curve that began `duration` [s] before `time` [s].
  void end_interval(double time, double duration);
  /// Closes the load interval of panel pressures.
  void end_load_interval(double time, double duration);

  const fccda::PanelLoads& panels() const { return panels_; }
  const Interval& interval() const { return interval_; }                          ///< the latest completed one
  const Peak& peak() const { return peak_; }                                      ///< without pressures if no normal force was positive
  bool was_in_contact(std::size_t body) const { return in_contact_[body].ever; }  ///< ever
  bool was_in_contact() const;                                                    ///< ever, any body

  /// See base/state.hpp.
  template <class Visitor>
  void visit_state(Visitor&& visit) {
    panels_.visit_state(fccda::under("panels", visit));
    for (std::size_t b = 0; b < in_contact_.size(); ++b) {
      Resolved& body = in_contact_[b];
      const auto named = [&](const char* what) { return std::to_string(b) + "." + what; };
      fccda::visit_flag(visit, named("was_in_contact"), body.ever);
      visit(named("contacts"), body.contacts);
      visit(named("particles"), body.particles);
    }
    visit("steps", steps_);
    fccda::visit_members(visit, "normal_impulse", std::array{&normal_impulse_, &load_impulse_});
    fccda::visit_members(visit, "interval", std::array{&interval_.time, &interval_.contact_area, &interval_.mean_contact_area, &interval_.normal_force});
    fccda::visit_members(visit, "peak", std::array{&peak_.time, &peak_.normal_force});
    visit("peak_pressure", peak_.panel_pressure);
  }

 private:
  struct Resolved {  // of one body
    double face;     // of a particle [m²]
    bool ever = false;
    std::size_t contacts = 0;                 // in the open interval
    std::vector<std::size_t> particles = {};  // in contact in it, ascending
  };

  fccda::PanelLoads panels_;
  std::vector<Resolved> in_contact_;  // of each body
  long steps_ = 0;                    // in the open interval
  double normal_impulse_ = 0;         // [N s] in it
  double load_impulse_ = 0;           // [N s] of the open load interval
  Interval interval_;
  Peak peak_;
};

}  // namespace perimpact
