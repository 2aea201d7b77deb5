/// Proximity monitor: warnings at the end of a run about impactors without contact and their smallest distance, and about particles that
/// penetrated outside the contact bounds.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/state.hpp"
#include "mesh/search/bvh.hpp"
#include "perimpact/body/body.hpp"
#include "perimpact/impactor/impactor.hpp"

namespace perimpact {

class ProximityMonitor {
 public:
  /// Samples the current state; `contact_ratio`: contact radius in spacings. Until the first contact of an impactor with a body, the distance of
  /// every particle is searched below the smallest so far. Measured: 60 ms for 1.4 million particles on two busy cores, a twelfth of a step.
  void sample(std::span<const Body> bodies, std::span<const Impactor> impactors, double contact_ratio, double time);

  /// True if sample() reads the particles of this body: until each impactor has been in contact with it.
  static bool reads(std::size_t body, std::span<const Impactor> impactors);

  /// One sentence each; of many pairs without contact, one of them all.
  std::vector<std::string> warnings(std::span<const Body> bodies, std::span<const Impactor> impactors) const;

  /// See base/state.hpp.
  template <class Visitor>
  void visit_state(Visitor&& visit) {
    visit("time", time_);
    for (std::size_t i = 0; i < of_impactor_.size(); ++i)
      for (std::size_t b = 0; b < of_impactor_[i].size(); ++b) {
        Proximity& proximity = of_impactor_[i][b];
        auto its = fccda::under(std::to_string(i) + "." + std::to_string(b), visit);
        fccda::visit_members(its, "nearest", std::array{&proximity.nearest, &proximity.nearest_time});
        fccda::visit_optional(its, "entered_by", proximity.entered_by);
      }
  }

 private:
  std::vector<std::string> warnings_of_distance(std::span<const Body> bodies, std::span<const Impactor> impactors) const;

  /// Of one impactor with one body.
  struct Proximity {
    double nearest = fccda::Bvh::no_cap;  // [m] from the surface to a particle's contact sphere
    double nearest_time = 0;              // [s]
    std::optional<double> entered_by;     // [s] first sample with particles inside
  };

  std::vector<std::vector<Proximity>> of_impactor_;  // and body
  std::vector<std::unique_ptr<fccda::Bvh>> trees_;   // of impactors without contact with some body
  double time_ = 0;                                  // [s] of the last sample
};

}  // namespace perimpact
