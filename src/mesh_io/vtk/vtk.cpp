#include "mesh_io/vtk/vtk.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <span>
#include <utility>

#include "mesh_io/file/words.hpp"
#include "mesh_io/vtk/vtk_cells.hpp"
#include "mesh_io/vtk/vtk_numbers.hpp"

namespace fccda {
namespace {

Words& at_third_line(Words& words) {
  const bool is_vtk = words.next() == "#" && is_word(words.next_in_line(), "vtk") && is_word(words.next_in_line(), "datafile");
  if (!is_vtk) words.fail("a legacy VTK file begins with `# vtk DataFile Version`; the contents do not match the file extension.");
  words.skip_line();
  words.skip_line();  // a title, or nothing
  return words;
}

/// Point and cell attributes whose section line has a name and a type, with the number of components.
struct Attribute {
  std::string_view keyword;
  std::size_t components;  ///< 0: given on the line, before the type
};
constexpr Attribute attributes[] = {{"vectors", 3},  {"normals", 3},    {"texture_coordinates", 0}, {"tensors", 9},
                                    {"tensors6", 6}, {"global_ids", 1}, {"pedigree_ids", 1},        {"edge_flags", 1}};

/// The name as it was before VTK wrote blanks and other bytes as % and two hexadecimal digits.
std::string vtk_decoded(std::string_view name) {
  std::string out;
  for (std::size_t at = 0; at < name.size(); ++at) {
    unsigned char byte{};
    const char* const digits = name.data() + at + 1;
    const bool is_code = name[at] == '%' && at + 2 < name.size() && std::from_chars(digits, digits + 2, byte, 16).ptr == digits + 2;
    out += is_code ? static_cast<char>(byte) : name[at];
    if (is_code) at += 2;
  }
  return out;
}

class LegacyVtk {
 public:
  /// `is_wanted`: the arrays of point and field data to read when points are read.
  LegacyVtk(std::string_view contents, const std::string& file, ArrayFilter is_wanted = {})
      : file_(file), words_(contents, file), numbers_(at_third_line(words_), file), is_wanted_(std::move(is_wanted)) {}

  PointValues points(std::string_view wanted) {
    PointData read = point_arrays();
    if (read.of_points.empty())
      numbers_.fail("there is no scalar point array " + shown(wanted) + "; the file has" + (scalar_arrays_.empty() ? " none." : scalar_arrays_ + "."));
    return {.points = std::move(read.points), .values = std::move(read.of_points.front().values)};
  }

  PointData point_arrays() {
    parse_sections();
    const std::size_t count = points_.size() / 3;
    for (const TupleArray& one : read_.of_points) {
      if (one.values.size() != one.components * count)
        numbers_.fail("the array " + shown(one.name) + " has " + std::to_string(one.values.size()) + " numbers for " + std::to_string(count) +
                      " points; export the file again.");
    }
    for (std::size_t k = 0; k < points_.size(); k += 3) read_.points.push_back({points_[k], points_[k + 1], points_[k + 2]});
    return std::move(read_);
  }

  Elements parse() {
    parse_sections();
    VtkElements out(file_);
    out.begin_piece(points_);
    is_grid_ ? add_grid(out) : add_polydata(out);
    return out.take();
  }

 private:
  void parse_sections() {
    parse_kind();
    for (std::string_view section = words_.next(); !section.empty(); section = words_.next()) parse_section(section);
  }

  void parse_kind() {
    if (!is_word(words_.next(), "dataset")) words_.fail("the fourth line must name the DATASET; export the file again.");
    const std::string_view kind = words_.next_in_line();
    is_grid_ = is_word(kind, "unstructured_grid");
    if (!is_grid_ && !is_word(kind, "polydata")) {
      words_.fail("the DATASET is " + shown(kind) +
                  ", but surfaces are POLYDATA or UNSTRUCTURED_GRID; apply the filter Extract Surface in ParaView and save as .vtp.");
    }
    words_.skip_line();
  }

  void parse_section(std::string_view section) {
    if (is_word(section, "metadata")) return skip_metadata();
    if (is_word(section, "field")) return parse_field();
    if (is_word(section, "points")) return parse_points();
    if (is_word(section, "point_data")) return begin_data(false);
    if (is_word(section, "cell_data")) return begin_data(true);
    if (is_word(section, "scalars")) return parse_scalars();
    if (is_word(section, "color_scalars")) return skip_colours();
    if (is_word(section, "lookup_table")) return skip_lookup_table();
    if (is_grid_ && is_word(section, "cells")) return parse_cells("CELLS", cells_);
    if (is_grid_ && is_word(section, "cell_types")) return parse_types();
    constexpr std::string_view lists[] = {"VERTICES", "LINES", "POLYGONS", "TRIANGLE_STRIPS"};
    constexpr std::string_view lowered[] = {"vertices", "lines", "polygons", "triangle_strips"};
    for (std::size_t k = 0; k < lists_.size(); ++k)
      if (!is_grid_ && is_word(section, lowered[k])) return parse_cells(lists[k], lists_[k]);
    for (const Attribute& attribute : attributes)
      if (is_word(section, attribute.keyword)) return parse_attribute(attribute);
    numbers_.fail(shown(section) + " appears where a section is expected; a count before it or the file is damaged: export it again.");
  }

