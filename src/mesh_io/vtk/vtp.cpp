#include "mesh_io/vtk/vtp.hpp"

#include <algorithm>
#include <charconv>
#include <initializer_list>
#include <span>
#include <utility>
#include <vector>

#include "mesh_io/file/words.hpp"
#include "mesh_io/vtk/vtk_cells.hpp"
#include "mesh_io/vtk/vtp_arrays.hpp"
#include "mesh_io/vtk/xml.hpp"

namespace fccda {
namespace {

constexpr std::pair<std::string_view, NumberType> types[] = {{"Int8", NumberType::int8},      {"UInt8", NumberType::uint8},   {"Int16", NumberType::int16},
                                                             {"UInt16", NumberType::uint16},  {"Int32", NumberType::int32},   {"UInt32", NumberType::uint32},
                                                             {"Int64", NumberType::int64},    {"UInt64", NumberType::uint64}, {"Float32", NumberType::float32},
                                                             {"Float64", NumberType::float64}};

/// A required array; `section` is its enclosing element.
struct FoundArray {
  std::string_view section, name;
  VtpArray array;
  std::size_t components = 1;  // of an array of PointData or FieldData
  std::size_t tuples = 0;      // of FieldData
};

struct Piece {
  std::size_t line = 0;
  std::size_t points = 0, cells = 0, vertices = 0, lines = 0, polygons = 0, strips = 0;  // how many of each
  std::vector<FoundArray> arrays;
  int part_rank = -1;
  VtpArray part;
  std::string point_arrays;  // ", " and the name of each scalar point array
};

class VtkXml {
 public:
  /// `is_wanted`: the arrays of PointData and FieldData to read when points are read.
  VtkXml(std::string_view contents, const std::string& file, ArrayFilter is_wanted = {})
      : file_(file), size_(contents.size()), tags_(contents, file), is_wanted_(std::move(is_wanted)) {}

  PointValues points(std::string_view wanted) {
    parse_tags();
    PointValues out;
    VtpArrays arrays(encoding_, file_, size_);
    for (const Piece& piece : pieces_) {
      if (piece.points == 0) continue;
      const FoundArray* found = find(piece, "PointData", wanted);
      if (found == nullptr)
        tags_.fail(piece.line, "the piece has no scalar point array " + shown(wanted) + "; it has " +
                                   (piece.point_arrays.empty() ? "none." : piece.point_arrays.substr(2) + "."));
      const std::vector<double> values = arrays.reals(found->array, piece.points);
      out.values.insert(out.values.end(), values.begin(), values.end());
      add_points(out.points, arrays, piece);
    }
    return out;
  }

  PointData point_arrays() {
    parse_tags();
    PointData out;
    VtpArrays arrays(encoding_, file_, size_);
    for (const FoundArray& one : field_data_)
      out.of_file.push_back({std::string(one.name), one.components, arrays.reals(one.array, one.components * one.tuples)});
    for (const Piece& piece : pieces_) {
      if (piece.points == 0) continue;
      if (out.points.empty()) {
        for (const FoundArray& one : piece.arrays)
          if (one.section == "PointData") out.of_points.push_back({std::string(one.name), one.components});
      }
      for (TupleArray& one : out.of_points) {
        const FoundArray* found = find(piece, "PointData", one.name);
        if (found == nullptr || found->components != one.components)
          tags_.fail(piece.line,
                     "the piece lacks the point array " + shown(one.name) + " that the pieces before it have; merge the pieces and export the file again.");
        const std::vector<double> values = arrays.reals(found->array, one.components * piece.points);
        one.values.insert(one.values.end(), values.begin(), values.end());
      }
      add_points(out.points, arrays, piece);
    }
    return out;
  }

  Elements parse() {
    parse_tags();
    VtkElements out(file_);
    VtpArrays arrays(encoding_, file_, size_);
    for (const Piece& piece : pieces_) {
      out.begin_piece(arrays.reals(array(piece, "Points", ""), 3 * piece.points));
      is_grid_ ? add_grid(out, arrays, piece) : add_polydata(out, arrays, piece);
    }
    return out.take();
  }

