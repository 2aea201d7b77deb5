/// Data arrays of VTK XML files: ascii, inline base64 or appended at the end of the file; plain or in zlib-compressed blocks.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "mesh_io/file/number_type.hpp"
#include "mesh_io/vtk/encoded_bytes.hpp"

namespace fccda {

/// A DataArray as described by its tag.
struct VtpArray {
  std::string name;  ///< for messages
  NumberType type = NumberType::float64;
  enum class Format : std::uint8_t { ascii, binary, appended } format = Format::ascii;
  std::size_t offset = 0;  ///< for appended arrays, from the start of the appended bytes
  std::string_view text;   ///< for the others
  std::size_t line = 0;    ///< line of the text, or of the tag of an appended array
};

/// Encoding of binary numbers throughout the file.
struct VtpEncoding {
  std::endian order = std::endian::little;
  NumberType header = NumberType::uint32;  ///< type of the byte counts before each array
  bool is_packed = false;                  ///< compressed by vtkZLibDataCompressor
  Encoding appended = Encoding::raw;
  std::string_view appended_text;
};

class VtpArrays {
 public:
  /// `file_size` [bytes] bounds the decompressed size: 256 times as much plus 1 MiB.
  VtpArrays(const VtpEncoding& encoding, std::string file, std::size_t file_size)
      : encoding_(encoding), file_(std::move(file)), bytes_left_((std::size_t{1} << 20) + 256 * file_size) {}

  /// The `count` numbers of an array. Throws InputError with the line and the array's name where the number differs, values are not finite (or not
  /// integers), the data are damaged, or the decompressed size exceeds the bound.
  std::vector<double> reals(const VtpArray& array, std::size_t count);
  std::vector<std::int64_t> wholes(const VtpArray& array, std::size_t count);

 private:
  [[noreturn]] void fail(const VtpArray& array, const std::string& sentence) const;
  [[noreturn]] void fail_at_end(const VtpArray& array) const;
  template <class Number>
  std::vector<Number> numbers(const VtpArray& array, std::size_t count);
  template <class Number>
  std::vector<Number> numbers_of_text(const VtpArray& array, std::size_t count) const;
  std::string bytes(const VtpArray& array, std::size_t size) const;
  std::string unpacked(const VtpArray& array, EncodedBytes& source, std::size_t size) const;
  std::size_t header_number(const VtpArray& array, EncodedBytes& source) const;

  VtpEncoding encoding_;
  std::string file_;
  std::size_t bytes_left_;  // remaining decompression budget: many arrays may refer to the same bytes
};

}  // namespace fccda
