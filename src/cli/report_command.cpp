#include "cli/report_command.hpp"

#include <fmt/format.h>

#include "base/error.hpp"
#include "io/report/report.hpp"

namespace perimpact {

int report_command(const ReportArguments& arguments) {
  const report::Report report = report::write_report(arguments.folder, {.bytes = static_cast<std::size_t>(1e6 * arguments.megabytes)});
  fmt::print("{}: {:.1f} MB, {} of {} output frames, {} of {} particles\n", report.file.string(), 1e-6 * static_cast<double>(report.bytes), report.frames,
             report.frame_files_of_run, report.particles, report.particles_of_run);
  for (const std::string& note : report.notes) fmt::print("note: {}\n", note);
  return 0;
}

void try_report(const std::filesystem::path& folder, Messages& messages) {
  std::string fault;
  try {
    const report::Report report = report::write_report(folder);
    output::Json members = output::Json::object();
    members["file"] = report.file.string();
    messages.print("report", members,
                   fmt::format("  {}  report for the browser ({:.1f} MB)\n", report.file.string(), 1e-6 * static_cast<double>(report.bytes)));
    return;
  } catch (const fccda::InputError& error) {
    fault = error.what();
  } catch (const fccda::RunError& error) {
    fault = error.what();
  }
  messages.warn(fmt::format("the report of this run could not be written: {}", fault));
}

}  // namespace perimpact
