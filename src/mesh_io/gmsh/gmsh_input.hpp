/// Reads the values of a Gmsh file from text or binary alike, and reports errors with their location.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "mesh_io/file/words.hpp"

namespace fccda {

/// Versions of the format with different layouts. Versions 2.0, 2.1 and 2.2 are v2.
enum class GmshVersion : std::uint8_t { v2, v4_0, v4_1 };

class GmshInput {
 public:
  /// Reads `$MeshFormat`: version, text or binary, and byte order. `contents` must outlive this object.
  /// Throws InputError where the section is missing or the format is not supported.
  GmshInput(std::string_view contents, const std::string& file);

  GmshVersion version() const { return version_; }
  bool is_binary() const { return is_binary_; }

  /// Sets the context of the next values for messages: `thing`, or item `number` of `of`, counted from 1.
  void begin(std::string_view thing, std::int64_t number = 0, std::int64_t of = 0) { place_ = {thing, number, of}; }
  std::string place() const;  ///< "node 3 of 8"

  std::int32_t integer();                                ///< 4 bytes in binary
  std::int32_t integer_of(std::string_view word) const;  ///< from a line that is text in binary files too
  std::int64_t long_integer();                           ///< 8 bytes in binary, unsigned
  double number();                                       ///< must be finite
  void skip_number();                                    ///< finite or not
  std::int64_t count();                                  ///< non-negative long_integer()

  /// The next non-blank line, trimmed; empty at the end of the file. Lines are text in binary files too.
  std::string line();
  /// A line with one non-negative integer; `of` names the counted items in messages.
  std::int64_t count_in_line(std::string_view of);

  /// The next line must be `$End<section>`.
  void end_section(std::string_view section);
  /// Skips to after `$End<section>`.
  void skip_section(std::string_view section);

  /// Throws InputError: "file:line: sentence", or "file: sentence" in binary.
  [[noreturn]] void fail(const std::string& sentence) const;

 private:
  struct Place {
    std::string_view thing;
    std::int64_t number, of;
  };

  void begin_binary(std::string_view rest);
  template <class T>
  T value();
  std::string_view word();
  std::int64_t long_integer_of(std::string_view word) const;
  [[noreturn]] void fail_at_end() const;
  [[noreturn]] void fail_out_of_range(std::string_view number) const;

  std::string file_;
  Words words_;            // of a text file
  std::string_view rest_;  // of a binary file: unread bytes
  bool is_binary_ = false;
  std::endian byte_order_ = std::endian::little;  // of a binary file
  GmshVersion version_ = GmshVersion::v4_1;
  Place place_{"the header", 0, 0};
};

}  // namespace fccda
