/// Fragment statistics of one body with a failure criterion:
///
///   fragments/<body>.csv       one row per frame: number and masses
///   fragments/<body>_end.csv   one row per fragment of two or more particles, at the end: position, extent, velocity
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "io/output/csv.hpp"
#include "io/output/json.hpp"
#include "io/output/results_folder.hpp"
#include "perimpact/body/body.hpp"
#include "perimpact/fragments/fragments.hpp"

namespace perimpact {

class FragmentTable {
 public:
  FragmentTable() = default;
  /// Resumes after the first `size` bytes of the table; 0: no table yet.
  FragmentTable(const output::ResultsFolder& folder, const std::string& body, std::uint64_t size);

  /// Call with each frame. `time` [s].
  void after_frame(const output::ResultsFolder& folder, const std::string& body, double time, const Fragments& fragments);

  void sync();                                                        ///< flushes all rows to disk
  std::uint64_t size() const { return table_ ? table_->size() : 0; }  ///< [byte]
  static std::filesystem::path table(const std::filesystem::path& results, const std::string& body) {
    return output::ResultsFolder::fragments_in(results) / (body + ".csv");
  }

 private:
  std::optional<output::CsvWriter> table_;  // opened by the first frame
};

/// Writes the table at the end, with at most the 10 000 heaviest fragments; null: only takes part in gathering it. Collective.
void write_last_fragments(const output::ResultsFolder* folder, const Body& body);

/// Fragment counts for run.json.
output::Json fragment_report(const FragmentCount& count);

}  // namespace perimpact
