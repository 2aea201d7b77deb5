#include "cli/channel_text.hpp"

#include <fmt/format.h>

#include <limits>
#include <span>
#include <string_view>
#include <utility>

#include "base/error.hpp"
#include "cli/row.hpp"
#include "io/deck/units.hpp"
#include "io/output/csv.hpp"
#include "io/output/results_folder.hpp"
#include "io/statistics/channel.hpp"

namespace perimpact {

namespace {

/// The body and the axis (0 or 1) of "ice:x".
std::pair<std::string, std::size_t> body_and_axis(const std::string& words) {
  const std::size_t colon = words.rfind(':');
  const std::string_view axis = colon == std::string::npos ? std::string_view() : std::string_view(words).substr(colon + 1);
  if (axis != "x" && axis != "y")
    throw fccda::InputError(fmt::format("--channel is {}, but it must be a body and the axis along which the channel runs, such as ice:x or ice:y.", words));
  return {words.substr(0, colon), axis == "x" ? 0 : 1};
}

}  // namespace

std::optional<double> quantity_of_option(const char* option, const std::string& text, const char* unit) {
  if (text.empty()) return {};
  const deck::Converted converted = deck::to_si(text, unit);
  if (!converted.complaint.empty()) throw fccda::InputError(fmt::format("{} is {}: {}.", option, text, converted.complaint));
  return converted.value;
}

std::string channel_text(const StatisticsArguments& arguments, std::optional<double> latest) {
  const StatisticsArguments::Channel& wanted = arguments.channel;
  const auto [body, axis] = body_and_axis(wanted.of);
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const double low = quantity_of_option("--channel-from", wanted.from, "m").value_or(-infinite);
  const double high = quantity_of_option("--channel-to", wanted.to, "m").value_or(infinite);
  if (!(low < high)) throw fccda::InputError(fmt::format("--channel-from is {:.4g} m, but it must be below --channel-to, which is {:.4g} m.", low, high));
  if (!(wanted.sheet > 0 && wanted.sheet <= 1))
    throw fccda::InputError(fmt::format(
        "--sheet is {}, but it must be above 0 and at most 1: the share of a body's particles above which a fragment belongs to the remaining sheet.",
        wanted.sheet));

  const char along = "xy"[axis], across = "yx"[axis];
  const std::filesystem::path file = output::ResultsFolder::fragments_in(arguments.folder) / fmt::format("{}_channel_{}.csv", body, along);
  const std::string listed = (std::filesystem::path("fragments") / file.filename()).string();
  const ChannelFrame frame = read_channel_frame(arguments.folder, body, latest);
  const std::vector<ChannelColumn> columns = channel_columns(frame.places, frame.fragments, frame.spacing, axis, wanted.sheet);
  const ChannelWidths widths = widths_of(columns, frame.spacing, low, high);

  std::vector<double> rows;
  for (const ChannelColumn& column : columns) rows.insert(rows.end(), {column.along, column.low, column.high, column.width, column.all_broken});
  const std::vector<std::string> names = {fmt::format("along_{} [m]", along), fmt::format("low_{} [m]", across), fmt::format("high_{} [m]", across),
                                          "width [m]", "all_broken [m]"};
  output::claim_files(arguments.folder, std::span(&listed, 1));
  output::write_csv(file, names, rows);

  std::string text = fmt::format("channel along {} in body {} at {:.6g} s ({})\n", along, body, frame.time, frame.name);
  if (widths.length == 0) {
    text +=
        row("none", fmt::format("no column is broken through; fragments of {:.3g} % of the particles or more form the remaining sheet", 100 * wanted.sheet));
  } else {
    text += row("length", fmt::format("{:.5g} m of columns broken through", widths.length));
    text += row("width", fmt::format("mean {:.5g} m, standard deviation {:.3g} m", widths.mean, widths.deviation));
    text += row("narrowest", fmt::format("{:.5g} m at {} = {:.5g} m", widths.narrowest, along, widths.narrowest_at));
    text += row("widest", fmt::format("{:.5g} m at {} = {:.5g} m", widths.widest, along, widths.widest_at));
    text += row("area", fmt::format("{:.5g} m2 of the channel, {:.5g} m2 of all areas broken through", widths.area, widths.all_broken));
  }
  return text + row("in", file.string());
}

}  // namespace perimpact
