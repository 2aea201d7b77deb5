#include "io/frames/read_vtp.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>

#include "base/error.hpp"
#include "mesh_io/file/contents.hpp"
#include "mesh_io/file/words.hpp"
#include "mesh_io/vtk/vtp_arrays.hpp"
#include "mesh_io/vtk/xml.hpp"

namespace perimpact::frames {

namespace {

/// An array as described by its tag, with its section.
struct Tag {
  std::string section, name;
  std::size_t components;
  fccda::VtpArray array;
};

/// Reads the single piece that write_vtp writes, all arrays appended as raw bytes.
class Reader {
 public:
  Reader(std::string_view contents, std::string file) : contents_(contents), tags_(contents, file), file_(std::move(file)) { read_tags(); }

  Frame frame() {
    fccda::VtpArrays arrays(encoding_, file_, contents_.size());
    Frame out;
    const std::vector<double> places = arrays.reals(wanted("Points", "points").array, 3 * points_);
    for (std::size_t k = 0; k < places.size(); k += 3) out.points.push_back({places[k], places[k + 1], places[k + 2]});
    if (polygons_ > 0) out.panels = panels(arrays);
    for (const Tag& tag : found_) {
      const auto add = [&](std::vector<FrameArray>& to, std::size_t count) {
        to.push_back({tag.name, static_cast<int>(tag.components), arrays.reals(tag.array, tag.components * count)});
      };
      if (tag.section == "PointData") add(polygons_ > 0 ? out.vertex_arrays : out.arrays, points_);
      if (tag.section == "CellData" && polygons_ > 0) add(out.arrays, polygons_);
    }
    return out;
  }

 private:
  [[noreturn]] void fail(std::size_t line, const std::string& what) const { tags_.fail(line, what + "; use the file as written by the run."); }

  std::size_t count(const fccda::XmlTag& tag, std::string_view attribute) const {
    const std::string_view word = tag[attribute];
    std::size_t value = 0;
    const auto [end, problem] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (problem != std::errc{} || end != word.data() + word.size() || value > std::size_t{1} << 40)
      fail(tag.line, fmt::format("{} is {}, where a count is expected", attribute, fccda::shown(word)));
    return value;
  }

  void read_tags() {
    std::string section;
    for (fccda::XmlTag tag = tags_.next();; tag = tags_.next()) {
      if (tag.kind == fccda::XmlTag::Kind::end_of_file) fail(tag.line, "the file has no appended data: it is truncated or not a frame of a run");
      if (tag.kind == fccda::XmlTag::Kind::closing) continue;
      if (tag.name == "VTKFile") {
        encoding_.order = tag["byte_order"] == "BigEndian" ? std::endian::big : std::endian::little;
        encoding_.header = fccda::NumberType::uint64;
        encoding_.is_packed = tag["compressor"] == "vtkZLibDataCompressor";
      } else if (tag.name == "Piece") {
        points_ = count(tag, "NumberOfPoints");
        polygons_ = count(tag, "NumberOfPolys");
      } else if (tag.name == "AppendedData") {
        const std::string_view text = tags_.rest();
        const std::size_t mark = std::min(text.find('_'), text.size() - 1);
        encoding_.appended_text = text.substr(mark + 1);
        return;
      } else if (tag.name != "DataArray") {
        section = tag.name;
      } else if (section != "FieldData") {
        add(section, tag);
      }
    }
  }

  void add(const std::string& section, const fccda::XmlTag& tag) {
    using fccda::NumberType;
    constexpr std::pair<std::string_view, NumberType> types[] = {
        {"Float32", NumberType::float32}, {"Float64", NumberType::float64}, {"Int32", NumberType::int32}, {"UInt8", NumberType::uint8}};
    const auto type = std::find_if(std::begin(types), std::end(types), [&](const auto& each) { return each.first == tag["type"]; });
    if (type == std::end(types)) fail(tag.line, fmt::format("number type {} is not one that a run writes", fccda::shown(tag["type"])));
    Tag found{section, std::string(tag["Name"]), count(tag, "NumberOfComponents"), {}};
    if (found.components == 0 || found.components > 9) fail(tag.line, fmt::format("a run writes no arrays of {} components", found.components));
    found.array.name = section + "/" + found.name;
    found.array.type = type->second;
    found.array.format = fccda::VtpArray::Format::appended;
    found.array.offset = count(tag, "offset");
    found.array.line = tag.line;
    found_.push_back(std::move(found));
  }

  const Tag& wanted(std::string_view section, std::string_view name) const {
    for (const Tag& tag : found_)
      if (tag.section == section && tag.name == name) return tag;
    throw fccda::InputError(fmt::format("{}: the frame has no {} in {}; use the file as written by the run.", file_, name, section));
  }

  std::vector<std::array<int, 4>> panels(fccda::VtpArrays& arrays) const {
    const Tag& offsets = wanted("Polys", "offsets");
    const std::vector<std::int64_t> ends = arrays.wholes(offsets.array, polygons_);
    const std::int64_t count = ends.empty() ? 0 : ends.back();
    if (count < 0 || static_cast<std::uint64_t>(count) > 4 * polygons_) fail(offsets.array.line, "a panel must have three or four corners");
    const std::vector<std::int64_t> corners = arrays.wholes(wanted("Polys", "connectivity").array, static_cast<std::size_t>(count));
    return panels_of(corners, ends, points_, file_);
  }

  std::string_view contents_;
  fccda::XmlTags tags_;
  std::string file_;
  fccda::VtpEncoding encoding_;
  std::size_t points_ = 0, polygons_ = 0;
  std::vector<Tag> found_;
};

}  // namespace

Frame read_vtp(const std::filesystem::path& path) {
  const std::string contents = fccda::contents_of(path);
  return Reader(contents, path.string()).frame();
}

}  // namespace perimpact::frames
