#include "io/deck/time_series.hpp"

#include <fmt/format.h>

#include <string_view>
#include <utility>

#include "io/deck/table_parser.hpp"

namespace perimpact::deck {

namespace {

/// The two columns of a line; a second comma stays in the second.
std::pair<std::string_view, std::string_view> columns_of(std::string_view line) {
  const std::size_t comma = line.find(',');
  return comma == std::string_view::npos ? std::pair(trimmed_cell(line), std::string_view())
                                         : std::pair(trimmed_cell(line.substr(0, comma)), trimmed_cell(line.substr(comma + 1)));
}

class TimeSeriesParser : public TableParser {
 public:
  TimeSeriesParser(const std::string& file, bool of_rotation) : TableParser(file, "two"), of_rotation_(of_rotation) {}

  void header(std::string_view line) {
    const auto [time, value] = columns_of(line);
    const auto [time_name, time_unit] = named(time);
    const auto [value_name, value_unit] = named(value);
    if (time_name != "time" || (value_name != "velocity" && value_name != "displacement")) fail_header(line);
    series_.is_displacement = value_name == "displacement";
    time_factor_ = factor(time_unit, "s");
    value_factor_ = factor(value_unit, series_.is_displacement ? (of_rotation_ ? "rad" : "m") : (of_rotation_ ? "rad/s" : "m/s"));
  }

  void row(std::string_view line) {
    if (trimmed_cell(line).empty()) return;
    const auto [time, value] = columns_of(line);
    const double at = number(time, time_factor_, line);
    if (!series_.times.empty() && at <= series_.times.back())
      fail(fmt::format("the time {} s follows {} s, but times must increase.", at, series_.times.back()));
    series_.times.push_back(at);
    series_.values.push_back(number(value, value_factor_, line));
  }

  TimeSeries finish() {
    if (series_.times.empty()) fail("there are no rows of numbers below the header line; add them.");
    return std::move(series_);
  }

 private:
  [[noreturn]] void fail_header(std::string_view line) const {
    fail(fmt::format("the first line is \"{}\", but it must name the two columns: \"time [s], velocity [{}]\" or \"time [s], displacement [{}]\".",
                     excerpt(line), of_rotation_ ? "rad/s" : "m/s", of_rotation_ ? "rad" : "m"));
  }

  /// "velocity [m/s]" to its name and unit.
  static std::pair<std::string_view, std::string_view> named(std::string_view column) {
    const std::size_t open = column.find('[');
    if (open == std::string_view::npos || !column.ends_with(']')) return {};
    return {trimmed_cell(column.substr(0, open)), trimmed_cell(column.substr(open + 1, column.size() - open - 2))};
  }

  bool of_rotation_;
  double time_factor_ = 1, value_factor_ = 1;
  TimeSeries series_;
};

}  // namespace

TimeSeries read_time_series(const std::filesystem::path& path, bool of_rotation, const std::string& place) {
  return parsed_table(path, place, [&](const std::string& file) { return TimeSeriesParser(file, of_rotation); });
}

}  // namespace perimpact::deck