  void parse_points() {
    const std::size_t count = numbers_.count("POINTS");
    const NumberType type = numbers_.type("POINTS");
    check_count(count, "POINTS");
    points_ = numbers_.reals(3 * count, type, "POINTS");
  }

  /// Rejects counts whose small multiples would overflow 64 bits; the numbers themselves are checked on reading.
  void check_count(std::size_t count, std::string_view what) const {
    if (count > words_.remaining() + 1) {
      numbers_.fail(std::string(what) + " states " + std::to_string(count) + ", more than the " + std::to_string(words_.remaining()) +
                    " bytes after it can hold; the file is truncated or the count is damaged: export it again.");
    }
  }

  void parse_cells(std::string_view section, VtkCells& cells) {
    if (cells.size() > 0) numbers_.fail(std::string(section) + " is given twice; export the file again.");
    const std::size_t first = numbers_.count(section), second = numbers_.count(section);
    check_count(first, section);
    check_count(second, section);
    if (takes("offsets")) return parse_offsets(section, cells, first, second);
    const std::vector<std::int64_t> lists = numbers_.wholes(second, NumberType::int32, section);
    std::size_t at = 0;
    for (std::size_t c = 0; c < first; ++c) {
      const std::int64_t length = at < lists.size() ? lists[at++] : -1;
      if (length < 0 || static_cast<std::size_t>(length) > lists.size() - at)
        numbers_.fail(std::string(section) + " has a cell (number " + std::to_string(c) +
                      ", counted from 0) with more points than the section; export the file again.");
      const auto begin = lists.begin() + static_cast<std::ptrdiff_t>(at);
      cells.points.insert(cells.points.end(), begin, begin + static_cast<std::ptrdiff_t>(length));
      cells.ends.push_back(static_cast<std::int64_t>(cells.points.size()));
      at += static_cast<std::size_t>(length);
    }
    if (at != lists.size()) numbers_.fail(std::string(section) + " has more numbers than its cells; export the file again.");
  }

  /// Version 5: offsets of all cells, beginning with 0, then all points.
  void parse_offsets(std::string_view section, VtkCells& cells, std::size_t offsets, std::size_t points) {
    cells.ends = numbers_.wholes(offsets, numbers_.type(section), section);
    if (!takes("connectivity")) numbers_.fail(std::string(section) + " has no CONNECTIVITY after its OFFSETS; it is truncated: export it again.");
    cells.points = numbers_.wholes(points, numbers_.type(section), section);
    if (cells.ends.empty()) return;
    if (cells.ends.front() != 0) numbers_.fail(std::string(section) + " has OFFSETS that do not begin with 0; export the file again.");
    cells.ends.erase(cells.ends.begin());
  }

  /// Consumes the word if it is next.
  bool takes(std::string_view lowered) {
    const Words before = words_;
    if (is_word(words_.next(), lowered)) return true;
    words_ = before;
    return false;
  }

  void parse_types() {
    const std::size_t count = numbers_.count("CELL_TYPES");
    types_ = numbers_.wholes(count, NumberType::int32, "CELL_TYPES");
  }

  void begin_data(bool is_of_cells) {
    is_of_cells_ = is_of_cells;
    is_of_file_ = false;
    tuples_ = numbers_.count(is_of_cells ? "CELL_DATA" : "POINT_DATA");
  }

  void skip_metadata() {
    do words_.skip_line();
    while (!words_.next_in_line().empty());
  }

  /// Uses the array as part numbers where it ranks higher than the one found so far, or as the wanted array.
  void parse_array(std::string_view name, std::string_view type, std::size_t tuples, std::size_t components) {
    const int rank = is_of_cells_ && components == 1 ? vtk_part_rank(name) : -1;
    const std::string what = "the array " + shown(name);
    const std::optional<NumberType> number = vtk_number_type(type);
    if (!is_of_cells_ && number && takes_array(name, *number, tuples, components, what)) return;
    if (rank < 0 || !number || !is_whole(*number) || (part_rank_ >= 0 && part_rank_ <= rank)) return numbers_.skip(tuples, components, type, what);
    part_rank_ = rank;
    part_array_ = what;
    parts_ = numbers_.wholes(tuples, *number, what);
  }

