#include "io/output/results_folder.hpp"

#include <fmt/format.h>

#include <cctype>
#include <string>
#include <system_error>
#include <vector>

#include "base/error.hpp"
#include "io/output/file.hpp"

namespace perimpact::output {

namespace fs = std::filesystem;

namespace {

bool is_frame(std::string_view name) {  // <body>_00000.vtp
  if (!name.ends_with(".vtp")) return false;
  name.remove_suffix(4);
  std::size_t digits = 0;
  for (; !name.empty() && std::isdigit(static_cast<unsigned char>(name.back())); ++digits) name.remove_suffix(1);
  return digits >= 5 && name.size() > 1 && name.ends_with('_');
}

bool is_series(const fs::path& folder, std::string_view name) {  // <body>.pvd next to the frames that it lists
  return name.ends_with(".pvd") && fs::exists(folder / (std::string(name.substr(0, name.size() - 4)) + "_00000.vtp"));
}

bool is_of_report(std::string_view name) { return name == "report.html" || name == "open_in_paraview.py"; }

bool is_line(std::string_view name) {  // <line>_t<seconds>.csv
  if (!name.ends_with(".csv")) return false;
  name.remove_suffix(4);
  const std::size_t time = name.rfind("_t");
  return time != std::string_view::npos && time > 0 && time + 2 < name.size() && name.find_first_not_of("0123456789.e-+", time + 2) == std::string_view::npos;
}

/// Files of `folder` that a run writes, complete or partial from a killed run.
template <class IsOurs>
std::vector<fs::path> our_files(const fs::path& folder, const IsOurs& is_ours) {
  std::vector<fs::path> found;
  std::error_code missing;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, missing)) {
    std::string name = entry.path().filename().string();
    if (name.ends_with(".part")) name.resize(name.size() - 5);
    if (!entry.is_directory() && is_ours(name)) found.push_back(entry.path());
  }
  return found;
}

void remove(const std::vector<fs::path>& files) {
  for (const fs::path& file : files) {
    std::error_code error;
    if (!fs::remove(file, error) && error) {
      throw fccda::InputError(fmt::format("{} is of an earlier run and cannot be removed: {}. Remove it, or choose another folder with --out or output.folder.",
                                          file.string(), error.message()));
    }
  }
}

}  // namespace

void prepare_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (!error) error = try_writing(folder / ".perimpact-trial");
  if (error) {
    throw fccda::InputError(fmt::format("results cannot be written to the folder {}: {}. Choose another one with --out, or with output.folder in the deck.",
                                        folder.string(), error.message()));
  }
}

ResultsFolder::ResultsFolder(fs::path folder, EarlierRun earlier) : folder_(std::move(folder)) {
  for (const fs::path& each : {folder_, frames(), lines(), pressure_area(), fragments()}) prepare_folder(each);
  const auto remove_from = [earlier](const fs::path& from, const auto& is_ours) {
    std::vector<fs::path> files = our_files(from, is_ours);
    if (earlier == EarlierRun::continued)
      std::erase_if(
          files, [](const fs::path& file) { return file.extension() != ".part" && file.filename() != "run.json" && !is_of_report(file.filename().string()); });
    remove(files);
  };
  // the checkpoint first: it must not remain without the results that it resumes
  remove_from(folder_, [](std::string_view name) { return name == "checkpoint.h5"; });
  remove_from(folder_, [](std::string_view name) { return name == "run.json" || is_of_report(name) || name == "history.csv" || name == "history.json"; });
  remove_from(folder_, [](std::string_view name) { return name == "statistics.csv" || name == "windows.csv" || name == "spectrum.csv"; });
  remove_from(frames(), [&](std::string_view name) { return is_series(frames(), name); });
  remove_from(frames(), is_frame);
  remove_from(lines(), is_line);
  for (const fs::path& tables : {pressure_area(), fragments()}) remove_from(tables, [](std::string_view name) { return name.ends_with(".csv"); });
}

fs::path ResultsFolder::line(std::string_view name, double time) const { return lines() / fmt::format("{}_t{}.csv", name, time); }

}  // namespace perimpact::output
