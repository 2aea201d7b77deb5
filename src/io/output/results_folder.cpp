#include "io/output/results_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "base/error.hpp"
#include "io/output/file.hpp"

namespace perimpact::output {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view advice = "move it, or choose another folder with --out or output.folder";

/// The rank in the order of removal: a checkpoint must not remain without the results that it resumes.
int rank(const std::string& file) {
  if (file.starts_with("checkpoint")) return 0;
  return file.find('/') == std::string::npos ? 1 : file.ends_with(".pvd") ? 2 : 3;
}

void remove(const fs::path& folder, std::vector<std::string> files) {
  std::ranges::stable_sort(files, {}, rank);
  for (const std::string& file : files) {
    std::error_code error;
    if (!fs::remove(folder / file, error) && error) {
      throw fccda::InputError(fmt::format("{} is of an earlier run and cannot be removed: {}. Remove it, or choose another folder with --out or output.folder.",
                                          (folder / file).string(), error.message()));
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

ResultsFolder::ResultsFolder(fs::path folder, const FileList& planned) : folder_(std::move(folder)) {
  for (const fs::path& each : {folder_, frames(), lines(), pressure_area(), fragments()}) prepare_folder(each);
  const FileList earlier = FileList::of(folder_);
  earlier.expect_no_others(planned, folder_, advice);
  remove(folder_, earlier.present_in(folder_));
  planned.write_to(folder_);
}

ResultsFolder::ResultsFolder(fs::path folder, const FileList& planned, const FileList& discarded) : folder_(std::move(folder)) {
  for (const fs::path& each : {folder_, frames(), lines(), pressure_area(), fragments()}) prepare_folder(each);
  FileList all = FileList::of(folder_);
  all.expect_no_others(planned, folder_, advice);
  std::vector<std::string> unwanted = all.present_in(folder_);
  std::erase_if(unwanted, [&](const std::string& file) { return !file.ends_with(".part") && !discarded.contains(file); });
  remove(folder_, unwanted);
  all.add(planned);
  all.write_to(folder_);
}

fs::path ResultsFolder::checkpoint_in(const fs::path& folder, int age) {
  return folder / (age == 0 ? std::string("checkpoint.h5") : fmt::format("checkpoint_{}.h5", age));
}

/// Ten digits: fewer would be the same for successive steps of a long run, more would show the rounding of step times dt.
std::string ResultsFolder::line_file(std::string_view name, double time) { return fmt::format("lines/{}_t{:.10g}.csv", name, time); }

}  // namespace perimpact::output
