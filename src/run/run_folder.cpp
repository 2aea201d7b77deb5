#include "run/run_folder.hpp"

#include <fmt/format.h>

#include <fstream>
#include <system_error>

#include "base/error.hpp"
#include "io/checkpoint/checkpoints.hpp"
#include "io/deck/expanded_path.hpp"
#include "io/output/results_folder.hpp"
#include "perimpact/ranks/on_root.hpp"

namespace perimpact {

namespace fs = std::filesystem;
using output::ResultsFolder;

namespace {

/// "finished", "interrupted", "failed" in run.json; empty if there is no such file.
std::string outcome_in(const fs::path& folder) {
  constexpr std::string_view key = "\"outcome\": \"";
  std::ifstream file(ResultsFolder::run_in(folder));
  for (std::string line; std::getline(file, line);)
    if (const std::size_t at = line.find(key); at != std::string::npos) {
      const std::size_t begin = at + key.size();
      return line.substr(begin, line.find('"', begin) - begin);
    }
  return "";
}

/// The folder, created where it is missing; not for a run that cannot be resumed.
const fs::path& prepared(const fs::path& folder, EarlierRun earlier) {
  if (earlier == EarlierRun::resume && !has_checkpoint(folder)) newest_checkpoint(folder);  // throws, with the reason
  output::prepare_folder(folder);
  return folder;
}

}  // namespace

fs::path results_path(const std::string& folder, const std::string& place) {
  const fs::path path = deck::expanded_path(folder, place);
  if (path.empty()) throw fccda::InputError(fmt::format("{}: the results folder has no name; give one, such as results.", place));
  if (fs::absolute(path).lexically_normal() == "/")
    throw fccda::InputError(fmt::format("{}: the results folder is /, the root of the file system; give a folder below it.", place));
  return path;
}

RunFolder::RunFolder(fs::path folder, EarlierRun earlier, Requests requests, const Setup& setup, Ranks& ranks)
    : folder_(std::move(folder)), earlier_(earlier), requests_(std::move(requests)) {
  on_root(ranks, [&] { claim(setup); });
  is_finished_ = ranks.any(is_finished_);
  if (earlier_ != EarlierRun::resume || ranks.size() == 1) return;
  loads_.resize(setup.bodies.size());
  for (MeasuredLoad& load : loads_) load = ranks.join_all(std::span<const MeasuredPart>(load));  // the root alone has any
}

void RunFolder::claim(const Setup& setup) {
  lock_.emplace(prepared(folder_, earlier_));
  if (!lock_->note().empty()) notes_.push_back(lock_->note());
  if (earlier_ == EarlierRun::keep) expect_no_run();
  if (earlier_ == EarlierRun::resume) find_checkpoint(setup);
}

void RunFolder::expect_no_run() const {
  const bool has_any = fs::exists(ResultsFolder::run_in(folder_)) || fs::exists(ResultsFolder::history_in(folder_)) || has_checkpoint(folder_);
  if (!has_any) return;
  const auto refuse = [&](const std::string& what) {
    throw fccda::InputError(fmt::format("the folder {} contains {}; replace it with {}, or {}.", folder_.string(), what, requests_.replace, requests_.folder));
  };
  if (outcome_in(folder_) == "finished") refuse("a finished run");
  if (!has_checkpoint(folder_)) refuse("an unfinished run without a checkpoint, which cannot be resumed");
  std::string state = "an unfinished run";
  try {
    const Reached reached = newest_checkpoint(folder_);
    state = fmt::format("an unfinished run (step {} of {})", reached.step, reached.steps);
  } catch (const fccda::InputError& error) {
    refuse(fmt::format("an unfinished run whose checkpoint cannot be read ({})", error.what()));
  }
  throw fccda::InputError(fmt::format("the folder {} contains {}; resume it with {} or replace it with {}, or {}.", folder_.string(), state, requests_.resume,
                                      requests_.replace, requests_.folder));
}

void RunFolder::find_checkpoint(const Setup& setup) {
  const Reached reached = newest_checkpoint(folder_, setup);
  steps_ = reached.steps;
  loads_ = reached.loads;
  is_finished_ = outcome_in(folder_) == "finished" && setup.time.end == reached.end;
}

}  // namespace perimpact
