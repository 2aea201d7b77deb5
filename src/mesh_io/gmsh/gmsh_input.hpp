/// The values of a Gmsh file, read the same from text and from binary, and the errors that say where they stand.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "mesh_io/file/words.hpp"

namespace fccda {

/// Versions of the format that differ in their layout. All of 2.0, 2.1 and 2.2 are v2.
enum class GmshVersion : std::uint8_t { v2, v4_0, v4_1 };

class GmshInput {
 public:
  /// Reads `$MeshFormat`, which says the version, whether text or binary follows, and in which byte order. `contents` must outlive this.
  /// Throws InputError where it is missing or names what cannot be read.
  GmshInput(std::string_view contents, const std::string& file);

  GmshVersion version() const { return version_; }
  bool is_binary() const { return is_binary_; }

  /// What the next values belong to, for messages: the thing itself, or number `number` of `of` such things, counted from 1.
  void begin(std::string_view thing, std::int64_t number = 0, std::int64_t of = 0) { place_ = {thing, number, of}; }
  std::string place() const;  ///< "node 3 of 8"

  std::int32_t integer();                                ///< of 4 bytes in binary
  std::int32_t integer_of(std::string_view word) const;  ///< of a line that is text in binary files too
  std::int64_t long_integer();                           ///< of 8 bytes in binary, without a sign
  double number();                                       ///< finite
  void skip_number();                                    ///< any, finite or not
  std::int64_t count();                                  ///< long_integer() that is not negative

  /// The next line that holds more than white space, without white space at its ends; empty at the end of the file. Lines are text in binary
  /// files too.
  std::string line();
  /// A line that holds one whole number, not negative; `of` says of what, for messages.
  std::int64_t count_in_line(std::string_view of);

  /// The next line must be `$End<section>`.
  void end_section(std::string_view section);
  /// Goes behind `$End<section>`.
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
  Words words_;            // of the text
  std::string_view rest_;  // of the binary file: what is not yet read
  bool is_binary_ = false;
  std::endian byte_order_ = std::endian::little;  // where binary
  GmshVersion version_ = GmshVersion::v4_1;
  Place place_{"the header", 0, 0};
};

}  // namespace fccda
