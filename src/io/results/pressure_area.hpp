/// The pressure-area curves of one impactor, written where it touched something:
///
///   pressure_area/<impactor>.csv           process curve: a row each interval of the history, from the first with contact
///   pressure_area/<impactor>_at_peak.csv   spatial curve of the interval of the largest normal force (fccda/respond/nested_areas.hpp)
#pragma once

#include <optional>
#include <string>

#include "io/output/csv.hpp"
#include "io/output/results_folder.hpp"
#include "perimpact/impact/impactor.hpp"

namespace perimpact {

class PressureArea {
 public:
  /// Call when an interval has ended.
  void after_interval(const output::ResultsFolder& folder, const Impactor& impactor);
  /// Writes the spatial curve.
  void finish(const output::ResultsFolder& folder, const Impactor& impactor) const;

 private:
  std::optional<output::CsvWriter> process_;  // opened by the first contact
};

}  // namespace perimpact
