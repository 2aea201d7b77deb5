#include "io/deck/time_series.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <string_view>

#include "io/deck/deck_file.hpp"
#include "io/deck/trimmed.hpp"
#include "io/deck/units.hpp"
#include "io/deck/yaml_node.hpp"

namespace perimpact::deck {

namespace {

/// The two columns of a line; a second comma stays in the second.
std::pair<std::string_view, std::string_view> columns_of(std::string_view line) {
  const std::size_t comma = line.find(',');
  return comma == std::string_view::npos ? std::pair(trimmed_cell(line), std::string_view())
                                         : std::pair(trimmed_cell(line.substr(0, comma)), trimmed_cell(line.substr(comma + 1)));
}

class TimeSeriesParser {
 public:
  TimeSeriesParser(const std::string& file, bool of_rotation) : file_(file), of_rotation_(of_rotation) {}

  void header(std::string_view line) {
    ++line_;
    const auto [time, value] = columns_of(line.starts_with("\xEF\xBB\xBF") ? line.substr(3) : line);
    const auto [time_name, time_unit] = named(time);
    const auto [value_name, value_unit] = named(value);
    if (time_name != "time" || (value_name != "velocity" && value_name != "displacement")) fail_header(line);
    series_.is_displacement = value_name == "displacement";
    time_factor_ = factor(time_unit, "s");
    value_factor_ = factor(value_unit, series_.is_displacement ? (of_rotation_ ? "rad" : "m") : (of_rotation_ ? "rad/s" : "m/s"));
  }

  void row(std::string_view line) {
    ++line_;
    if (trimmed_cell(line).empty()) return;
    const auto [time, value] = columns_of(line);
    const double at = time_factor_ * number(time, line), reached = value_factor_ * number(value, line);
    if (!std::isfinite(at) || !std::isfinite(reached)) fail(fmt::format("the row \"{}\" has a number that is too large in SI units; correct it.", line));
    if (!series_.times.empty() && at <= series_.times.back())
      fail(fmt::format("the time {} s follows {} s, but times must increase.", at, series_.times.back()));
    series_.times.push_back(at);
    series_.values.push_back(reached);
  }

  TimeSeries finish() {
    if (series_.times.empty()) fail("there are no rows of numbers below the header line; add them.");
    return std::move(series_);
  }

 private:
  [[noreturn]] void fail(std::string_view sentence) const { refuse(fmt::format("{}:{}", file_, line_), sentence); }

  [[noreturn]] void fail_header(std::string_view line) const {
    fail(fmt::format("the first line is \"{}\", but it must name the two columns: \"time [s], velocity [{}]\" or \"time [s], displacement [{}]\".",
                     trimmed_cell(line.substr(0, 60)), of_rotation_ ? "rad/s" : "m/s", of_rotation_ ? "rad" : "m"));
  }

  /// "velocity [m/s]" to its name and unit.
  static std::pair<std::string_view, std::string_view> named(std::string_view column) {
    const std::size_t open = column.find('[');
    if (open == std::string_view::npos || !column.ends_with(']')) return {};
    return {trimmed_cell(column.substr(0, open)), trimmed_cell(column.substr(open + 1, column.size() - open - 2))};
  }

  double factor(std::string_view unit, std::string_view si) const {
    const Converted one = to_si(fmt::format("1 {}", unit), si);
    if (!one.complaint.empty()) fail(fmt::format("the unit of a column is [{}], but {}.", unit, one.complaint));
    return one.value;
  }

  double number(std::string_view word, std::string_view line) const {
    const std::string_view digits = word.starts_with('+') ? word.substr(1) : word;
    double value{};
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (digits.empty() || error != std::errc{} || end != digits.data() + digits.size() || !std::isfinite(value))
      fail(fmt::format("\"{}\" is not two comma-separated numbers; correct the row.", trimmed_cell(line.substr(0, 60))));
    return value;
  }

  const std::string& file_;
  bool of_rotation_;
  std::size_t line_ = 0;
  double time_factor_ = 1, value_factor_ = 1;
  TimeSeries series_;
};

}  // namespace

TimeSeries read_time_series(const std::filesystem::path& path, bool of_rotation, const std::string& place) {
  const std::string file = full_path(path, place);
  std::ifstream stream = open_file(file, place);
  TimeSeriesParser parser(file, of_rotation);
  std::string line;
  std::getline(stream, line);
  parser.header(line);
  while (std::getline(stream, line)) parser.row(line);
  return parser.finish();
}

}  // namespace perimpact::deck
