/// `perimpact report`: writes a run as one file for the browser.
#pragma once

#include <filesystem>

#include "cli/messages.hpp"

namespace perimpact {

struct ReportArguments {
  std::filesystem::path folder;
  double megabytes = 25;  ///< maximum size of the data [MB]
};

int report_command(const ReportArguments& arguments);

/// Writes report.html at the end of a run and prints its path, or a warning on failure, since the results are complete.
void try_report(const std::filesystem::path& folder, Messages& messages);

}  // namespace perimpact
