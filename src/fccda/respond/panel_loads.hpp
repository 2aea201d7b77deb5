/// Contact loads of each panel: impulse since the start, mean pressure over an interval, and the largest interval pressure.
///
///   p = J_n/(A T)    J_n normal impulse [N s] on the panel of area A [m²] in the time T [s]
///
/// A point represents a face of its body (on a lattice: Δ²), but its impulse acts on one panel. On panels smaller than the face, a few
/// panels would have too high a pressure, by the ratio of the areas, and those between them none. Such an impulse is therefore distributed,
/// in proportion to area, over the surrounding panels whose centres lie in a disc of the size of the face (PanelFaces::around). Sums over
/// panels do not change.
///
/// An impulse is recorded at the panel in contact, at the cost of two additions, and distributed at the end of the interval. For use as the
/// report of respond():
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

/// Load of one panel.
struct PanelLoad {
  Vec3d impulse{};            ///< [N s] on the panel, in world axes
  double normal_impulse = 0;  ///< [N s] into the surface

  PanelLoad& operator+=(const PanelLoad& b) {
    impulse += b.impulse, normal_impulse += b.normal_impulse;
    return *this;
  }
  friend PanelLoad operator*(double s, const PanelLoad& a) { return {s * a.impulse, s * a.normal_impulse}; }
};

/// Loads of all panels of a surface.
class PanelLoads {
 public:
  /// `face_areas` [m²]: for each kind of points (each body), the area that one of its points represents; 0: impulses are not distributed.
  PanelLoads(const Surface& surface, std::span<const double> face_areas);

  /// Adds the impulse of one contact. Contacts without a panel (of analytic shapes) are ignored.
  void add(std::size_t kind, const Contact& contact, const Vec3d& impulse);

  /// Closes an interval of the given duration [s]; if it is 0, its impulses do not enter the pressures.
  void end_interval(double duration);

  std::vector<PanelLoad> since_start() const;                               ///< of each panel, including the open interval
  std::span<const double> interval_pressure() const { return pressure_; }   ///< [Pa] mean over the last closed interval
  std::span<const double> peak_pressure() const { return peak_pressure_; }  ///< [Pa] largest interval pressure so far
  const PanelFaces& faces() const { return faces_; }

  /// State for checkpoints (base/state.hpp). The distribution of impulses among panels is recomputed.
  template <class Visitor>
  void visit_state(Visitor&& visit) {
    visit_loads(visit, "before", before_);
    visit("pressure", std::span<double>(pressure_));
    visit("peak_pressure", std::span<double>(peak_pressure_));
    for (std::size_t k = 0; k < kinds_.size(); ++k) {
      visit(std::to_string(k) + ".hit", kinds_[k].hit);  // in this order, since it is the order of summation
      visit_loads(visit, std::to_string(k) + ".pushes", kinds_[k].pushes);
    }
    rebuild_derived();
  }

 private:
  struct Share {
    int panel;
    double share;  // of the total area of the list
  };
  struct Kind {
    double face_area;
    std::vector<PanelLoad> pushes;           // impulses of this interval, by panel in contact
    std::vector<bool> is_hit;                // in contact in this interval
    std::vector<int> hit;                    // those panels, in the order of their first contact
    std::vector<std::vector<Share>> shares;  // of each panel that has been in contact
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
  void rebuild_derived();  // recomputes derived data after the visitor may have written the state

  PanelFaces faces_;
  std::vector<Kind> kinds_;
  std::vector<PanelLoad> before_;  // of the closed intervals
  std::vector<double> pressure_, peak_pressure_;
  std::vector<int> pressed_;  // panels whose pressure_ is not 0
};

}  // namespace fccda
