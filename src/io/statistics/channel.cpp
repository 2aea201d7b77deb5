#include "io/statistics/channel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <system_error>

#include "base/contract.hpp"
#include "base/error.hpp"
#include "io/deck/yaml_node.hpp"
#include "io/frames/frame.hpp"
#include "io/output/results_folder.hpp"
#include "mesh_io/file/contents.hpp"

namespace perimpact {

namespace {

enum class Cell : std::uint8_t { empty, remains, broken };

/// The widest run of broken cells; empty cells neither begin nor end it.
struct BrokenRow {
  std::size_t first = 0, behind = 0;

  std::size_t cells() const { return behind - first; }
};

BrokenRow widest_row(std::span<const Cell> cells) {
  BrokenRow widest, row;
  bool is_open = false;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    if (cells[c] == Cell::remains) is_open = false;
    if (cells[c] != Cell::broken) continue;
    if (!is_open) row.first = c, is_open = true;
    row.behind = c + 1;
    if (row.cells() > widest.cells()) widest = row;
  }
  return widest;
}

std::vector<bool> remaining_fragments(std::span<const std::int32_t> fragments, double least_share) {
  std::vector<std::size_t> particles(1 + static_cast<std::size_t>(*std::max_element(fragments.begin(), fragments.end())), 0);
  for (const std::int32_t fragment : fragments) ++particles[static_cast<std::size_t>(fragment)];
  std::vector<bool> remains;
  for (const std::size_t count : particles) remains.push_back(static_cast<double>(count) >= least_share * static_cast<double>(fragments.size()));
  return remains;
}

const deck::YamlNode* member(const deck::YamlNode* node, std::string_view key) {
  if (!node) return nullptr;
  const deck::YamlNode::Entry* entry = node->find(key);
  return entry ? &entry->value : nullptr;
}

/// Spacing [m] of a body with a failure criterion, from run.json.
double spacing_of(const std::filesystem::path& results, const std::string& body) {
  const std::filesystem::path file = output::ResultsFolder::run_in(results);
  if (!std::filesystem::exists(file))
    throw fccda::InputError(fmt::format("{} does not exist; the channel width is available once the run has ended or was interrupted.", file.string()));
  const deck::YamlNode run = deck::parse_document(fccda::contents_of(file), file.string());
  const deck::YamlNode* bodies = member(&run, "bodies");
  const deck::YamlNode* found = member(bodies, body);
  if (!found) {
    std::vector<std::string> names;
    if (bodies)
      for (const auto& entry : bodies->entries) names.push_back(entry.key);
    throw fccda::InputError(fmt::format("--channel: {} has no body {}; its bodies: {}.", results.string(), body,
                                        names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", "))));
  }
  const deck::YamlNode* spacing = member(found, "spacing [m]");
  if (!member(found, "fragments") || !spacing)
    throw fccda::InputError(
        fmt::format("--channel: body {} has no failure criterion, so it has no channel; set critical_stretch in its material, or failure in the body.", body));
  double value = 0;
  const char* const end = spacing->text.data() + spacing->text.size();
  if (const auto [last, error] = std::from_chars(spacing->text.data(), end, value); error != std::errc() || last != end || !(value > 0))
    throw fccda::InputError(fmt::format("{}: the spacing of body {} is \"{}\", but a length in metres is needed; use the file as written by the run.",
                                        file.string(), body, spacing->text));
  return value;
}

}  // namespace

std::vector<ChannelColumn> channel_columns(std::span<const Vec3d> places, std::span<const std::int32_t> fragments, double spacing, std::size_t axis,
                                           double least_share) {
  EXPECTS(axis < 2 && !places.empty() && places.size() == fragments.size() && spacing > 0);
  const std::size_t across = 1 - axis;
  const std::vector<bool> remains = remaining_fragments(fragments, least_share);
  Vec3d low = places[0], high = low;
  for (const Vec3d& place : places)
    for (std::size_t c = 0; c < 2; ++c) low[c] = std::min(low[c], place[c]), high[c] = std::max(high[c], place[c]);
  // frames have single precision
  for (std::size_t c = 0; c < 2; ++c) low[c] = std::round(low[c] / (1e-3 * spacing)) * 1e-3 * spacing;
  const auto cell = [&](const Vec3d& place, std::size_t c) { return static_cast<std::size_t>(std::lround(std::max(0.0, place[c] - low[c]) / spacing)); };
  const std::size_t columns = cell(high, axis) + 1, rows = cell(high, across) + 1;

  std::vector<Cell> cells(columns * rows, Cell::empty);
  for (std::size_t p = 0; p < places.size(); ++p) {
    Cell& at = cells[cell(places[p], axis) * rows + cell(places[p], across)];
    if (remains[static_cast<std::size_t>(fragments[p])])
      at = Cell::remains;
    else if (at == Cell::empty)
      at = Cell::broken;
  }

  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  std::vector<ChannelColumn> channel;
  for (std::size_t column = 0; column < columns; ++column) {
    const std::span<const Cell> all = std::span(cells).subspan(column * rows, rows);
    const BrokenRow widest = widest_row(all);
    const double edge = low[across] - 0.5 * spacing;
    ChannelColumn one{.along = low[axis] + static_cast<double>(column) * spacing, .low = none, .high = none, .width = 0, .all_broken = 0};
    if (widest.cells() > 0) {
      one.low = edge + static_cast<double>(widest.first) * spacing;
      one.high = edge + static_cast<double>(widest.behind) * spacing;
      one.width = static_cast<double>(widest.cells()) * spacing;
    }
    one.all_broken = static_cast<double>(std::count(all.begin(), all.end(), Cell::broken)) * spacing;
    channel.push_back(one);
  }
  return channel;
}

