#include "mesh_io/gmsh/gmsh_input.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "base/error.hpp"
#include "mesh_io/file/number_type.hpp"
#include "mesh_io/file/text.hpp"

namespace fccda {
namespace {

constexpr std::string_view cut_short = "it is truncated: export it again.";
constexpr std::string_view damaged = "the count or the file is damaged: export it again.";

}  // namespace

GmshInput::GmshInput(std::string_view contents, const std::string& file) : file_(file), words_(contents, file) {
  const std::string_view header = words_.next();
  if (header == "$NOD") fail("version 1 of the Gmsh format is not supported; open the mesh in Gmsh and export it as version 4 or 2.");
  if (header != "$MeshFormat") fail(shown(header) + " appears where `$MeshFormat` is expected, so this is not a Gmsh mesh; export it as one.");

  const std::string_view version = words_.next();
  const std::optional<double> number = parsed<double>(version);
  if (number >= 2 && number < 3) {
    version_ = GmshVersion::v2;
  } else if (number == 4.0 || number == 4.1) {
    version_ = number == 4.0 ? GmshVersion::v4_0 : GmshVersion::v4_1;
  } else {
    fail(shown(version) + " is not a supported version of the Gmsh format; open the mesh in Gmsh and export it as version 2, 4.0 or 4.1.");
  }

  const std::string_view type = words_.next(), size = words_.next();
  if (type != "0" && type != "1")
    fail(shown(type) + " appears where 0 (text) or 1 (binary) is expected after the version; correct the file or export it again.");
  if (size != "8") fail("the file has numbers of " + shown(size) + " bytes, but 8 are required; export it on a 64-bit machine.");
  is_binary_ = type == "1";
  if (is_binary_) begin_binary(contents.substr(static_cast<std::size_t>(size.data() + size.size() - contents.data())));
  end_section("MeshFormat");
}

void GmshInput::begin_binary(std::string_view rest) {
  rest_ = rest.substr(std::min(rest.find('\n'), rest.size() - 1) + 1);
  if (rest_.size() >= sizeof(std::int32_t) && number_at<std::int32_t>(rest_.data(), byte_order_) != 1) byte_order_ = std::endian::big;
  if (value<std::int32_t>() != 1) {
    fail(
        "the header declares binary data, but the integer 1 that marks the byte order does not follow; the file is text or was transferred as text: export it "
        "again.");
  }
}

void GmshInput::fail(const std::string& sentence) const {
  if (is_binary_) throw InputError(file_ + ": " + sentence);
  words_.fail(sentence);
}

std::string GmshInput::place() const {
  const std::string thing(place_.thing);
  return place_.of == 0 ? thing : thing + " " + std::to_string(place_.number) + " of " + std::to_string(place_.of);
}

void GmshInput::fail_at_end() const { fail("the file ends in " + place() + "; " + std::string(cut_short)); }

template <class T>
T GmshInput::value() {
  if (rest_.size() < sizeof(T)) fail_at_end();
  const T out = number_at<T>(rest_.data(), byte_order_);
  rest_.remove_prefix(sizeof out);
  return out;
}

std::string_view GmshInput::word() {
  const std::string_view word = words_.next();
  if (word.empty()) fail_at_end();
  if (word.front() == '$') fail(shown(word) + " appears in " + place() + "; " + std::string(damaged));
  return word;
}

std::int64_t GmshInput::long_integer_of(std::string_view word) const {
  const std::optional<std::int64_t> integer = parsed<std::int64_t>(word);
  if (!integer) fail(place() + " has " + shown(word) + " where an integer is expected; correct the file or export it again.");
  return *integer;
}

std::int32_t GmshInput::integer_of(std::string_view word) const {
  const std::int64_t integer = long_integer_of(word);
  if (integer < std::numeric_limits<std::int32_t>::min() || integer > std::numeric_limits<std::int32_t>::max()) fail_out_of_range(word);
  return static_cast<std::int32_t>(integer);
}

std::int32_t GmshInput::integer() { return is_binary_ ? value<std::int32_t>() : integer_of(word()); }

std::int64_t GmshInput::long_integer() {
  if (!is_binary_) return long_integer_of(word());
  const auto integer = value<std::uint64_t>();
  if (integer > static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max())) fail_out_of_range(std::to_string(integer));
  return static_cast<std::int64_t>(integer);
}

void GmshInput::fail_out_of_range(std::string_view number) const {
  fail(place() + " has the number " + shown(number) + ", which is out of range; renumber the mesh in Gmsh, or export it again if the file is damaged.");
}

std::int64_t GmshInput::count() {
  const std::int64_t count = long_integer();
  if (count < 0) fail(place() + " has `" + std::to_string(count) + "` where a count is expected; " + std::string(damaged));
  return count;
}

double GmshInput::number() {
  if (is_binary_) {
    const auto number = value<double>();
    if (!std::isfinite(number)) fail(place() + " has a coordinate that is not a finite number; repair the mesh and export it again.");
    return number;
  }
  const std::string_view w = word();
  const std::optional<double> number = parsed<double>(w);
  return number && std::isfinite(*number) ? *number : words_.number(w, place());
}

void GmshInput::skip_number() {
  if (is_binary_)
    value<double>();
  else
    word();
}

std::string GmshInput::line() {
  if (!is_binary_) return words_.at_end() ? std::string{} : words_.rest_of_line();
  const std::size_t begin = std::min(rest_.find_first_not_of(" \t\r\n"), rest_.size());
  rest_.remove_prefix(begin);
  const std::string_view line = rest_.substr(0, rest_.find('\n'));
  rest_.remove_prefix(std::min(line.size() + 1, rest_.size()));
  return Words(line, file_).rest_of_line();
}

std::int64_t GmshInput::count_in_line(std::string_view of) {
  const std::string text = line();
  const std::optional<std::int64_t> count = parsed<std::int64_t>(text);
  if (!count || *count < 0) fail(shown(text) + " appears where the number of " + std::string(of) + " is expected; correct the file or export it again.");
  return *count;
}

void GmshInput::end_section(std::string_view section) {
  const std::string end = "$End" + std::string(section), text = line();
  if (text == end) return;
  if (end.starts_with(text)) fail("the file ends before `" + excerpt(end) + "`; " + std::string(cut_short));
  fail(shown(text) + " appears where `" + excerpt(end) + "` is expected; " + std::string(damaged));
}

void GmshInput::skip_section(std::string_view section) {
  const std::string end = "$End" + std::string(section);
  if (is_binary_) {
    const std::size_t found = rest_.find(end);
    if (found != std::string_view::npos) return rest_.remove_prefix(found + end.size());
  } else {
    for (std::string_view word = words_.next(); !word.empty(); word = words_.next())
      if (word == end) return;
  }
  fail("the file ends before `" + excerpt(end) + "`; " + std::string(cut_short));
}

}  // namespace fccda
