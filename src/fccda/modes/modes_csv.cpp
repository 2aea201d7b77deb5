#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "base/error.hpp"
#include "fccda/modes/modes_file.hpp"
#include "mesh_io/file/text.hpp"
#include "mesh_io/file/words.hpp"

namespace fccda {
namespace {

constexpr std::string_view components[] = {"x", "y", "z", "xx", "yy", "zz", "xy", "yz", "zx"};
constexpr std::size_t vector_components = 3;

/// The cells of a line, without blanks about them.
std::vector<std::string_view> cells_of(std::string_view line) {
  std::vector<std::string_view> cells;
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t end = std::min(line.find(',', begin), line.size());
    cells.push_back(trimmed(line.substr(begin, end - begin), " \t\r"));
    begin = end + 1;
  }
  return cells;
}

/// "mode_1_x" of "mode_1_x [1/sqrt(kg)]".
std::string_view quantity_of(std::string_view cell) { return trimmed(cell.substr(0, cell.find('['))); }

class ModesCsv {
 public:
  ModesCsv(std::string_view contents, std::string file) : rest_(contents), file_(std::move(file)) {
    if (rest_.starts_with(byte_order_mark)) rest_.remove_prefix(byte_order_mark.size());
  }

  PointData parse() {
    while (next_line()) {
      if (columns_ == 0)
        parse_head();
      else
        parse_row();
    }
    if (columns_ == 0) fail("there is no line of column names, `x [m], y [m], z [m], mode_1_x, mode_1_y, mode_1_z` and so on; add it.");
    return std::move(out_);
  }

 private:
  [[noreturn]] void fail(const std::string& sentence) const { throw InputError(file_ + ":" + std::to_string(line_) + ": " + sentence); }

  /// Moves to the next line that is not blank.
  bool next_line() {
    do {
      if (rest_.empty()) return false;
      const std::size_t end = std::min(rest_.find('\n'), rest_.size());
      cells_ = cells_of(rest_.substr(0, end));
      rest_.remove_prefix(std::min(end + 1, rest_.size()));
      ++line_;
    } while (cells_.size() == 1 && cells_.front().empty());
    return true;
  }

  void parse_head() {
    if (cells_.front() == "frequency [Hz]" || cells_.front() == "damping_ratio") return parse_field_data();
    constexpr std::string_view coordinates[] = {"x [m]", "y [m]", "z [m]"};
    if (cells_.size() < std::size(coordinates) || !std::equal(std::begin(coordinates), std::end(coordinates), cells_.begin()))
      fail(
          "this line is neither `frequency [Hz]` nor `damping_ratio` with their numbers, nor the column names, which begin with `x [m], y [m], z [m]`; "
          "correct it.");
    columns_ = cells_.size();
    for (std::size_t c = std::size(coordinates); c < columns_; ++c) add_column(quantity_of(cells_[c]));
  }

  void parse_field_data() {
    TupleArray& array = out_.of_file.emplace_back(TupleArray{.name = std::string(cells_.front())});
    for (std::size_t c = 1; c < cells_.size(); ++c) array.values.push_back(number(cells_[c]));
  }

  /// The columns of an array are neighbours, in the order of its components.
  void add_column(std::string_view column) {
    const std::size_t mark = std::min(column.rfind('_'), column.size());
    const std::string_view name = column.substr(0, mark), component = mark < column.size() ? column.substr(mark + 1) : std::string_view{};
    if (out_.of_points.empty() || out_.of_points.back().name != name) out_.of_points.push_back({std::string(name), 0});
    TupleArray& array = out_.of_points.back();
    const bool is_vector = name.starts_with("mode_");
    const std::size_t first = is_vector ? 0 : vector_components, count = is_vector ? vector_components : std::size(components) - vector_components;
    if (array.components == count || component != components[first + array.components])
      fail("the column " + shown(column) +
           " is out of order; columns are mode_1_x, mode_1_y, mode_1_z and so on, and stress_1_xx, stress_1_yy, stress_1_zz, "
           "stress_1_xy, stress_1_yz, stress_1_zx.");
    ++array.components;
  }

  void parse_row() {
    if (cells_.size() != columns_)
      fail("the row has " + std::to_string(cells_.size()) + " numbers for " + std::to_string(columns_) + " columns; correct it or export the file again.");
    out_.points.push_back({number(cells_[0]), number(cells_[1]), number(cells_[2])});
    std::size_t c = 3;
    for (TupleArray& array : out_.of_points)
      for (std::size_t k = 0; k < array.components; ++k) array.values.push_back(number(cells_[c++]));
  }

  double number(std::string_view word) const {
    const auto value = parsed<double>(without_plus(word));
    if (!value || !std::isfinite(*value)) fail(shown(word) + " is not a finite number; correct it or export the file again.");
    return *value;
  }

  std::string_view rest_;
  std::string file_;
  std::size_t line_ = 0;
  std::vector<std::string_view> cells_;
  std::size_t columns_ = 0;
  PointData out_;
};

}  // namespace

PointData parse_modes_csv(std::string_view contents, const std::string& file) { return ModesCsv(contents, file).parse(); }

}  // namespace fccda
