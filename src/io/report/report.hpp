/// Report of a results folder as a self-contained HTML file: report.html, the page of report/ with embedded data. With frames also
/// open_in_paraview.py (paraview_script.hpp).
///
/// Larger runs are thinned to the file size limit: frames first, evenly and down to 40; then particles (kept_particles.hpp). The report states
/// what was omitted. docs/guide/report.md describes its contents and data layout.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace perimpact::report {

struct Limits {
  std::size_t bytes = 25'000'000;            ///< size of the data in the file
  std::size_t particle_frames = 20'000'000;  ///< particles times frames: a browser stores 11 bytes for each
  std::size_t min_frames = 40;               ///< number of frames below which particles are thinned instead
  std::size_t history_rows = 20'000;         ///< maximum rows of curves
};

struct Report {
  std::filesystem::path file;
  std::size_t bytes = 0;                           ///< file size
  std::size_t frames = 0, frame_files_of_run = 0;  ///< number of times with frames: shown, and available
  std::size_t particles = 0, particles_of_run = 0;
  std::vector<std::string> notes;  ///< messages about missing, damaged or thinned data
};

/// Writes DIR/report.html, replacing an earlier one. Folders of interrupted runs and with missing files are accepted. Throws InputError where the
/// folder contains no results, RunError where the file cannot be written.
Report write_report(const std::filesystem::path& folder, const Limits& limits = {});

}  // namespace perimpact::report
