/// `perimpact report`: a run in one file for the browser.
#pragma once

#include <filesystem>

namespace perimpact {

struct ReportArguments {
  std::filesystem::path folder;
  double megabytes = 25;  ///< the most that the data may take [MB]
};

int report_command(const ReportArguments& arguments);

/// Writes report.html at the end of a run and prints its path; where that fails, a warning: the results are there all the same.
void try_report(const std::filesystem::path& folder);

}  // namespace perimpact
