/// The results folder of one run: claimed by a lock, and never taken from an earlier run unless that is asked for.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "perimpact/deck_model/setup.hpp"
#include "perimpact/particles/measured_load.hpp"
#include "perimpact/ranks/ranks.hpp"
#include "run/folder_lock.hpp"

namespace perimpact {

enum class EarlierRun { keep, replace, resume };

/// How a user asks for it, in the words of the front end: command line or Python.
struct Requests {
  std::string resume;   ///< "perimpact run deck.yaml --resume"
  std::string replace;  ///< "--force"
  std::string folder;   ///< "choose another folder with --out"
};

/// The path of a results folder as given. Throws InputError at `place` where it is empty or the root of the file system.
std::filesystem::path results_path(const std::string& folder, const std::string& place);

class RunFolder {
 public:
  /// Creates and locks the folder. Throws InputError where that fails, where another run is writing there, where it contains a run and
  /// `earlier` is `keep`, and where that run cannot be resumed; SetupError where its deck differs. An earlier run remains unchanged. Of several ranks the
  /// root does this, and its error is thrown on all.
  RunFolder(std::filesystem::path folder, EarlierRun earlier, Requests requests, const Setup& setup, Ranks& ranks = alone());

  const std::filesystem::path& path() const { return folder_; }
  bool is_resumed() const { return earlier_ == EarlierRun::resume; }
  /// Of a run to be resumed: it has ended at the time.end of this deck.
  bool is_finished() const { return is_finished_; }
  long steps() const { return steps_; }  ///< of the run to be resumed, on the root
  /// Of each body of the run to be resumed, by which ranks divide it.
  std::span<const MeasuredLoad> loads() const { return loads_; }
  const Requests& requests() const { return requests_; }
  const std::vector<std::string>& notes() const { return notes_; }  ///< sentences for the user, on the root

 private:
  void claim(const Setup& setup);
  void expect_no_run() const;
  void find_checkpoint(const Setup& setup);

  std::filesystem::path folder_;
  EarlierRun earlier_;
  Requests requests_;
  std::optional<FolderLock> lock_;  // of the root
  bool is_finished_ = false;
  long steps_ = 0;
  std::vector<MeasuredLoad> loads_;
  std::vector<std::string> notes_;
};

}  // namespace perimpact
