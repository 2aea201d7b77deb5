#include "io/results/results_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fstream>

#include "base/error.hpp"
#include "io/output/file.hpp"
#include "io/output/json.hpp"
#include "io/results/particle_frame.hpp"
#include "io/results/run_report.hpp"

namespace perimpact {

namespace {

std::vector<std::string> headings_of(std::span<const Column> columns) {
  std::vector<std::string> headings;
  for (const Column& column : columns) headings.push_back(column.heading());
  return headings;
}

/// Writes history.json, the description of the columns of history.csv for programs that read it.
void write_columns(const std::filesystem::path& path, std::span<const Column> columns) {
  output::Json json = output::Json::object();
  json["format"] = 1;
  for (const Column& column : columns) {
    output::Json one = output::Json::object();
    one["name"] = column.name;
    one["unit"] = column.unit;
    one["kind"] = word_for(column.kind);
    one["meaning"] = column.meaning;
    if (column.is_load) one["is_load"] = true;
    json["columns"].push_back(std::move(one));
  }
  output::write_whole_file(path, json.text());
}

double time_of(long step, const Clock& clock) { return static_cast<double>(step) * clock.dt; }

FrameFormat format_of(const Simulation& simulation) { return simulation.setup().output.frame_format.as<FrameFormat>(); }

/// Frames of a series that the run will have at its end: those written by the run that is resumed, if any, and those due after the current step.
std::size_t planned_frames(const Simulation& simulation, const Written* written) {
  const int frames = simulation.setup().output.frames;
  if (!written) return frames > 0 ? static_cast<std::size_t>(frames) + 1 : 0;
  std::size_t planned = 0;
  for (const std::vector<double>& times : written->frame_times) planned = std::max(planned, times.size());
  for (int frame = 0; frames > 0 && frame <= frames; ++frame)
    planned += step_of_frame(frame, frames, simulation.clock().steps) > simulation.clock().step ? 1 : 0;
  return planned;
}

/// All that the run may write. `written`: by the run that is resumed, if any.
output::FileList planned_files(const Simulation& simulation, std::span<const Line> lines, const Written* written = nullptr) {
  const OutputSetup& setup = simulation.setup().output;
  output::FileList list;
  for (const char* file : {"run.json", "report.html", "open_in_paraview.py", "history.csv", "history.json", "checkpoint.h5"}) list.add(file);
  for (int age = 1; age < setup.checkpoints_kept; ++age) list.add(output::ResultsFolder::checkpoint_in("", age).string());
  if (setup.checkpoints_kept > 1) list.add(output::ResultsFolder::next_checkpoint_in("").string());
  const auto add_series = [&](const std::string& name) {
    if (const std::size_t frames = planned_frames(simulation, written); frames > 0)
      frames::Series::list(list, name, format_of(simulation), frames);  // and one more, where it is interrupted
  };
  for (const Body& body : simulation.bodies()) {
    add_series(body.name);
    if (body.failure) list.add("fragments/" + body.name + ".csv"), list.add("fragments/" + body.name + "_end.csv");
  }
  for (const Impactor& impactor : simulation.impactors()) {
    add_series(impactor.name());
    list.add("pressure_area/" + impactor.name() + ".csv"), list.add("pressure_area/" + impactor.name() + "_at_peak.csv");
  }
  for (const Line& line : lines)
    for (const long step : line.steps) list.add(output::ResultsFolder::line_file(line.name, time_of(step, simulation.clock())));
  return list;
}

/// Of a run that is resumed at the current step: what it wrote at its end, or later than this step, and what other commands derived from it.
output::FileList later_files(const Simulation& simulation, const std::filesystem::path& folder, std::span<const Line> lines, const Written& written) {
  output::FileList later, earlier;
  for (const Line& line : lines)
    for (const long step : line.steps)
      if (step <= simulation.clock().step) earlier.add(output::ResultsFolder::line_file(line.name, time_of(step, simulation.clock())));
  const output::FileList all = output::FileList::of(folder);
  for (const std::string& file : all.files())
    if (file.starts_with("lines/") && !earlier.contains(file)) later.add(file);
  for (const char* file : {"run.json", "report.html", "open_in_paraview.py", "statistics.csv", "windows.csv", "spectrum.csv"}) later.add(file);
  for (const Body& body : simulation.bodies())
    for (const char* which : {"_end", "_channel_x", "_channel_y"}) later.add("fragments/" + body.name + which + ".csv");
  for (std::size_t i = 0; i < simulation.impactors().size(); ++i) {
    const std::string curve = "pressure_area/" + simulation.impactors()[i].name();
    later.add(curve + "_at_peak.csv");
    if (written.pressure_area[i] == 0) later.add(curve + ".csv");  // contact began after the checkpoint
  }
  return later;
}

/// Checks that the rows to be appended have the columns of the file, which another version of the program may have written.
void expect_columns(const std::filesystem::path& history, std::span<const Column> columns) {
  std::ifstream file(history);
  std::string header;
  std::getline(file, header);
  std::string expected = output::csv_header(headings_of(columns));
  expected.pop_back();  // the new line
  if (header == expected) return;
  const auto count = [](std::string_view line) { return std::count(line.begin(), line.end(), ',') + 1; };
  const auto same = std::mismatch(header.begin(), header.end(), expected.begin(), expected.end()).first - header.begin();
  throw fccda::InputError(
      fmt::format("{} is of another version of the program: it has {} columns and this one writes {}, different from column {} on; resume the "
                  "run with that version, or replace it by a new one.",
                  history.string(), count(header), count(expected), count(std::string_view(header).substr(0, static_cast<std::size_t>(same)))));
}

/// Checks that the files to be resumed contain all that had been written.
void expect_files(const Simulation& simulation, const std::filesystem::path& folder, std::span<const Line> lines, const Written& written) {
  const auto refuse = [](const std::filesystem::path& path, std::string_view fault) {
    throw fccda::InputError(fmt::format("{} {}, so the run cannot be resumed; restore it, or replace the run by a new one.", path.string(), fault));
  };
  const auto expect = [&](const std::filesystem::path& path, std::uint64_t size) {
    std::error_code missing;
    const std::uintmax_t there = std::filesystem::file_size(path, missing);
    if (missing) refuse(path, "is missing");
    if (there < size) refuse(path, "is shorter than when the checkpoint was written");
  };
  expect(output::ResultsFolder::history_in(folder), written.history);
  expect_columns(output::ResultsFolder::history_in(folder), simulation.monitors().columns());
  for (std::size_t i = 0; i < written.pressure_area.size(); ++i)
    if (written.pressure_area[i] > 0) expect(PressureArea::process_curve(folder, simulation.impactors()[i].name()), written.pressure_area[i]);
  for (std::size_t b = 0; b < written.fragments.size(); ++b)
    if (written.fragments[b] > 0) expect(FragmentTable::table(folder, simulation.bodies()[b].name), written.fragments[b]);

  auto times = written.frame_times.begin();
  const auto expect_frames = [&](const std::string& series) {
    frames::Series::expect(output::ResultsFolder::frames_in(folder), series, format_of(simulation), (times++)->size());
  };
  for (const Body& body : simulation.bodies()) expect_frames(body.name);
  for (const Impactor& impactor : simulation.impactors()) expect_frames(impactor.name());
  for (const Line& line : lines)
    for (const long step : line.steps)
      if (step <= simulation.clock().step) expect(folder / output::ResultsFolder::line_file(line.name, time_of(step, simulation.clock())), 1);
}

}  // namespace

ResultsWriter::Files::Files(const Simulation& simulation, const std::filesystem::path& path, std::span<const Line> lines)
    : folder(path, planned_files(simulation, lines)),
      history(folder.history(), headings_of(simulation.monitors().columns())),
      panel_frames(simulation.impactors().size()),
      pressure_area(simulation.impactors().size()),
      fragment_tables(simulation.bodies().size()) {
  for (const Body& body : simulation.bodies()) body_series.emplace_back(folder.frames(), body.name, format_of(simulation));
  for (const Impactor& impactor : simulation.impactors()) impactor_series.emplace_back(folder.frames(), impactor.name(), format_of(simulation));
  write_columns(folder.history_columns(), simulation.monitors().columns());
}

ResultsWriter::Files::Files(const Simulation& simulation, const std::filesystem::path& path, std::span<const Line> lines, Written& written)
    : folder((expect_files(simulation, path, lines, written), path), planned_files(simulation, lines, &written), later_files(simulation, path, lines, written)),
      history(folder.history(), simulation.monitors().columns().size(), written.history),
      panel_frames(std::move(written.panel_frames)) {
  auto times = written.frame_times.begin();
  for (const Body& body : simulation.bodies()) body_series.emplace_back(folder.frames(), body.name, format_of(simulation), std::move(*times++));
  for (const Impactor& impactor : simulation.impactors())
    impactor_series.emplace_back(folder.frames(), impactor.name(), format_of(simulation), std::move(*times++));
  for (std::size_t i = 0; i < simulation.impactors().size(); ++i)
    pressure_area.emplace_back(folder, simulation.impactors()[i].name(), written.pressure_area[i]);
  for (std::size_t b = 0; b < simulation.bodies().size(); ++b) fragment_tables.emplace_back(folder, simulation.bodies()[b].name, written.fragments[b]);
  write_columns(folder.history_columns(), simulation.monitors().columns());
}

ResultsWriter::ResultsWriter(const Simulation& simulation, const std::filesystem::path& folder)
    : lines_(lines_of(simulation)),  // first, so that an error leaves the results of an earlier run in the folder
      frame_particles_(frame_particles_of(simulation)),
      frames_wanted_(simulation.setup().output.frames) {
  if (simulation.ranks().is_root()) files_.emplace(simulation, folder, lines_);
  after_step(simulation);
}

ResultsWriter::ResultsWriter(const Simulation& simulation, const std::filesystem::path& folder, Written written)
    : lines_(lines_of(simulation)),
      frame_particles_(frame_particles_of(simulation)),
      frames_wanted_(simulation.setup().output.frames),
      last_frame_step_(written.last_frame_step),
      resumed_at_(written.resumed_at) {
  if (simulation.ranks().is_root()) files_.emplace(simulation, folder, lines_, written);
  skip_frames_until(simulation.clock().step, simulation.clock());  // frames are those of this deck from here on
  resumed_at_.push_back(simulation.clock().step);
}

Written ResultsWriter::written() {
  if (!files_) return Written(0, 0);
  Files& files = *files_;
  files.history.sync();
  for (PressureArea& curve : files.pressure_area) curve.sync();
  for (FragmentTable& table : files.fragment_tables) table.sync();
  for (const frames::Series& series : files.body_series) series.sync();
  for (const frames::Series& series : files.impactor_series) series.sync();
  const output::ResultsFolder& folder = files.folder;
  for (const std::filesystem::path& inner : {folder.frames(), folder.lines(), folder.pressure_area(), folder.fragments()}) output::sync_folder(inner);

  Written written(files.body_series.size(), files.impactor_series.size());
  written.history = files.history.size();
  for (std::size_t i = 0; i < files.pressure_area.size(); ++i) written.pressure_area[i] = files.pressure_area[i].size();
  for (std::size_t b = 0; b < files.fragment_tables.size(); ++b) written.fragments[b] = files.fragment_tables[b].size();
  written.panel_frames = files.panel_frames;
  auto times = written.frame_times.begin();
  for (const frames::Series& series : files.body_series) *times++ = series.times();
  for (const frames::Series& series : files.impactor_series) *times++ = series.times();
  written.last_frame_step = last_frame_step_;
  written.resumed_at = resumed_at_;
  return written;
}

long step_of_frame(int frame, int frames, long steps) { return std::lround(static_cast<double>(steps) * frame / frames); }

void ResultsWriter::skip_frames_until(long step, const Clock& clock) {
  // where more frames are requested than there are steps, one frame counts for several
  while (next_frame_ <= frames_wanted_ && frames_wanted_ > 0 && step_of_frame(next_frame_, frames_wanted_, clock.steps) <= step) ++next_frame_;
}

void ResultsWriter::after_step(const Simulation& simulation) {
  const Clock& clock = simulation.clock();
  if (files_ && simulation.monitors().is_due(clock)) {
    files_->history.append(simulation.monitors().row());
    for (std::size_t i = 0; i < files_->pressure_area.size(); ++i) files_->pressure_area[i].after_interval(files_->folder, simulation.impactors()[i]);
  }
  for (const Line& line : lines_)
    if (std::find(line.steps.begin(), line.steps.end(), clock.step) != line.steps.end()) write_line(simulation, line);
  if (frames_wanted_ > 0 && next_frame_ <= frames_wanted_ && clock.step == step_of_frame(next_frame_, frames_wanted_, clock.steps)) write_frame(simulation);
}

void ResultsWriter::write_frame(const Simulation& simulation) {
  const double time = simulation.clock().time();
  for (std::size_t b = 0; b < simulation.bodies().size(); ++b) {
    const Body& body = simulation.bodies()[b];
    std::optional<Fragments> fragments;
    if (body.failure) fragments.emplace(body.particles, body.family);
    const Fragments* const known = fragments ? &*fragments : nullptr;
    const ParticleFrame frame(body, known, simulation.setup().output.frame_fields, frame_particles_[b].now(body, known), frame_particles_[b].varies());
    if (!files_) {
      frame.write([](const output::PolyData&) {});
      continue;
    }
    files_->body_series[b].add(time, [&](const frames::Sink& sink) { frame.write(sink); });
    if (fragments) files_->fragment_tables[b].after_frame(files_->folder, body.name, time, *fragments);
  }
  for (std::size_t i = 0; files_ && i < simulation.impactors().size(); ++i)
    files_->impactor_series[i].add(time, [&](const frames::Sink& sink) { files_->panel_frames[i].write(sink, simulation.impactors()[i], time); });
  last_frame_step_ = simulation.clock().step;
  skip_frames_until(last_frame_step_, simulation.clock());
}

void ResultsWriter::write_line(const Simulation& simulation, const Line& line) const {
  const Body& body = simulation.bodies()[line.body];
  static const std::vector<std::string> columns{"position_x [m]",     "position_y [m]",     "position_z [m]",
                                                "displacement_x [m]", "displacement_y [m]", "displacement_z [m]"};
  std::vector<double> rows;
  for (const Sample& sample : line.samples) {
    const Vec3d u = sample.displacement(body);
    rows.insert(rows.end(), {sample.at.x, sample.at.y, sample.at.z, u.x, u.y, u.z});
  }
  if (files_) output::write_csv(files_->folder.line(line.name, simulation.clock().time()), columns, rows);
}

void ResultsWriter::finish(Simulation& simulation, Outcome outcome, const std::string& failure, double wall_seconds) {
  if (frames_wanted_ > 0 && last_frame_step_ != simulation.clock().step && outcome != Outcome::failed) write_frame(simulation);
  if (files_)
    for (std::size_t i = 0; i < files_->pressure_area.size(); ++i) files_->pressure_area[i].finish(files_->folder, simulation.impactors()[i]);
  for (const Body& body : simulation.bodies())
    if (body.failure) write_last_fragments(files_ ? &files_->folder : nullptr, body);
  const std::string report = run_report(simulation, outcome, failure, wall_seconds, resumed_at_).text();
  if (files_) output::write_whole_file(files_->folder.run(), report);  // last: a run is finished once this file says so
}

}  // namespace perimpact
