/// What a run turns out to have been, known only at its end: impactors that never touched a body and how near they came, particles that
/// got inside where a surface is not felt.
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
  /// Looks at this moment of the run; `contact_ratio`: contact radius in spacings. While an impactor has not touched a body the distance of
  /// every particle is asked for, but only whether it is less than the least so far. Measured: 60 ms for 1.4
  /// million particles on two busy cores, a twelfth of one of their steps.
  void sample(std::span<const Body> bodies, std::span<const Impactor> impactors, double contact_ratio, double time);

  /// A sentence each.
  std::vector<std::string> warnings(std::span<const Body> bodies, std::span<const Impactor> impactors) const;

  /// As base/state.hpp says.
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
  /// Of one impactor with one body.
  struct Proximity {
    double nearest = fccda::Bvh::no_cap;  // [m] from the surface to a particle's contact sphere
    double nearest_time = 0;              // [s]
    std::optional<double> entered_by;     // [s] when particles were first seen inside
  };

  std::vector<std::vector<Proximity>> of_impactor_;  // and body
  std::vector<std::unique_ptr<fccda::Bvh>> trees_;   // of impactors that have not touched everything
  double time_ = 0;                                  // [s] of the last look
};

}  // namespace perimpact
