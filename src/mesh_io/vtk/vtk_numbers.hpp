/// Words and numbers of VTK legacy files: plain text, or text with blocks of big-endian binary numbers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mesh_io/file/number_type.hpp"
#include "mesh_io/file/words.hpp"

namespace fccda {

/// The number type that a word such as `unsigned_char` denotes; nothing for others, such as `bit` and `string`.
std::optional<NumberType> vtk_number_type(std::string_view word);

class VtkNumbers {
 public:
  /// `words` must be positioned at the word ASCII or BINARY; both arguments must outlive this object.
  VtkNumbers(Words& words, const std::string& file);

  /// A word of the header line of a section.
  std::string_view word() { return words_.next_in_line(); }
  std::size_t count(std::string_view what);  ///< the next word as a count
  NumberType type(std::string_view what);    ///< the next word as a number type

  /// The numbers after the header line. Throws InputError where the file has fewer.
  std::vector<double> reals(std::size_t count, NumberType type, std::string_view what);
  std::vector<std::int64_t> wholes(std::size_t count, NumberType type, std::string_view what);

  /// Skips `tuples` times `components` values of the named type, numeric or not.
  void skip(std::size_t tuples, std::size_t components, std::string_view type, std::string_view what);

  /// Throws InputError, with the line for a text file.
  [[noreturn]] void fail(const std::string& sentence) const;

 private:
  [[noreturn]] void fail_at_end(std::string_view what) const;
  void check_room(std::size_t bytes_each, std::size_t count, std::string_view what) const;
  template <class Number>
  std::vector<Number> numbers(std::size_t count, NumberType type, std::string_view what);
  void skip_strings(std::size_t count, std::string_view what);
  std::size_t length_of_string(std::string_view what);

  Words& words_;
  const std::string& file_;
  bool is_binary_;
};

}  // namespace fccda
