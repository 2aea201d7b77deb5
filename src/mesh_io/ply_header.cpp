#include "mesh_io/ply_header.hpp"

#include <algorithm>
#include <utility>

#include "mesh_io/file/whole_number.hpp"

namespace fccda {
namespace {

constexpr std::pair<std::string_view, NumberType> types[] = {
    {"char", NumberType::int8},     {"int8", NumberType::int8},       {"uchar", NumberType::uint8},    {"uint8", NumberType::uint8},
    {"short", NumberType::int16},   {"int16", NumberType::int16},     {"ushort", NumberType::uint16},  {"uint16", NumberType::uint16},
    {"int", NumberType::int32},     {"int32", NumberType::int32},     {"uint", NumberType::uint32},    {"uint32", NumberType::uint32},
    {"float", NumberType::float32}, {"float32", NumberType::float32}, {"double", NumberType::float64}, {"float64", NumberType::float64}};

NumberType type_of(const Words& words, std::string_view word) {
  const auto found = std::find_if(std::begin(types), std::end(types), [&](const auto& type) { return type.first == word; });
  if (found == std::end(types)) words.fail("the property has the type " + shown(word) + ", but PLY has char, short, int, their unsigned u…, float and double.");
  return found->second;
}

std::optional<std::endian> parse_format(Words& words) {
  if (!is_word(words.next(), "format")) words.fail("the format, such as `format ascii 1.0`, must be in the second line of a PLY file; export it again.");
  const std::string_view format = words.next_in_line();
  if (format == "ascii") return std::nullopt;
  if (format == "binary_little_endian") return std::endian::little;
  if (format == "binary_big_endian") return std::endian::big;
  words.fail("the format is " + shown(format) + ", but must be ascii, binary_little_endian or binary_big_endian; export the file again.");
}

PlyElement parse_element(Words& words, const PlyHeader& header) {
  PlyElement element;
  element.name = words.next_in_line();
  const bool is_ours = element.name == "vertex" || element.name == "face";
  if (is_ours && header.element(element.name)) words.fail("the header has " + shown(element.name) + " twice; export the file again.");
  element.count = count_number(words, words.next_in_line(), "the element " + shown(element.name));
  return element;
}

PlyProperty parse_property(Words& words) {
  PlyProperty property{};
  std::string_view type = words.next_in_line();
  if (type == "list") {
    property.count = type_of(words, words.next_in_line());
    if (!is_whole(*property.count)) words.fail("the count of a list must be of an integer type; export the file again.");
    type = words.next_in_line();
  }
  property.type = type_of(words, type);
  property.name = words.next_in_line();
  return property;
}

}  // namespace

std::size_t PlyElement::least_bytes(bool is_text) const {
  std::size_t bytes = 0;
  constexpr std::size_t digit_and_space = 2;
  for (const PlyProperty& property : properties) bytes += is_text ? digit_and_space : size_of(property.count.value_or(property.type));
  return bytes;
}

const PlyElement* PlyHeader::element(std::string_view name) const {
  const auto found = std::find_if(elements.begin(), elements.end(), [&](const PlyElement& one) { return one.name == name; });
  return found == elements.end() ? nullptr : &*found;
}

PlyHeader parse_ply_header(Words& words) {
  if (words.next() != "ply") words.fail("a PLY file begins with `ply`; the contents do not match the file extension.");
  words.skip_line();
  PlyHeader header{parse_format(words), {}};
  for (words.skip_line();; words.skip_line()) {
    const std::string_view statement = words.next();
    if (statement == "element") {
      header.elements.push_back(parse_element(words, header));
    } else if (statement == "property") {
      if (header.elements.empty()) words.fail("the property comes before the first element; export the file again.");
      header.elements.back().properties.push_back(parse_property(words));
    } else if (statement == "end_header") {
      words.skip_line();
      return header;
    } else if (statement.empty()) {
      words.fail("the file ends in its header, before `end_header`; it is truncated: export it again.");
    } else if (statement != "comment" && statement != "obj_info") {
      words.fail(shown(statement) + " is not a PLY header statement; these are element, property, comment, obj_info and end_header.");
    }
  }
}

}  // namespace fccda
