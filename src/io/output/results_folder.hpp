/// Results folder of a run; the only file that defines its file names:
///
///   run.json   history.csv   history.json   lines/<line>_t<seconds>.csv   frames/<body>_00000.vtp, …   frames/<body>.pvd
///   pressure_area/<impactor>.csv, <impactor>_at_peak.csv   fragments/<body>.csv, <body>_end.csv   report.html   open_in_paraview.py
///   checkpoint.h5, older ones checkpoint_1.h5, …   files.txt (file_list.hpp)   run.lock (run/folder_lock.hpp)
///
/// `perimpact statistics` adds statistics.csv, windows.csv, spectrum.csv and fragments/<body>_channel_x.csv to the list of files. `check` writes
/// to check/, which runs leave unchanged.
#pragma once

#include <filesystem>
#include <string_view>

#include "io/output/file_list.hpp"

namespace perimpact::output {

/// Creates the folder with its parents and writes a trial file. Throws InputError where that fails, before the computation begins.
void prepare_folder(const std::filesystem::path& folder);

/// A prepared results folder. Files that no run has written are never removed or replaced.
class ResultsFolder {
 public:
  /// For a new run that writes the files `planned`; those of an earlier run are removed. Throws InputError, with every file unchanged, where a
  /// file of that name exists that no run has written.
  ResultsFolder(std::filesystem::path folder, const FileList& planned);

  /// For a restart: removes only partial files and those in `discarded`, which a run up to the checkpoint does not have.
  ResultsFolder(std::filesystem::path folder, const FileList& planned, const FileList& discarded);

  const std::filesystem::path& path() const { return folder_; }
  std::filesystem::path run() const { return run_in(folder_); }
  std::filesystem::path history() const { return history_in(folder_); }
  std::filesystem::path history_columns() const { return history_columns_in(folder_); }
  std::filesystem::path frames() const { return frames_in(folder_); }
  std::filesystem::path lines() const { return folder_ / "lines"; }
  std::filesystem::path pressure_area() const { return pressure_area_in(folder_); }
  std::filesystem::path fragments() const { return fragments_in(folder_); }
  std::filesystem::path line(std::string_view name, double time) const { return folder_ / line_file(name, time); }  ///< time in [s]

  static std::string line_file(std::string_view name, double time);  ///< path from the results folder

  // for a folder that need not be prepared
  static std::filesystem::path history_in(const std::filesystem::path& folder) { return folder / "history.csv"; }
  static std::filesystem::path history_columns_in(const std::filesystem::path& folder) { return folder / "history.json"; }
  static std::filesystem::path pressure_area_in(const std::filesystem::path& folder) { return folder / "pressure_area"; }
  static std::filesystem::path frames_in(const std::filesystem::path& folder) { return folder / "frames"; }
  static std::filesystem::path run_in(const std::filesystem::path& folder) { return folder / "run.json"; }
  static std::filesystem::path fragments_in(const std::filesystem::path& folder) { return folder / "fragments"; }
  /// The latest checkpoint, and the one that is `age` older.
  static std::filesystem::path checkpoint_in(const std::filesystem::path& folder, int age = 0);
  static std::filesystem::path next_checkpoint_in(const std::filesystem::path& folder) { return folder / "checkpoint_new.h5"; }
  static std::filesystem::path list_in(const std::filesystem::path& folder) { return folder / "files.txt"; }
  static std::filesystem::path report_in(const std::filesystem::path& folder) { return folder / "report.html"; }
  static std::filesystem::path paraview_in(const std::filesystem::path& folder) { return folder / "open_in_paraview.py"; }

 private:
  std::filesystem::path folder_;
};

}  // namespace perimpact::output
