/// Results folder of a run; the only file that defines its file names:
///
///   run.json   history.csv   history.json   lines/<line>_t<seconds>.csv   frames/<body>_00000.vtp, …   frames/<body>.pvd
///   pressure_area/<impactor>.csv, <impactor>_at_peak.csv   fragments/<body>.csv, <body>_end.csv   checkpoint.h5   report.html
///   open_in_paraview.py
///
/// `perimpact statistics` adds statistics.csv, windows.csv, spectrum.csv and fragments/<body>_channel_x.csv, which are removed with the run that
/// they describe. `check` writes to check/, which runs leave unchanged.
#pragma once

#include <filesystem>
#include <string_view>

namespace perimpact::output {

/// Creates the folder with its parents and writes a trial file. Throws InputError where that fails, before the computation begins.
void prepare_folder(const std::filesystem::path& folder);

enum class EarlierRun { removed, continued };

/// A prepared results folder without the files of an earlier run, so that two runs never mix. Files of any other name are kept. For a
/// restart, the files of the run are kept except partial ones, run.json, report.html and open_in_paraview.py, which describe how a run ended.
class ResultsFolder {
 public:
  explicit ResultsFolder(std::filesystem::path folder, EarlierRun earlier = EarlierRun::removed);

  const std::filesystem::path& path() const { return folder_; }
  std::filesystem::path run() const { return run_in(folder_); }
  std::filesystem::path history() const { return history_in(folder_); }
  std::filesystem::path history_columns() const { return history_columns_in(folder_); }
  std::filesystem::path frames() const { return frames_in(folder_); }
  std::filesystem::path lines() const { return folder_ / "lines"; }
  std::filesystem::path pressure_area() const { return pressure_area_in(folder_); }
  std::filesystem::path fragments() const { return fragments_in(folder_); }
  std::filesystem::path checkpoint() const { return checkpoint_in(folder_); }
  std::filesystem::path line(std::string_view name, double time) const;  ///< time in [s]

  // for a folder that need not be prepared
  static std::filesystem::path history_in(const std::filesystem::path& folder) { return folder / "history.csv"; }
  static std::filesystem::path history_columns_in(const std::filesystem::path& folder) { return folder / "history.json"; }
  static std::filesystem::path pressure_area_in(const std::filesystem::path& folder) { return folder / "pressure_area"; }
  static std::filesystem::path frames_in(const std::filesystem::path& folder) { return folder / "frames"; }
  static std::filesystem::path run_in(const std::filesystem::path& folder) { return folder / "run.json"; }
  static std::filesystem::path fragments_in(const std::filesystem::path& folder) { return folder / "fragments"; }
  static std::filesystem::path checkpoint_in(const std::filesystem::path& folder) { return folder / "checkpoint.h5"; }
  static std::filesystem::path report_in(const std::filesystem::path& folder) { return folder / "report.html"; }
  static std::filesystem::path paraview_in(const std::filesystem::path& folder) { return folder / "open_in_paraview.py"; }

 private:
  std::filesystem::path folder_;
};

}  // namespace perimpact::output