 private:
  void parse_tags() {
    for (XmlTag tag = tags_.next();; tag = tags_.next()) {
      if (!has_begun_) begin_file(tag);
      if (tag.kind == XmlTag::Kind::end_of_file) break;
      if (tag.kind == XmlTag::Kind::closing) {
        close(tag);
        continue;
      }
      if (tag.name == "AppendedData") return begin_appended(tag);
      if (tag.name == "Piece") begin_piece(tag);
      VtpArray* array = tag.name == "DataArray" ? begin_array(tag) : nullptr;
      if (tag.kind == XmlTag::Kind::opening) open(tag);
      if (array != nullptr && tag.kind == XmlTag::Kind::opening) take_text(*array);
    }
    if (!open_.empty()) fail_at_end();
  }

  [[noreturn]] void fail_at_end() const {
    tags_.fail(tags_.line_of_text(), "the file ends inside " + shown(open_.back()) + "; it is truncated: export it again.");
  }

  void open(const XmlTag& tag) {
    constexpr std::size_t deepest = 32;  // files have seven
    if (open_.size() == deepest) tags_.fail(tag.line, "elements are nested more deeply than in any VTK file; export the file again.");
    open_.push_back(tag.name);
  }

  void close(const XmlTag& tag) {
    if (open_.empty() || open_.back() != tag.name) {
      tags_.fail(tag.line, shown("/" + std::string(tag.name)) +
                               (open_.empty() ? " closes no open element" : " does not match the open element " + shown(open_.back())) +
                               "; the file is damaged: export it again.");
    }
    open_.pop_back();
  }

  void begin_file(const XmlTag& tag) {
    has_begun_ = true;
    if (tag.name != "VTKFile") tags_.fail(tag.line, "a VTK file in XML begins with `<VTKFile`; the contents do not match the file extension.");
    is_grid_ = tag["type"] == "UnstructuredGrid";
    if (!is_grid_ && tag["type"] != "PolyData") {
      tags_.fail(tag.line, "the file is of type " + shown(tag["type"]) +
                               ", but surfaces are PolyData or UnstructuredGrid; apply the filter Extract Surface in ParaView and save as .vtp.");
    }
    encoding_.order =
        chosen<std::endian>(tag, "byte_order", {{"", std::endian::little}, {"LittleEndian", std::endian::little}, {"BigEndian", std::endian::big}});
    encoding_.header = chosen<NumberType>(tag, "header_type", {{"", NumberType::uint32}, {"UInt32", NumberType::uint32}, {"UInt64", NumberType::uint64}});
    encoding_.is_packed = chosen<bool>(tag, "compressor", {{"", false}, {"vtkZLibDataCompressor", true}});
  }

  /// The meaning of an attribute's value. The first choice is the default.
  template <class Choice>
  Choice chosen(const XmlTag& tag, std::string_view attribute, std::initializer_list<std::pair<std::string_view, Choice>> choices) const {
    for (const auto& [value, choice] : choices)
      if (tag[attribute] == value) return choice;
    std::string sentence = std::string(attribute) + " is " + shown(tag[attribute]) + ", but must be";
    for (const auto& [value, choice] : choices)
      if (!value.empty()) sentence += (value == (choices.begin() + 1)->first ? " `" : " or `") + std::string(value) + "`";
    tags_.fail(tag.line, sentence + "; export the file accordingly.");
  }

  std::size_t count(const XmlTag& tag, std::string_view attribute) const {
    const std::string_view word = tag[attribute];
    std::size_t value = 0;
    if (word.empty()) return value;
    const auto [end, problem] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (problem != std::errc{} || end != word.data() + word.size() || value > size_t{1} << 60)
      tags_.fail(tag.line, std::string(attribute) + " is " + shown(word) + ", where a count is expected; correct the file or export it again.");
    return value;
  }

  void begin_piece(const XmlTag& tag) {
    Piece piece;
    piece.line = tag.line;
    piece.points = count(tag, "NumberOfPoints");
    piece.cells = count(tag, "NumberOfCells");
    piece.vertices = count(tag, "NumberOfVerts");
    piece.lines = count(tag, "NumberOfLines");
    piece.polygons = count(tag, "NumberOfPolys");
    piece.strips = count(tag, "NumberOfStrips");
    pieces_.push_back(std::move(piece));
  }

  void add_points(std::vector<Vec3d>& points, VtpArrays& arrays, const Piece& piece) const {
    const std::vector<double> places = arrays.reals(array(piece, "Points", ""), 3 * piece.points);
    for (std::size_t k = 0; k < places.size(); k += 3) points.push_back({places[k], places[k + 1], places[k + 2]});
  }

