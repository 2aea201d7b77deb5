#include "io/deck/point_list.hpp"

#include <fmt/format.h>

#include <array>
#include <string_view>
#include <utility>
#include <vector>

#include "io/deck/table_parser.hpp"

namespace perimpact::deck {

namespace {

constexpr std::array<std::string_view, 4> column_names = {"x", "y", "z", "volume"};
constexpr std::string_view header_example = "\"x [m], y [m], z [m], volume [m3]\"";

/// The comma-separated cells of a line.
std::vector<std::string_view> cells_of(std::string_view line) {
  std::vector<std::string_view> cells;
  for (;;) {
    const std::size_t comma = line.find(',');
    cells.push_back(trimmed_cell(line.substr(0, comma)));
    if (comma == std::string_view::npos) return cells;
    line.remove_prefix(comma + 1);
  }
}

class PointListParser : public TableParser {
 public:
  explicit PointListParser(const std::string& file) : TableParser(file, "four") {}

  void header(std::string_view line) {
    const auto cells = cells_of(line);
    std::array<bool, 4> is_named{};
    if (cells.size() != column_names.size()) fail_header(line);
    for (std::size_t cell = 0; cell < cells.size(); ++cell) {
      const std::size_t open = cells[cell].find('[');
      if (open == std::string_view::npos || !cells[cell].ends_with(']')) fail_header(line);
      const std::string_view name = trimmed_cell(cells[cell].substr(0, open));
      std::size_t column = 0;
      while (column < column_names.size() && column_names[column] != name) ++column;
      if (column == column_names.size() || is_named[column]) fail_header(line);
      is_named[column] = true;
      column_of_[cell] = column;
      factor_[column] = factor(cells[cell].substr(open + 1, cells[cell].size() - open - 2), column < 3 ? "m" : "m3");
    }
  }

  void row(std::string_view line) {
    if (trimmed_cell(line).empty()) return;
    std::array<double, 4> values{};
    std::string_view rest = line;
    for (std::size_t cell = 0; cell < values.size(); ++cell) {
      const std::size_t comma = rest.find(',');
      if ((comma == std::string_view::npos) != (cell + 1 == values.size())) fail_row(line);
      values[column_of_[cell]] = number(trimmed_cell(rest.substr(0, comma)), factor_[column_of_[cell]], line);
      rest.remove_prefix(comma == std::string_view::npos ? rest.size() : comma + 1);
    }
    if (!(values[3] > 0)) fail(fmt::format("the volume is {} m3, but it must be above 0; correct or remove the row.", values[3]));
    list_.points.push_back({values[0], values[1], values[2]});
    list_.volumes.push_back(values[3]);
  }

  PointList finish() {
    if (list_.points.empty()) fail("there are no rows of numbers below the header line; add them.");
    return std::move(list_);
  }

 private:
  [[noreturn]] void fail_header(std::string_view line) const {
    fail(fmt::format("the first line is \"{}\", but it must name the four columns with their units: {}.", excerpt(line), header_example));
  }

  std::array<std::size_t, 4> column_of_{};
  std::array<double, 4> factor_{1, 1, 1, 1};
  PointList list_;
};

}  // namespace

PointList read_point_list(const std::filesystem::path& path, const std::string& place) {
  return parsed_table(path, place, [](const std::string& file) { return PointListParser(file); });
}

}  // namespace perimpact::deck