  /// Reads the array if it is wanted; the first of its name.
  bool takes_array(std::string_view name, NumberType type, std::size_t tuples, std::size_t components, const std::string& what) {
    if (components == 1 && !is_of_file_) scalar_arrays_ += " " + shown(name);
    const std::string decoded = vtk_decoded(name);
    std::vector<TupleArray>& into = is_of_file_ ? read_.of_file : read_.of_points;
    const bool is_known = std::any_of(into.begin(), into.end(), [&](const TupleArray& one) { return one.name == decoded; });
    if (!is_wanted_ || is_known || !is_wanted_(decoded, components)) return false;
    check_count(tuples, what);
    check_count(components, what);
    into.push_back({decoded, components, numbers_.reals(tuples * components, type, what)});
    return true;
  }

  void parse_field() {
    numbers_.word();
    const std::size_t arrays = numbers_.count("FIELD");
    for (std::size_t a = 0; a < arrays; ++a) {
      while (takes("metadata")) skip_metadata();
      const std::string_view name = words_.next();
      if (name.empty()) numbers_.fail("the file ends in FIELD; it is truncated: export it again.");
      if (is_word(name, "null_array")) continue;
      const std::string what = "the array " + shown(name);
      const std::size_t components = numbers_.count(what), tuples = numbers_.count(what);
      parse_array(name, numbers_.word(), tuples, components);
    }
  }

  void parse_scalars() {
    const std::string_view name = numbers_.word(), type = numbers_.word();
    std::size_t components = 1;
    const Words before = words_;
    if (!numbers_.word().empty()) words_ = before, components = numbers_.count("SCALARS");
    if (takes("lookup_table")) numbers_.word();
    parse_array(name, type, tuples_, components);
  }

  void parse_attribute(const Attribute& attribute) {
    const std::string_view name = numbers_.word();
    const std::string what = "the array " + shown(name);
    const std::size_t components = attribute.components == 0 ? numbers_.count(what) : attribute.components;
    parse_array(name, numbers_.word(), tuples_, components);
  }

  void skip_colours() {
    numbers_.word();
    numbers_.skip(tuples_, numbers_.count("COLOR_SCALARS"), "unsigned_char", "COLOR_SCALARS");
  }

  void skip_lookup_table() {
    numbers_.word();
    numbers_.skip(numbers_.count("LOOKUP_TABLE"), 4, "unsigned_char", "LOOKUP_TABLE");
  }

  void check_parts(std::size_t cells) const {
    if (part_rank_ >= 0 && parts_.size() != cells) {
      numbers_.fail(part_array_ + " has " + std::to_string(parts_.size()) + " numbers for " + std::to_string(cells) + " cells; export the file again.");
    }
  }

  void add_grid(VtkElements& out) const {
    if (types_.size() != cells_.size()) {
      numbers_.fail("CELL_TYPES has " + std::to_string(types_.size()) + " types for " + std::to_string(cells_.size()) + " cells; export the file again.");
    }
    check_parts(cells_.size());
    if (cells_.size() > 0) out.add(cells_, types_, parts_);
  }

  /// Cell data are ordered by vertices, lines, polygons and strips, whatever their order in the file.
  void add_polydata(VtkElements& out) const {
    std::size_t all = 0;
    for (const VtkCells& list : lists_) all += list.size();
    check_parts(all);
    std::span<const std::int64_t> parts = parts_;
    constexpr std::int64_t types[] = {vtk_poly_vertex, vtk_poly_line, vtk_polygon, vtk_triangle_strip};
    for (std::size_t k = 0; k < lists_.size(); ++k) {
      out.add(lists_[k], std::span(types).subspan(k, 1), parts.empty() ? parts : parts.first(lists_[k].size()));
      if (!parts.empty()) parts = parts.subspan(lists_[k].size());
    }
  }

  const std::string& file_;
  Words words_;
  VtkNumbers numbers_;
  bool is_grid_ = false;
  std::vector<double> points_;
  std::array<VtkCells, 4> lists_;  // of POLYDATA: vertices, lines, polygons, strips
  VtkCells cells_;                 // of UNSTRUCTURED_GRID
  std::vector<std::int64_t> types_;
  bool is_of_cells_ = false;  // whether the data sections hold cell data
  bool is_of_file_ = true;    // or data of the whole file, before all point and cell data
  std::size_t tuples_ = 0;
  int part_rank_ = -1;
  std::string part_array_;
  std::vector<std::int64_t> parts_;
  ArrayFilter is_wanted_;
  PointData read_;             // but for the points
  std::string scalar_arrays_;  // names of the scalar point arrays
};

}  // namespace

Elements parse_vtk(std::string_view contents, const std::string& file) { return LegacyVtk(contents, file).parse(); }

PointValues parse_vtk_points(std::string_view contents, const std::string& file, std::string_view array) {
  return LegacyVtk(contents, file, [array](std::string_view name, std::size_t components) { return components == 1 && name == array; }).points(array);
}

PointData parse_vtk_arrays(std::string_view contents, const std::string& file, const ArrayFilter& is_wanted) {
  return LegacyVtk(contents, file, is_wanted).point_arrays();
}

}  // namespace fccda
