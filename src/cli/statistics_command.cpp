#include "cli/statistics_command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>

#include "base/error.hpp"
#include "cli/channel_text.hpp"
#include "io/output/csv.hpp"
#include "io/output/file.hpp"
#include "io/output/results_folder.hpp"
#include "io/statistics/block_average.hpp"
#include "io/statistics/series.hpp"
#include "io/statistics/spectrum.hpp"
#include "io/statistics/table.hpp"

namespace perimpact {

using fccda::InputError;

namespace {

/// The rows that are evaluated.
struct Window {
  double from, to;           // [s]
  std::size_t first, count;  // rows within it, without that of the start time
  double interval;           // [s] the median between them
};

/// One of the equal parts of the window.
struct Part {
  double from, to;  // [s]
  double mean, maximum, minimum;
};

/// Statistics of a column.
struct Summary {
  std::string name;
  double mean, deviation;
  std::optional<BlockAverage> blocks;
  Extreme maximum, minimum;
  std::vector<Part> parts;
  std::optional<Spectrum> spectrum;

  /// Of the mean; NaN if there are too few rows.
  double standard_error() const { return blocks ? blocks->standard_error : std::numeric_limits<double>::quiet_NaN(); }
  /// [s]; NaN if there is none
  double period() const {
    const std::size_t k = spectrum ? spectrum->highest() : 0;
    return k == 0 ? std::numeric_limits<double>::quiet_NaN() : 1 / spectrum->frequency(k);
  }
};

constexpr std::size_t fewest_for_spectrum = 16;

Table expected_history(const std::filesystem::path& folder) {
  Table table = read_history(folder);
  if (table.names.front() != "time [s]")
    throw InputError(fmt::format("{}: the first column is not time [s]; use the file as written by the run.", table.file.string()));
  const std::vector<double>& times = table.columns.front();
  if (times.size() < 2) throw InputError(fmt::format("{} has fewer than two rows, so there is no interval to evaluate; run for longer.", table.file.string()));
  for (std::size_t row = 1; row < times.size(); ++row)
    if (!(times[row] > times[row - 1]))
      throw InputError(fmt::format("{}:{}: time goes from {} s to {} s, but it must increase; use the file as written by the run.", table.file.string(),
                                   row + 2, times[row - 1], times[row]));
  return table;
}

Window window_of(const Table& table, std::optional<double> from, std::optional<double> to) {
  const std::vector<double>& times = table.columns.front();
  Window window{.from = std::max(from.value_or(times.front()), times.front()),
                .to = std::min(to.value_or(times.back()), times.back()),
                .first = 0,
                .count = 0,
                .interval = 0};
  if (!(window.from < window.to))
    throw InputError(fmt::format("--from {:.6g} s and --to {:.6g} s leave no time of {}, whose rows range from {:.6g} to {:.6g} s.",
                                 from.value_or(times.front()), to.value_or(times.back()), table.file.string(), times.front(), times.back()));
  std::vector<double> intervals;
  for (std::size_t row = 1; row < times.size(); ++row) {
    if (times[row] <= window.from || times[row - 1] >= window.to) continue;
    if (intervals.empty()) window.first = row;
    intervals.push_back(times[row] - times[row - 1]);
  }
  window.count = intervals.size();
  std::nth_element(intervals.begin(), intervals.begin() + static_cast<std::ptrdiff_t>(intervals.size() / 2), intervals.end());
  window.interval = intervals[intervals.size() / 2];
  if (!(window.to - window.from > 1e-6 * window.interval))
    throw InputError(
        fmt::format("--from and --to are {:.3g} s apart, less than a millionth of the interval between rows of {}, which is {:.4g} s; choose a longer time.",
                    window.to - window.from, table.file.string(), window.interval));
  return window;
}

void expect_finite(const Table& table, std::size_t column, const Window& window) {
  for (std::size_t row = window.first - 1; row < window.first + window.count; ++row)
    if (!std::isfinite(table.columns[column][row]))
      throw InputError(fmt::format("{}:{}: {} is not a finite number; choose rows before it with --to.", table.file.string(), row + 2, table.names[column]));
}

/// Number of whole intervals in the window, with a margin for rounding.
std::size_t intervals_in(const Window& window) { return static_cast<std::size_t>((window.to - window.from) / window.interval * (1 + 1e-9)); }

/// Length of a segment of the spectrum; 0 if there are too few rows.
std::size_t segment_of(const Window& window, std::optional<double> wanted) {
  const std::size_t values = intervals_in(window);
  if (!wanted) return values < fewest_for_spectrum ? 0 : default_segment(values);
  const double length = std::floor(*wanted / window.interval * (1 + 1e-9));
  if (!(length >= static_cast<double>(fewest_for_spectrum) && length <= static_cast<double>(values)))
    throw InputError(fmt::format("--segment is {:.6g} s, but it must cover from {} rows to all {} of the chosen time: {:.6g} to {:.6g} s.", *wanted,
                                 fewest_for_spectrum, values, static_cast<double>(fewest_for_spectrum) * window.interval,
                                 static_cast<double>(values) * window.interval));
  return std::bit_floor(static_cast<std::size_t>(length));
}

double edge_of(const Window& window, int windows, int k) { return window.from + (window.to - window.from) * k / windows; }

Summary summary_of(const Table& table, std::size_t column, const Window& window, int windows, std::size_t segment) {
  expect_finite(table, column, window);
  const Series series(table.columns.front(), table.columns[column], table.facts[column].is_mean ? RowIs::mean_since_row_before : RowIs::value_at_its_time);
  const std::vector<double> even = series.resampled(window.from, window.interval, intervals_in(window));
  Summary summary{.name = table.names[column],
                  .mean = series.mean(window.from, window.to),
                  .deviation = series.standard_deviation(window.from, window.to),
                  .blocks = block_average(even),
                  .maximum = series.maximum(window.from, window.to),
                  .minimum = series.minimum(window.from, window.to),
                  .parts = {},
                  .spectrum = {}};
  for (int k = 0; k < windows; ++k) {
    const double begin = edge_of(window, windows, k), end = edge_of(window, windows, k + 1);
    summary.parts.push_back({begin, end, series.mean(begin, end), series.maximum(begin, end).value, series.minimum(begin, end).value});
  }
  if (segment > 0) summary.spectrum = welch(even, window.interval, segment);
  return summary;
}

/// "ship.force_x [N]" → "ship.force_x [N2/Hz]"
std::string density_column(const std::string& column) {
  const std::string_view unit = unit_of(column);
  const std::string squared = unit == "-" ? "1" : unit.find_first_of(" /") == std::string_view::npos ? fmt::format("{}2", unit) : fmt::format("({})2", unit);
  return fmt::format("{} [{}/Hz]", quantity_of(column), squared);
}

void write_statistics(const std::filesystem::path& file, const std::vector<Summary>& summaries) {
  std::string text =
      "column,unit,mean,standard_error,standard_error_is_bound,standard_deviation,maximum,maximum_at [s],minimum,minimum_at [s],dominant_period [s]\n";
  for (const Summary& one : summaries)
    text += fmt::format("{},{},{},{},{},{},{},{},{},{},{}\n", quantity_of(one.name), unit_of(one.name), one.mean, one.standard_error(),
                        one.blocks && !one.blocks->is_resolved ? 1 : 0, one.deviation, one.maximum.value, one.maximum.time, one.minimum.value, one.minimum.time,
                        one.period());
  output::write_whole_file(file, text);
}

void write_windows(const std::filesystem::path& file, const std::vector<Summary>& summaries) {
  std::vector<std::string> names = {"from [s]", "to [s]"};
  for (const Summary& one : summaries)
    for (const char* what : {"mean", "maximum", "minimum"}) names.push_back(fmt::format("{}.{} [{}]", quantity_of(one.name), what, unit_of(one.name)));
  std::vector<double> rows;
  for (std::size_t k = 0; k < summaries.front().parts.size(); ++k) {
    rows.insert(rows.end(), {summaries.front().parts[k].from, summaries.front().parts[k].to});
    for (const Summary& one : summaries) rows.insert(rows.end(), {one.parts[k].mean, one.parts[k].maximum, one.parts[k].minimum});
  }
  output::write_csv(file, names, rows);
}

void write_spectrum(const std::filesystem::path& file, const std::vector<Summary>& summaries) {
  const Spectrum& any = *summaries.front().spectrum;
  std::vector<std::string> names = {"frequency [Hz]"};
  for (const Summary& one : summaries) names.push_back(density_column(one.name));
  std::vector<double> rows;
  for (std::size_t k = 0; k < any.density.size(); ++k) {
    rows.push_back(any.frequency(k));
    for (const Summary& one : summaries) rows.push_back(one.spectrum->density[k]);
  }
  output::write_csv(file, names, rows);
}

std::string period_text(const Summary& one) {
  if (!one.spectrum) return "-";
  const std::size_t k = one.spectrum->highest();
  return k == 0 ? "-" : fmt::format("{}{:.4g}", k == 1 ? ">" : "", one.period());  // the lowest frequency includes all slower ones
}

std::string standard_error_text(const Summary& one) {
  if (!one.blocks) return "-";
  return fmt::format("{}{:.3g}", one.blocks->is_resolved ? "" : ">", one.blocks->standard_error);
}

void print_table(const std::vector<Summary>& summaries) {
  std::size_t widest = 6;
  for (const Summary& one : summaries) widest = std::max(widest, one.name.size());
  fmt::print("{:<{}} {:>11} {:>11} {:>11} {:>11} {:>10} {:>11} {:>10} {:>10}\n", "column", widest, "mean", "std. error", "deviation", "maximum", "at s",
             "minimum", "at s", "period s");
  for (const Summary& one : summaries)
    fmt::print("{:<{}} {:>11.4g} {:>11} {:>11.4g} {:>11.4g} {:>10.5g} {:>11.4g} {:>10.5g} {:>10}\n", one.name, widest, one.mean, standard_error_text(one),
               one.deviation, one.maximum.value, one.maximum.time, one.minimum.value, one.minimum.time, period_text(one));
}

void print_windows(const std::vector<Summary>& summaries) {
  for (const Summary& one : summaries) {
    fmt::print("\n{:<26} {:>11} {:>11} {:>11}\n", one.name, "mean", "maximum", "minimum");
    for (const Part& part : one.parts)
      fmt::print("{:<26} {:>11.4g} {:>11.4g} {:>11.4g}\n", fmt::format("  {:.5g} to {:.5g} s", part.from, part.to), part.mean, part.maximum, part.minimum);
  }
}

void print_spectrum(const Window& window, const Spectrum& spectrum) {
  fmt::print("\nspectrum: {} Hann window{} of {:.6g} s ({} intervals of {:.6g} s), half overlapping; resolution {:.4g} Hz, up to {:.4g} Hz\n",
             spectrum.segments, spectrum.segments == 1 ? "" : "s", static_cast<double>(spectrum.segment) * spectrum.interval, spectrum.segment, window.interval,
             spectrum.resolution(), 0.5 / spectrum.interval);
}

/// Removes output of earlier commands for other columns or times.
void remove_earlier(const std::filesystem::path& folder) {
  const output::FileList list = output::FileList::of(folder);
  std::error_code ignored;
  for (const char* name : {"windows.csv", "spectrum.csv"})
    if (list.contains(name)) std::filesystem::remove(folder / name, ignored);
}

void print_columns(const StatisticsArguments& arguments, const Table& table, const std::vector<std::size_t>& columns, const Window& window) {
  const std::size_t segment = segment_of(window, quantity_of_option("--segment", arguments.segment, "s"));
  std::vector<std::string> written = {"statistics.csv"};
  if (arguments.windows > 1) written.emplace_back("windows.csv");
  if (segment > 0) written.emplace_back("spectrum.csv");
  output::claim_files(arguments.folder, written);
  std::vector<Summary> summaries;
  for (const std::size_t column : columns) summaries.push_back(summary_of(table, column, window, arguments.windows, segment));

  fmt::print("{}: {} rows from {:.6g} to {:.6g} s, interval {:.4g} s\n\n", table.file.string(), window.count, window.from, window.to, window.interval);
  print_table(summaries);
  write_statistics(arguments.folder / "statistics.csv", summaries);
  remove_earlier(arguments.folder);
  if (arguments.windows > 1) {
    print_windows(summaries);
    write_windows(arguments.folder / "windows.csv", summaries);
  }
  if (segment > 0) {
    print_spectrum(window, *summaries.front().spectrum);
    write_spectrum(arguments.folder / "spectrum.csv", summaries);
  } else {
    fmt::print("\nspectrum: none, since {} intervals are fewer than the required {}\n", intervals_in(window), fewest_for_spectrum);
  }
  fmt::print("Written to {}: {}\n", arguments.folder.string(), fmt::join(written, ", "));
}

}  // namespace

int statistics_command(const StatisticsArguments& arguments) {
  const std::optional<double> from = quantity_of_option("--from", arguments.from, "s"), to = quantity_of_option("--to", arguments.to, "s");
  const Table table = expected_history(arguments.folder);
  const Window window = window_of(table, from, to);
  const std::vector<std::size_t> columns = arguments.columns.empty() ? columns_of_loads(table) : columns_named(table, arguments.columns);
  if (columns.empty() && arguments.channel.of.empty())
    throw InputError(fmt::format("{} has no columns of impactors and thus no loads; choose columns with --columns.", table.file.string()));
  const std::string channel = arguments.channel.of.empty() ? "" : channel_text(arguments, to);  // before any output, since it may throw
  if (!columns.empty()) print_columns(arguments, table, columns, window);
  if (!channel.empty()) fmt::print("{}{}", columns.empty() ? "" : "\n", channel);
  return 0;
}

}  // namespace perimpact
