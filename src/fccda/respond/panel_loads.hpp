/// What contact did to each panel: impulse since the start, mean pressure over an interval, and the largest of those.
///
///   p = J_n/(A T)    J_n normal impulse [N s] that the panel of area A [m²] took in the time T [s]
///
/// A point stands for a face of its body (of a lattice: Δ²), but its push lands on one panel. On panels smaller than the face the
/// pressure would be too high by the ratio of the two, on a few panels among many without any. So such a push is spread, in proportion
/// to area, over the panels around the one it landed on whose middles lie in a disc of the size of the face (PanelFaces::around). Sums
/// over panels stay what they are.
///
/// A push is noted where it lands, which costs two additions; it is spread at the end of an interval. For use as the report of
/// respond():
///   respond(points, contacts, motion, body, friction, [&](const Contact& contact, const Vec3d& impulse) { loads.add(kind, contact, impulse); });
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "base/state.hpp"
#include "fccda/detect/contact.hpp"
#include "mesh/panel_faces.hpp"

namespace fccda {

struct PanelLoad {
  Vec3d impulse{};            ///< [N s] on the panel, along the axes of the world
  double normal_impulse = 0;  ///< [N s] into the surface

  PanelLoad& operator+=(const PanelLoad& b) {
    impulse += b.impulse, normal_impulse += b.normal_impulse;
    return *this;
  }
  friend PanelLoad operator*(double s, const PanelLoad& a) { return {s * a.impulse, s * a.normal_impulse}; }
};

class PanelLoads {
 public:
  /// `face_areas` [m²]: one for each kind of points that strike (each body), the area that one of its points stands for; 0 spreads nothing.
  PanelLoads(const Surface& surface, std::span<const double> face_areas);

  /// Adds what one contact did. Contacts without a panel (of analytic shapes) are left out.
  void add(std::size_t kind, const Contact& contact, const Vec3d& impulse);

  /// Closes an interval of that duration [s]; where it is 0, the pushes count towards impulses only.
  void end_interval(double duration);

  std::vector<PanelLoad> since_start() const;                               ///< of each panel, the interval that is open included
  std::span<const double> interval_pressure() const { return pressure_; }   ///< [Pa] mean over the interval that ended last
  std::span<const double> peak_pressure() const { return peak_pressure_; }  ///< [Pa] the largest of these so far
  const PanelFaces& faces() const { return faces_; }

  /// As base/state.hpp says. Which panels share a push is found again.
  template <class Visitor>
  void visit_state(Visitor&& visit) {
    visit_loads(visit, "before", before_);
    visit("pressure", std::span<double>(pressure_));
    visit("peak_pressure", std::span<double>(peak_pressure_));
    for (std::size_t k = 0; k < kinds_.size(); ++k) {
      visit(std::to_string(k) + ".hit", kinds_[k].hit);  // their order is that of sums
      visit_loads(visit, std::to_string(k) + ".pushes", kinds_[k].pushes);
    }
    take_up();
  }

 private:
  struct Share {
    int panel;
    double share;  // of the area of all in the list
  };
  struct Kind {
    double face_area;
    std::vector<PanelLoad> pushes;           // of this interval, where they landed
    std::vector<bool> is_hit;                // in this interval
    std::vector<int> hit;                    // the panels that are, in the order of their first push
    std::vector<std::vector<Share>> shares;  // of each panel that was ever hit
  };

  std::vector<Share> shares_of(std::size_t panel, double face_area) const;
  template <class Visit>
  void spread(const Visit& visit) const;

  template <class Visitor>
  static void visit_loads(Visitor& visit, const std::string& name, std::vector<PanelLoad>& loads) {
    std::vector<double> values;
    for (const PanelLoad& load : loads) values.insert(values.end(), {load.impulse.x, load.impulse.y, load.impulse.z, load.normal_impulse});
    visit(name, std::span<double>(values));
    for (std::size_t k = 0; k < loads.size(); ++k) loads[k] = {{values[4 * k], values[4 * k + 1], values[4 * k + 2]}, values[4 * k + 3]};
  }
  void take_up();  // what follows from what a visitor may have written

  PanelFaces faces_;
  std::vector<Kind> kinds_;
  std::vector<PanelLoad> before_;  // of the intervals that have ended
  std::vector<double> pressure_, peak_pressure_;
  std::vector<int> pressed_;  // panels whose pressure_ is not 0
};

}  // namespace fccda
