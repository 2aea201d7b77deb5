/// Parsers of CSV tables whose header line names columns and units.
#pragma once

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <system_error>

#include "io/deck/deck_file.hpp"
#include "io/deck/trimmed.hpp"
#include "io/deck/units.hpp"
#include "io/deck/yaml_node.hpp"

namespace perimpact::deck {

/// What they have in common: messages with file and line, units, and numbers in SI units.
class TableParser {
 public:
  void begin_line() { ++line_; }

 protected:
  /// `columns`: their number in words, for messages.
  TableParser(const std::string& file, std::string_view columns) : file_(file), columns_(columns) {}

  [[noreturn]] void fail(std::string_view sentence) const { refuse(fmt::format("{}:{}", file_, line_), sentence); }
  [[noreturn]] void fail_row(std::string_view line) const {
    fail(fmt::format("\"{}\" is not {} comma-separated numbers; correct the row.", excerpt(line), columns_));
  }
  /// The beginning of a line, for messages.
  static std::string_view excerpt(std::string_view line) { return trimmed_cell(line.substr(0, 60)); }

  /// One of a unit in the SI unit `si`.
  double factor(std::string_view unit, std::string_view si) const {
    const Converted one = to_si(fmt::format("1 {}", unit), si);
    if (!one.complaint.empty()) fail(fmt::format("the unit of a column is [{}], but {}.", unit, one.complaint));
    return one.value;
  }

  /// The number in a cell of a line, times `factor`.
  double number(std::string_view cell, double factor, std::string_view line) const {
    const std::string_view digits = cell.starts_with('+') ? cell.substr(1) : cell;
    double value{};
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (digits.empty() || error != std::errc{} || end != digits.data() + digits.size() || !std::isfinite(value)) fail_row(line);
    if (!std::isfinite(factor * value)) fail(fmt::format("the row \"{}\" has a number that is too large in SI units; correct it.", excerpt(line)));
    return factor * value;
  }

 private:
  const std::string& file_;
  std::string_view columns_;
  std::size_t line_ = 0;
};

/// What `make(full path)`, a parser, makes of the lines of a file. `place`: where the deck names it. Throws InputError.
template <class Make>
auto parsed_table(const std::filesystem::path& path, const std::string& place, const Make& make) {
  const std::string file = full_path(path, place);
  std::ifstream stream = open_file(file, place);
  auto parser = make(file);
  std::string line;
  std::getline(stream, line);
  parser.begin_line();
  const std::string_view header = line;
  parser.header(header.starts_with("\xEF\xBB\xBF") ? header.substr(3) : header);  // without the byte order mark
  while (std::getline(stream, line)) {
    parser.begin_line();
    parser.row(line);
  }
  return parser.finish();
}

}  // namespace perimpact::deck