ChannelWidths widths_of(std::span<const ChannelColumn> columns, double spacing, double low, double high) {
  ChannelWidths widths;
  std::vector<const ChannelColumn*> with_channel;
  for (const ChannelColumn& column : columns) {
    if (column.along < low || column.along > high) continue;
    widths.all_broken += column.all_broken * spacing;
    if (column.width > 0) with_channel.push_back(&column);
  }
  if (with_channel.empty()) return widths;
  const double count = static_cast<double>(with_channel.size());
  const auto narrower = [](const ChannelColumn* a, const ChannelColumn* b) { return a->width < b->width; };
  const ChannelColumn &narrowest = **std::min_element(with_channel.begin(), with_channel.end(), narrower),
                      &widest = **std::max_element(with_channel.begin(), with_channel.end(), narrower);
  widths.mean = narrowest.width;  // accumulate differences, so that equal widths have exactly their mean
  for (const ChannelColumn* column : with_channel) widths.mean += (column->width - narrowest.width) / count;
  for (const ChannelColumn* column : with_channel) widths.deviation += (column->width - widths.mean) * (column->width - widths.mean) / count;
  widths.deviation = std::sqrt(widths.deviation);
  widths.length = count * spacing;
  widths.area = widths.mean * widths.length;
  widths.narrowest = narrowest.width, widths.narrowest_at = narrowest.along;
  widths.widest = widest.width, widths.widest_at = widest.along;
  return widths;
}

/// Reference positions of the particles of a frame. A moving window has other ones in every frame, so they are from its displacements where it has them.
std::vector<Vec3d> reference_places(const frames::Frame& frame, const output::FrameFile& first, const std::string& name) {
  if (const frames::FrameArray* displacement = frame.find("displacement"); displacement != nullptr && displacement->components == 3) {
    std::vector<Vec3d> places = frame.points;
    for (std::size_t p = 0; p < places.size(); ++p)
      for (std::size_t c = 0; c < 3; ++c) places[p][c] -= displacement->numbers[3 * p + c];
    return places;
  }
  if (first.time != 0)
    throw fccda::InputError(
        fmt::format("{} has no field displacement and there is no frame at t = 0 s, but the channel width needs the positions before deformation; run the deck "
                    "with displacement in output.frame_fields.",
                    name));
  return frames::read_frame(first).points;
}

ChannelFrame read_channel_frame(const std::filesystem::path& results, const std::string& body, std::optional<double> latest) {
  ChannelFrame frame;
  frame.spacing = spacing_of(results, body);
  std::filesystem::path list = output::ResultsFolder::frames_in(results) / (body + ".vtkhdf");
  if (!std::filesystem::exists(list)) list.replace_extension(".pvd");
  if (!std::filesystem::exists(list))
    throw fccda::InputError(fmt::format("{} does not exist; the channel width is read from frames, so the run needs output.frames.", list.string()));
  const std::vector<output::FrameFile> all = frames::frames_of(list);
  const auto behind = std::find_if(all.begin(), all.end(), [&](const output::FrameFile& one) { return latest && one.time > *latest; });
  if (behind == all.begin()) throw fccda::InputError(fmt::format("{} lists no frame up to {:.4g} s; use a later --to.", list.string(), latest.value_or(0)));
  const output::FrameFile& last = *std::prev(behind);
  frame.name = last.name();
  frame.time = last.time;
  const frames::Frame read = frames::read_frame(last);
  if (read.find("particle") != nullptr)
    throw fccda::InputError(fmt::format(
        "{} has a part of the particles only, but the channel width needs all of them; run the deck without output.frame_particles for it.", frame.name));
  const frames::FrameArray* fragments = read.find("fragment");
  if (fragments == nullptr)
    throw fccda::InputError(
        fmt::format("{} has no field fragment, from which the channel width is determined; run the deck with fragment in output.frame_fields.", frame.name));
  if (fragments->components != 1)
    throw fccda::InputError(fmt::format("{} has no array fragment of one number per particle; use the file as written by the run.", frame.name));
  for (const double fragment : fragments->numbers) {
    if (!(fragment >= 0 && fragment < static_cast<double>(fragments->numbers.size())))
      throw fccda::InputError(fmt::format("{}: {} is no number of a fragment; use the file as written by the run.", frame.name, fragment));
    frame.fragments.push_back(static_cast<std::int32_t>(fragment));
  }
  frame.places = reference_places(read, all.front(), frame.name);
  if (frame.places.size() != frame.fragments.size() || frame.places.empty())
    throw fccda::InputError(fmt::format("{} and {} have different numbers of particles; use the files of one run.", all.front().name(), frame.name));
  return frame;
}

}  // namespace perimpact