  /// The stored array, or nullptr where it is not needed.
  VtpArray* begin_array(const XmlTag& tag) {
    if (!open_.empty() && open_.back() == "FieldData") return begin_field_data(tag);
    if (pieces_.empty() || open_.empty()) return nullptr;
    Piece& piece = pieces_.back();
    const std::string_view section = open_.back();
    if (section == "CellData") return begin_part(tag, piece);
    if (section == "PointData") return begin_wanted(tag, piece);
    const bool is_list = section == "Cells" || section == "Polys" || section == "Strips";
    const std::string_view name = is_list ? tag["Name"] : std::string_view{};
    const bool is_needed = section == "Points" || (is_list && (name == "connectivity" || name == "offsets" || (name == "types" && is_grid_)));
    if (!is_needed || find(piece, section, name) != nullptr) return nullptr;
    if (section == "Points" && count(tag, "NumberOfComponents") != 3)
      tags_.fail(tag.line, "the points have " + shown(tag["NumberOfComponents"]) + " components, but need 3; export the file again.");
    piece.arrays.push_back({section, name, described(tag, name.empty() ? std::string(section) : std::string(section) + "/" + std::string(name))});
    return &piece.arrays.back().array;
  }

  std::size_t components(const XmlTag& tag) const { return std::max<std::size_t>(1, count(tag, "NumberOfComponents")); }

  VtpArray* begin_wanted(const XmlTag& tag, Piece& piece) {
    const std::string_view name = tag["Name"];
    if (components(tag) == 1) piece.point_arrays += ", " + shown(name);
    if (!is_wanted_ || !is_wanted_(name, components(tag)) || find(piece, "PointData", name) != nullptr) return nullptr;
    piece.arrays.push_back({"PointData", name, described(tag, "PointData/" + std::string(name)), components(tag)});
    return &piece.arrays.back().array;
  }

  VtpArray* begin_field_data(const XmlTag& tag) {
    const std::string_view name = tag["Name"];
    if (!is_wanted_ || !is_wanted_(name, components(tag))) return nullptr;
    field_data_.push_back({"FieldData", name, described(tag, "FieldData/" + std::string(name)), components(tag), count(tag, "NumberOfTuples")});
    return &field_data_.back().array;
  }

  /// Uses the array as part numbers where it ranks higher than the one found so far.
  VtpArray* begin_part(const XmlTag& tag, Piece& piece) {
    const int rank = vtk_part_rank(tag["Name"]);
    const auto type = type_of(tag);
    if (rank < 0 || (piece.part_rank >= 0 && piece.part_rank <= rank) || type == std::end(types) || !is_whole(type->second)) return nullptr;
    if (count(tag, "NumberOfComponents") > 1) return nullptr;
    piece.part_rank = rank;
    piece.part = described(tag, "CellData/" + std::string(tag["Name"]));
    return &piece.part;
  }

  static const std::pair<std::string_view, NumberType>* type_of(const XmlTag& tag) {
    return std::find_if(std::begin(types), std::end(types), [&](const auto& type) { return type.first == tag["type"]; });
  }

  VtpArray described(const XmlTag& tag, std::string name) const {
    using Format = VtpArray::Format;
    VtpArray array{std::move(name)};
    array.line = tag.line;
    const auto type = type_of(tag);
    if (type == std::end(types))
      tags_.fail(tag.line, array.name + " has numbers of type " + shown(tag["type"]) + ", which is not supported; export the file again.");
    array.type = type->second;
    array.format = chosen<Format>(tag, "format", {{"", Format::ascii}, {"ascii", Format::ascii}, {"binary", Format::binary}, {"appended", Format::appended}});
    array.offset = count(tag, "offset");
    return array;
  }

  /// Moves to the end of the array; its numbers are the text before any nested element.
  void take_text(VtpArray& array) {
    const std::size_t depth = open_.size();
    while (open_.size() >= depth) {
      const XmlTag tag = tags_.next();
      const bool is_blank = tags_.text().find_first_not_of(" \t\r\n") == std::string_view::npos;
      if (open_.size() == depth && array.text.empty() && !is_blank) array.text = tags_.text(), array.line = tags_.line_of_text();
      if (tag.kind == XmlTag::Kind::end_of_file) fail_at_end();
      if (tag.kind == XmlTag::Kind::closing) close(tag);
      if (tag.kind == XmlTag::Kind::opening) open(tag);
    }
  }

