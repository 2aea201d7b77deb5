#include "io/report/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <optional>

#include "base/error.hpp"
#include "io/deck/yaml_node.hpp"
#include "io/output/file.hpp"
#include "io/output/results_folder.hpp"
#include "io/report/curves.hpp"
#include "io/report/frames.hpp"
#include "io/report/kept_particles.hpp"
#include "io/report/page_template.hpp"
#include "io/report/paraview_script.hpp"
#include "mesh_io/file/contents.hpp"

namespace perimpact::report {

namespace {

namespace fs = std::filesystem;
using output::Json;

/// Contents of run.json, if it exists and is complete.
struct Run {
  std::string text;
  std::optional<deck::YamlNode> tree;

  /// Of a body; 0 where it is not known.
  double number_of(const std::string& body, std::string_view quantity) const {
    const deck::YamlNode* node = tree ? &*tree : nullptr;
    for (const std::string_view key : {std::string_view("bodies"), std::string_view(body), quantity}) {
      const deck::YamlNode::Entry* entry = node ? node->find(key) : nullptr;
      node = entry ? &entry->value : nullptr;
    }
    return node ? std::strtod(node->text.c_str(), nullptr) : 0;
  }
};

Run read_run(const fs::path& folder, std::vector<std::string>& notes) {
  const fs::path file = output::ResultsFolder::run_in(folder);
  Run run;
  if (!fs::exists(file)) {
    notes.push_back(
        fmt::format("{} does not exist: the run is in progress or was killed. Deck, checks and timers are missing from this report.", file.string()));
    return run;
  }
  try {
    run.text = fccda::contents_of(file);
    run.tree = deck::parse_document(run.text, file.string());
  } catch (const fccda::InputError& error) {
    notes.push_back(fmt::format("{} Deck, checks and timers are missing from this report.", error.what()));
    run.text.clear();
  }
  return run;
}

/// The history with its column descriptions, or the table alone without history.json.
Table history_of(const fs::path& folder, std::vector<std::string>& notes) {
  if (!fs::exists(output::ResultsFolder::history_in(folder))) return read_table(output::ResultsFolder::history_in(folder));
  try {
    return read_history(folder);
  } catch (const fccda::InputError& error) {
    notes.push_back(fmt::format("{} Where rows are merged in this report, the last value is shown.", error.what()));
    return read_table(output::ResultsFolder::history_in(folder));
  }
}

std::optional<Table> rows_of_history(const fs::path& folder, std::size_t most_rows, std::vector<std::string>& notes) {
  try {
    const Table table = history_of(folder, notes);
    if (table.names.front() != "time [s]" || table.rows() == 0) {
      notes.push_back(fmt::format("{} has no column time [s] or no rows, so there are no curves.", table.file.string()));
      return {};
    }
    if (table.rows() > most_rows)
      notes.push_back(fmt::format(
          "history.csv has {} rows; the curves in this report have at most {}: forces, moments and other means over an interval are means over several rows, "
          "so their peaks are lower.",
          table.rows(), most_rows));
    return joined(table, most_rows);
  } catch (const fccda::InputError& error) {
    notes.emplace_back(error.what());
    return {};
  }
}

/// Selects `count` times evenly, including the first and the last.
std::vector<double> evenly(const std::vector<double>& times, std::size_t count) {
  if (count >= times.size()) return times;
  if (count < 2) return {times.back()};
  std::vector<double> out;
  for (std::size_t k = 0; k < count; ++k)
    out.push_back(times[static_cast<std::size_t>(std::llround(static_cast<double>(k * (times.size() - 1)) / static_cast<double>(count - 1)))]);
  return out;
}

/// Notes that the frames have a part of the particles (of `all`, 0: not known) or of the fields.
void note_selection(const BodyFrames& body, double all, std::vector<std::string>& notes) {
  if (body.is_thinned())
    notes.push_back(fmt::format("The frames of {} are thinned by output.frame_particles: {}{} of its{} particles were written{}.", body.name,
                                body.varies ? "up to " : "", body.undeformed.size(), all > 0 ? fmt::format(" {:.0f}", all) : "",
                                body.varies ? ", each in the frames in which it meets the selection" : ""));
  if (!body.has("displacement"))
    notes.push_back(fmt::format(
        "The frames of {} have no field displacement (output.frame_fields), so its displacements are from the first frame of each particle on.", body.name));
  for (const auto& [field, what] : {std::pair("velocity", "speed"), std::pair("damage", "damage")})
    if (!body.has(field))
      notes.push_back(fmt::format("The frames of {} have no field {} (output.frame_fields), so its {} is not shown.", body.name, field, what));
}

/// Thins frames first, then particles, until the number of particles times frames is at most `most`.
Choice choose(const Frames& frames, double most, std::size_t min_frames) {
  const std::vector<double> times = frames.times();
  std::size_t particles = 0;
  for (const BodyFrames& body : frames.bodies) particles += body.undeformed.size();
  const double fitting = particles == 0 ? static_cast<double>(times.size()) : most / static_cast<double>(particles);
  const auto least = static_cast<double>(std::min(min_frames, times.size()));
  const double shown = std::floor(std::clamp(fitting, least, static_cast<double>(times.size())));

  Choice choice{.times = evenly(times, static_cast<std::size_t>(shown)), .particles = {}};
  const double share = std::min(1.0, fitting / std::max(1.0, static_cast<double>(choice.times.size())));
  for (const BodyFrames& body : frames.bodies) {
    if (share < 1) {
      choice.particles.push_back(kept_particles(body.undeformed, body.spacing, body.is_damaged, share));
    } else {
      choice.particles.emplace_back(body.undeformed.size());
      std::iota(choice.particles.back().begin(), choice.particles.back().end(), 0U);
    }
  }
  return choice;
}

std::size_t particles_in(const Choice& choice) {
  std::size_t sum = 0;
  for (const std::vector<std::uint32_t>& particles : choice.particles) sum += particles.size();
  return sum;
}

/// A script element with JSON. A `<` that could begin a tag is escaped; in JSON it occurs in strings only.
std::string as_script(std::string_view id, std::string_view json) {
  std::string text = fmt::format("<script type=\"application/json\" id=\"{}\">", id);
  for (const char c : json) text += c == '<' ? std::string("\\u003c") : std::string(1, c);
  return text + "</script>\n";
}

void write_blob(output::WholeFile& file, std::string_view id, std::string_view base64) {
  file.write(fmt::format("<script type=\"text/plain\" id=\"{}\">", id));
  file.write(base64);
  file.write("</script>\n");
}

/// The notes with paths relative to the results folder: the report may be read elsewhere.
Json relative(const std::vector<std::string>& notes, const fs::path& folder) {
  const std::string prefix = (folder / "").string();
  Json out = Json::array();
  for (std::string note : notes) {
    for (std::size_t at = 0; !prefix.empty() && (at = note.find(prefix, at)) != std::string::npos;) note.erase(at, prefix.size());
    out.push_back(std::move(note));
  }
  return out;
}

std::string name_of(const fs::path& folder) {
  const fs::path whole = fs::absolute(folder).lexically_normal();
  return (whole.has_filename() ? whole.filename() : whole.parent_path().filename()).string();
}

}  // namespace

Report write_report(const fs::path& folder, const Limits& limits) {
  const bool has_any = fs::exists(output::ResultsFolder::history_in(folder)) || fs::exists(output::ResultsFolder::run_in(folder)) ||
                       fs::exists(output::ResultsFolder::frames_in(folder));
  if (!has_any)
    throw fccda::InputError(fmt::format(
        "{} contains no results of a run (no history.csv, run.json or frames); give a results folder written by `perimpact run`.", folder.string()));
  Report report{.file = output::ResultsFolder::report_in(folder)};
  const Run run = read_run(folder, report.notes);
  const std::optional<Table> history = rows_of_history(folder, limits.history_rows, report.notes);
  Frames frames = scan_frames(folder, report.notes);
  for (BodyFrames& body : frames.bodies) {
    if (const double spacing = run.number_of(body.name, "spacing [m]"); spacing > 0) body.spacing = spacing;
    note_selection(body, run.number_of(body.name, "particles"), report.notes);
    report.particles_of_run += body.undeformed.size();
  }
  report.frame_files_of_run = frames.times().size();

  // the compression ratio is not known in advance: reduce the selection by the excess until the size fits
  double most = static_cast<double>(limits.particle_frames);
  Choice choice;
  PackedFrames packed;
  for (int attempt = 0; attempt < 6; ++attempt) {
    choice = choose(frames, most, limits.min_frames);
    packed = pack_frames(frames, choice);
    if (packed.bytes <= limits.bytes || frames.bodies.empty()) break;
    const auto bytes = [](std::size_t count) { return static_cast<double>(count); };
    const double now = std::min(most, static_cast<double>(particles_in(choice) * choice.times.size()));
    const double room = std::max(bytes(limits.bytes) - bytes(packed.bytes - packed.bytes_of_bodies), 0.01 * bytes(limits.bytes));
    most = 0.95 * now * std::min(room / bytes(packed.bytes_of_bodies), 1.0);
  }
  report.frames = choice.times.size();
  report.particles = particles_in(choice);
  if (report.frames < report.frame_files_of_run)
    report.notes.push_back(fmt::format("{} of {} frames are shown, evenly spaced, to keep the report below {:.3g} MB; all of them are in frames/.",
                                       report.frames, report.frame_files_of_run, 1e-6 * static_cast<double>(limits.bytes)));
  if (report.particles < report.particles_of_run)
    report.notes.push_back(
        fmt::format("{} of {} particles are shown: those on the surface and those that are damaged at the end first, the others evenly thinned.",
                    report.particles, report.particles_of_run));

  Json description = Json::object();
  description["format"] = 1;
  description["folder"] = name_of(folder);
  description["notes"] = relative(report.notes, folder);
  description["times [s]"] = choice.times.empty() ? Json::array() : Json(choice.times);
  description["bodies"] = std::move(packed.bodies);
  description["impactors"] = std::move(packed.impactors);
  Curves curves;
  if (history) curves = curves_of(*history), description["history"] = std::move(curves.description);

  // first: once the report exists, nothing is missing
  if (!choice.times.empty()) output::write_whole_file(output::ResultsFolder::paraview_in(folder), paraview_script(frames));
  const std::string_view page = page_template();
  const std::size_t mark = page.find(data_mark);
  output::WholeFile file(report.file);
  file.write(page.substr(0, mark));
  file.write(as_script("description", description.text()));
  if (!run.text.empty()) file.write(as_script("run", run.text));
  if (history) write_blob(file, "history", base64(gzip(curves.bytes)));
  for (const Blob& blob : packed.blobs) write_blob(file, blob.id, blob.text);
  file.write(page.substr(mark + data_mark.size()));
  file.finish();
  report.bytes = fs::file_size(report.file);
  return report;
}

}  // namespace perimpact::report
