#include "mesh_io/vtk/vtk_numbers.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.hpp"
#include "mesh_io/file/whole_number.hpp"

namespace fccda {
namespace {

/// `long` has 64 bits, as on all platforms except Windows; vtkIdType is written as int.
constexpr std::pair<std::string_view, NumberType> types[] = {{"char", NumberType::int8},
                                                             {"signed_char", NumberType::int8},
                                                             {"unsigned_char", NumberType::uint8},
                                                             {"short", NumberType::int16},
                                                             {"unsigned_short", NumberType::uint16},
                                                             {"int", NumberType::int32},
                                                             {"unsigned_int", NumberType::uint32},
                                                             {"vtkidtype", NumberType::int32},
                                                             {"long", NumberType::int64},
                                                             {"unsigned_long", NumberType::uint64},
                                                             {"vtktypeint64", NumberType::int64},
                                                             {"vtktypeuint64", NumberType::uint64},
                                                             {"float", NumberType::float32},
                                                             {"double", NumberType::float64}};

bool is_binary_word(Words& words) {
  const std::string_view word = words.next();
  words.skip_line();
  if (is_word(word, "binary")) return true;
  if (!is_word(word, "ascii")) words.fail("the third line has " + shown(word) + ", but must be ASCII or BINARY; export the file again.");
  return false;
}

}  // namespace

std::optional<NumberType> vtk_number_type(std::string_view word) {
  const auto found = std::find_if(std::begin(types), std::end(types), [&](const auto& type) { return is_word(word, type.first); });
  return found == std::end(types) ? std::nullopt : std::optional(found->second);
}

VtkNumbers::VtkNumbers(Words& words, const std::string& file) : words_(words), file_(file), is_binary_(is_binary_word(words)) {}

void VtkNumbers::fail(const std::string& sentence) const {
  if (!is_binary_) words_.fail(sentence);
  throw InputError(file_ + ": " + sentence);
}

void VtkNumbers::fail_at_end(std::string_view what) const { fail("the file ends in " + std::string(what) + "; it is truncated: export it again."); }

std::size_t VtkNumbers::count(std::string_view what) {
  const std::string_view word = words_.next_in_line();
  if (word.empty() && words_.remaining() == 0) fail_at_end(what);
  return count_number(words_, word, what);
}

NumberType VtkNumbers::type(std::string_view what) {
  const std::string_view word = words_.next_in_line();
  if (word.empty() && words_.remaining() == 0) fail_at_end(what);
  if (const auto type = vtk_number_type(word)) return *type;
  fail(std::string(what) + " has numbers of type " + shown(word) + ", which is not supported; export it as int, vtktypeint64, float or double.");
}

void VtkNumbers::check_room(std::size_t bytes_each, std::size_t count, std::string_view what) const {
  const std::size_t each = is_binary_ ? bytes_each : 2;  // a digit and a space, except after the last
  if (count <= (words_.remaining() + (is_binary_ ? 0 : 1)) / each) return;
  fail(std::string(what) + " needs " + std::to_string(count) + " numbers, more than the " + std::to_string(words_.remaining()) +
       " bytes after it can hold; the file is truncated or the count is damaged: export it again.");
}

template <class Number>
std::vector<Number> VtkNumbers::numbers(std::size_t count, NumberType type, std::string_view what) {
  if (is_binary_) {
    words_.skip_line();
    check_room(size_of(type), count, what);
    return numbers_in<Number>(words_.bytes(count * size_of(type)), type, std::endian::big);
  }
  check_room(size_of(type), count, what);
  std::vector<Number> out(count);
  for (Number& number : out) {
    const std::string_view word = words_.next();
    if (word.empty()) fail_at_end(what);
    if constexpr (std::is_same_v<Number, double>) {
      number = words_.number(word, what);
    } else {
      number = whole_number(words_, word, what);
    }
  }
  return out;
}

std::vector<double> VtkNumbers::reals(std::size_t count, NumberType type, std::string_view what) {
  std::vector<double> out = numbers<double>(count, type, what);
  if (!std::all_of(out.begin(), out.end(), [](double number) { return std::isfinite(number); }))
    fail(std::string(what) + " has a number that is not finite; repair the mesh and export it again.");
  return out;
}

std::vector<std::int64_t> VtkNumbers::wholes(std::size_t count, NumberType type, std::string_view what) {
  if (!is_whole(type)) fail(std::string(what) + " has numbers of type float or double, where integers are expected; export the file again.");
  return numbers<std::int64_t>(count, type, what);
}

void VtkNumbers::skip(std::size_t tuples, std::size_t components, std::string_view type, std::string_view what) {
  const bool is_bit = is_word(type, "bit"), is_string = is_word(type, "string") || is_word(type, "utf8_string");
  const std::optional<NumberType> known = vtk_number_type(type);
  if (!known && !is_bit && !is_string)
    fail(std::string(what) + " has values of type " + shown(type) + ", which cannot be skipped; export the file without them.");
  if (is_binary_ || is_string) words_.skip_line();
  const std::size_t most = 8 * (words_.remaining() + 1);  // at least one bit each
  if (components > 0 && tuples > most / components) fail_at_end(what);
  const std::size_t count = tuples * components;
  if (is_string) return skip_strings(count, what);
  if (is_binary_) {
    const std::size_t bytes = is_bit ? (count + 7) / 8 : count * size_of(*known);
    if (words_.bytes(bytes).size() < bytes) fail_at_end(what);
    return;
  }
  for (std::size_t k = 0; k < count; ++k)
    if (words_.next().empty()) fail_at_end(what);
}

/// Strings: one per line in text, or length and bytes in a binary file.
void VtkNumbers::skip_strings(std::size_t count, std::string_view what) {
  for (std::size_t k = 0; k < count; ++k) {
    if (words_.remaining() == 0) fail_at_end(what);
    if (!is_binary_) {
      words_.skip_line();
      continue;
    }
    const std::size_t length = length_of_string(what);
    if (words_.bytes(length).size() < length) fail_at_end(what);
  }
}

/// The two highest bits give the size of the length field: 3 one byte, 2 two, 1 four, 0 eight.
std::size_t VtkNumbers::length_of_string(std::string_view what) {
  const auto byte = [&] {
    const std::string_view next = words_.bytes(1);
    if (next.empty()) fail_at_end(what);
    return std::size_t{static_cast<unsigned char>(next.front())};
  };
  const std::size_t first = byte();
  std::size_t length = first & 0x3f;
  for (std::size_t bytes = std::size_t{8} >> (first >> 6); bytes > 1; --bytes) length = length << 8 | byte();
  return length;
}

}  // namespace fccda
