/// The fragments of one body that may break, in numbers:
///
///   fragments/<body>.csv       a row each picture: how many, how heavy
///   fragments/<body>_end.csv   a row each fragment of two and more particles, at the end: where, how large, how fast
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
  /// Goes on behind the first `size` bytes of the table; there is none yet where that is 0.
  FragmentTable(const output::ResultsFolder& folder, const std::string& body, std::uint64_t size);

  /// Call with each picture. `time` [s].
  void after_frame(const output::ResultsFolder& folder, const std::string& body, double time, const Fragments& fragments);

  void sync();                                                        ///< all rows reach the disk
  std::uint64_t size() const { return table_ ? table_->size() : 0; }  ///< [byte]
  static std::filesystem::path table(const std::filesystem::path& results, const std::string& body) {
    return output::ResultsFolder::fragments_in(results) / (body + ".csv");
  }

 private:
  std::optional<output::CsvWriter> table_;  // opened by the first picture
};

/// The table at the end, of the 10 000 heaviest at most.
void write_last_fragments(const output::ResultsFolder& folder, const Body& body);

/// For run.json.
output::Json fragment_report(const FragmentCount& count);

}  // namespace perimpact