  void begin_appended(const XmlTag& tag) {
    encoding_.appended = chosen<Encoding>(tag, "encoding", {{"", Encoding::raw}, {"raw", Encoding::raw}, {"base64", Encoding::base64}});
    std::string_view text = tags_.rest();
    const std::size_t mark = text.find_first_not_of(" \t\r\n");
    if (mark == std::string_view::npos || text[mark] != '_')
      tags_.fail(tag.line, "the appended data do not begin with `_`; the file is damaged: export it again.");
    text.remove_prefix(mark + 1);
    encoding_.appended_text = encoding_.appended == Encoding::raw ? text : text.substr(0, text.find('<'));
  }

  static const FoundArray* find(const Piece& piece, std::string_view section, std::string_view name) {
    const auto found =
        std::find_if(piece.arrays.begin(), piece.arrays.end(), [&](const FoundArray& one) { return one.section == section && one.name == name; });
    return found == piece.arrays.end() ? nullptr : &*found;
  }

  const VtpArray& array(const Piece& piece, std::string_view section, std::string_view name) const {
    static const VtpArray none;
    if (section == "Points" && piece.points == 0) return none;
    if (const FoundArray* found = find(piece, section, name)) return found->array;
    tags_.fail(piece.line, "the piece has no array" + (name.empty() ? "" : " " + shown(name)) + " in " + shown(section) + "; export the file again.");
  }

  VtkCells cells(VtpArrays& arrays, const Piece& piece, std::string_view section, std::size_t count) const {
    if (count == 0) return {};
    VtkCells out;
    const VtpArray& offsets = array(piece, section, "offsets");
    out.ends = arrays.wholes(offsets, count);
    if (out.ends.back() < 0) tags_.fail(offsets.line, offsets.name + " ends with a negative number; correct the file or export it again.");
    out.points = arrays.wholes(array(piece, section, "connectivity"), static_cast<std::size_t>(out.ends.back()));
    return out;
  }

  static std::vector<std::int64_t> parts(VtpArrays& arrays, const Piece& piece, std::size_t cells) {
    return piece.part_rank < 0 ? std::vector<std::int64_t>{} : arrays.wholes(piece.part, cells);
  }

  void add_grid(VtkElements& out, VtpArrays& arrays, const Piece& piece) const {
    if (piece.cells == 0) return;
    const VtkCells all = cells(arrays, piece, "Cells", piece.cells);
    out.add(all, arrays.wholes(array(piece, "Cells", "types"), piece.cells), parts(arrays, piece, piece.cells));
  }

  /// Cell data are ordered by vertices, lines, polygons and strips.
  void add_polydata(VtkElements& out, VtpArrays& arrays, const Piece& piece) const {
    const std::size_t before = piece.vertices + piece.lines;
    const std::vector<std::int64_t> part = parts(arrays, piece, before + piece.polygons + piece.strips);
    const auto part_of = [&](std::size_t first, std::size_t count) {
      return part.empty() ? std::span<const std::int64_t>{} : std::span(part).subspan(first, count);
    };
    out.add(cells(arrays, piece, "Polys", piece.polygons), std::span(&vtk_polygon, 1), part_of(before, piece.polygons));
    out.add(cells(arrays, piece, "Strips", piece.strips), std::span(&vtk_triangle_strip, 1), part_of(before + piece.polygons, piece.strips));
  }

  const std::string& file_;
  std::size_t size_;
  XmlTags tags_;
  bool has_begun_ = false;
  bool is_grid_ = false;
  VtpEncoding encoding_;
  std::vector<std::string_view> open_;  // open elements, outermost first
  std::vector<Piece> pieces_;
  std::vector<FoundArray> field_data_;
  ArrayFilter is_wanted_;
};

}  // namespace

Elements parse_vtp(std::string_view contents, const std::string& file) { return VtkXml(contents, file).parse(); }

PointValues parse_vtp_points(std::string_view contents, const std::string& file, std::string_view array) {
  return VtkXml(contents, file, [array](std::string_view name, std::size_t components) { return components == 1 && name == array; }).points(array);
}

PointData parse_vtp_arrays(std::string_view contents, const std::string& file, const ArrayFilter& is_wanted) {
  return VtkXml(contents, file, is_wanted).point_arrays();
}

}  // namespace fccda
