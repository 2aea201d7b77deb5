/// The pressure-area curves of one impactor, written if it has been in contact:
///
///   pressure_area/<impactor>.csv           process curve: one row per history interval, from the first with contact
///   pressure_area/<impactor>_at_peak.csv   spatial curve of the load interval of the largest normal force (fccda/respond/nested_areas.hpp)
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "io/output/csv.hpp"
#include "io/output/results_folder.hpp"
#include "perimpact/impactor/impactor.hpp"

namespace perimpact {

class PressureArea {
 public:
  PressureArea() = default;
  /// Resumes after the first `size` bytes of the process curve; 0: no curve yet.
  PressureArea(const output::ResultsFolder& folder, const std::string& impactor, std::uint64_t size);

  /// Call at the end of each history interval.
  void after_interval(const output::ResultsFolder& folder, const Impactor& impactor);
  /// Writes the spatial curve.
  void finish(const output::ResultsFolder& folder, const Impactor& impactor) const;

  void sync();                                                            ///< flushes all rows to disk
  std::uint64_t size() const { return process_ ? process_->size() : 0; }  ///< [byte] of the process curve
  static std::filesystem::path process_curve(const std::filesystem::path& results, const std::string& impactor) {
    return output::ResultsFolder::pressure_area_in(results) / (impactor + ".csv");
  }

 private:
  std::optional<output::CsvWriter> process_;  // opened by the first contact
};

}  // namespace perimpact
