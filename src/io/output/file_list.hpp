/// The files that a run writes: `files.txt` in its results folder.
///
/// The names follow from the deck, so the list is complete before the first of the files exists: a run that is killed at any moment leaves a
/// list of everything it can have written. Only files of the list are removed when a run is replaced.
///
///   history.csv
///   frames/plate.pvd
///   frames/plate_[00000-00041].vtp
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace perimpact::output {

/// "plate_00007.vtp": a frame of a series.
std::string frame_file(std::string_view series, std::size_t number);

class FileList {
 public:
  /// The list in a folder; empty where there is none. Lines that do not name a file below the folder are ignored.
  static FileList of(const std::filesystem::path& folder);

  void add(std::string file) { files_.insert(std::move(file)); }  ///< path from the results folder
  void add_frames(const std::string& series, std::size_t last);   ///< "frames/plate": its files 0 … last
  void add(const FileList& other);

  bool contains(std::string_view file) const;                    ///< also `<file>.part` of a run that was killed
  const std::set<std::string>& files() const { return files_; }  ///< without frames
  /// The files of the list that exist in the folder, as paths from it.
  std::vector<std::string> present_in(const std::filesystem::path& folder) const;
  /// Throws InputError where a file of `planned` exists in the folder, whole or as `<file>.part`, without being in this list: it is not of this program and
  /// would be replaced. `advice`: what to do besides moving it, as a clause.
  void expect_no_others(const FileList& planned, const std::filesystem::path& folder, std::string_view advice) const;

  /// Replaces the list of the folder. Throws RunError where it cannot be written.
  void write_to(const std::filesystem::path& folder) const;

 private:
  std::set<std::string> files_;
  std::map<std::string, std::size_t, std::less<>> last_frames_;  // of each series
};

/// Adds files that another command writes into a results folder to the list of the folder.
void list_files(const std::filesystem::path& folder, std::span<const std::string> files);

/// The same, to be called before they are written. Throws InputError where one of them exists without being in the list.
void claim_files(const std::filesystem::path& folder, std::span<const std::string> files);

}  // namespace perimpact::output
