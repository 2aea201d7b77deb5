#include "io/output/file_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <fstream>

#include "base/error.hpp"
#include "io/output/file.hpp"
#include "io/output/results_folder.hpp"

namespace perimpact::output {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view extension = ".vtp", part = ".part", first_line = "# Files of the run in this folder. They are removed when the run is replaced.\n";

/// True for a path that stays below the results folder.
bool is_below(const fs::path& file) {
  return !file.empty() && file.is_relative() && std::ranges::none_of(file, [](const fs::path& component) { return component == ".." || component == "."; });
}

/// The number in "00007"; -1 for other texts.
long number_in(std::string_view digits) {
  long number = -1;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  return error == std::errc() && end == digits.data() + digits.size() ? number : -1;
}

/// Reads "frames/plate_[00000-00041].vtp"; false for the name of a single file.
bool read_frames(std::string_view line, std::string& series, long& last) {
  const std::size_t bracket = line.find("_["), dash = line.find('-', bracket);
  if (bracket == std::string_view::npos || dash == std::string_view::npos || !line.ends_with("].vtp")) return false;
  series = line.substr(0, bracket);
  last = number_in(line.substr(dash + 1, line.size() - dash - 6));
  return last >= 0;
}

}  // namespace

std::string frame_file(std::string_view series, std::size_t number) { return fmt::format("{}_{:05}{}", series, number, extension); }

FileList FileList::of(const fs::path& folder) {
  FileList list;
  std::ifstream file(ResultsFolder::list_in(folder));
  for (std::string line, series; std::getline(file, line);) {
    long last = 0;
    if (line.starts_with('#') || !is_below(line)) continue;
    if (read_frames(line, series, last))
      list.add_frames(series, static_cast<std::size_t>(last));
    else
      list.add(line);
  }
  return list;
}

void FileList::add_frames(const std::string& series, std::size_t last) {
  std::size_t& before = last_frames_[series];
  before = std::max(before, last);
}

void FileList::add(const FileList& other) {
  files_.insert(other.files_.begin(), other.files_.end());
  for (const auto& [series, last] : other.last_frames_) add_frames(series, last);
}

bool FileList::contains(std::string_view file) const {
  if (file.ends_with(part)) file.remove_suffix(part.size());
  if (files_.contains(std::string(file))) return true;
  const std::size_t mark = file.rfind('_');
  if (mark == std::string_view::npos || !file.ends_with(extension)) return false;
  const auto series = last_frames_.find(file.substr(0, mark));
  const long number = number_in(file.substr(mark + 1, file.size() - mark - 1 - extension.size()));
  return series != last_frames_.end() && number >= 0 && static_cast<std::size_t>(number) <= series->second &&
         file == frame_file(series->first, static_cast<std::size_t>(number));
}

std::vector<std::string> FileList::present_in(const fs::path& folder) const {
  std::set<fs::path> folders;
  for (const std::string& file : files_) folders.insert(fs::path(file).parent_path());
  for (const auto& [series, last] : last_frames_) folders.insert(fs::path(series).parent_path());
  std::vector<std::string> present;
  for (const fs::path& each : folders) {
    std::error_code missing;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder / each, missing))
      if (std::string name = (each / entry.path().filename()).string(); contains(name) && !entry.is_directory()) present.push_back(std::move(name));
  }
  return present;
}

void FileList::expect_no_others(const FileList& planned, const fs::path& folder, std::string_view advice) const {
  for (const std::string& file : planned.present_in(folder))
    if (!contains(file))
      throw fccda::InputError(fmt::format("{} would be replaced, but {} does not list it as a file of a run; {}.", (folder / file).string(),
                                          ResultsFolder::list_in(folder).string(), advice));
}

void FileList::write_to(const fs::path& folder) const {
  std::string text(first_line);
  for (const std::string& file : files_) text += file + "\n";
  for (const auto& [series, last] : last_frames_) text += fmt::format("{}_[{:05}-{:05}]{}\n", series, 0, last, extension);
  write_whole_file(ResultsFolder::list_in(folder), text);
}

void list_files(const fs::path& folder, std::span<const std::string> files) {
  FileList list = FileList::of(folder);
  if (std::ranges::all_of(files, [&](const std::string& file) { return list.contains(file); })) return;
  for (const std::string& file : files) list.add(file);
  list.write_to(folder);
}

void claim_files(const fs::path& folder, std::span<const std::string> files) {
  FileList planned;
  for (const std::string& file : files) planned.add(file);
  FileList::of(folder).expect_no_others(planned, folder, "move or rename it");
  list_files(folder, files);
}

}  // namespace perimpact::output
