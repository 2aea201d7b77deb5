/// A results folder as one file that a browser shows by itself: report.html, the page of report/ with the data in it.
///
/// Larger runs are thinned until the file fits: pictures first, evenly and down to 40 of them; then particles (kept_particles.hpp). What was left out
/// stands in the report. docs/guide/report.md tells how it looks and how its data are laid out.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace perimpact::report {

struct Limits {
  std::size_t bytes = 25'000'000;            ///< of the data in the file
  std::size_t particle_frames = 20'000'000;  ///< particles times pictures: a browser keeps 11 bytes for each
  std::size_t min_frames = 40;               ///< before particles are thinned
  std::size_t history_rows = 20'000;         ///< of curves
};

struct Report {
  std::filesystem::path file;
  std::size_t bytes = 0;                           ///< of the file
  std::size_t frames = 0, frame_files_of_run = 0;  ///< shown and there: times at which there are some
  std::size_t particles = 0, particles_of_run = 0;
  std::vector<std::string> notes;  ///< sentences: what is missing, damaged or thinned
};

/// Writes DIR/report.html, and replaces an earlier one. A folder of a run that was interrupted will do, and one with files missing. Throws InputError
/// where the folder holds nothing that a run leaves behind, RunError where the file cannot be written.
Report write_report(const std::filesystem::path& folder, const Limits& limits = {});

}  // namespace perimpact::report
