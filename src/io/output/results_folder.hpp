/// The folder that a run leaves behind, and the one place that knows its names:
///
///   run.json   history.csv   lines/<line>_t<seconds>.csv   frames/<body>_00000.vtp, …   frames/<body>.pvd
///   pressure_area/<impactor>.csv, <impactor>_at_peak.csv
///
/// `check` writes into check/, which runs leave alone.
#pragma once

#include <filesystem>
#include <string_view>

namespace perimpact::output {

/// Creates the folder with those above it and writes a trial file. Throws InputError where that fails: better now than after an
/// hour of computing.
void prepare_folder(const std::filesystem::path& folder);

/// A prepared results folder without the files of an earlier run, so that two runs never mix. Files of any other name are kept.
class ResultsFolder {
 public:
  explicit ResultsFolder(std::filesystem::path folder);

  std::filesystem::path run() const { return folder_ / "run.json"; }
  std::filesystem::path history() const { return folder_ / "history.csv"; }
  std::filesystem::path frames() const { return folder_ / "frames"; }
  std::filesystem::path pressure_area() const { return folder_ / "pressure_area"; }
  std::filesystem::path line(std::string_view name, double time) const;  ///< time in [s]

 private:
  std::filesystem::path folder_;
};

}  // namespace perimpact::output
