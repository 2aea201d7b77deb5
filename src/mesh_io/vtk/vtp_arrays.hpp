/// Numbers of VTK's XML files: as text, as base64 in their place, or appended at the end of the file; plain or in blocks packed by zlib.
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

/// A DataArray as its tag says it.
struct VtpArray {
  std::string name;  ///< as messages call it
  NumberType type = NumberType::float64;
  enum class Format : std::uint8_t { ascii, binary, appended } format = Format::ascii;
  std::size_t offset = 0;  ///< of appended ones, from the start of the appended bytes
  std::string_view text;   ///< of the others
  std::size_t line = 0;    ///< where the text, or the tag of an appended one, begins
};

/// How binary numbers are written in the whole file.
struct VtpEncoding {
  std::endian order = std::endian::little;
  NumberType header = NumberType::uint32;  ///< type of the counts of bytes before each array
  bool is_packed = false;                  ///< by vtkZLibDataCompressor
  Encoding appended = Encoding::raw;
  std::string_view appended_text;
};

class VtpArrays {
 public:
  /// `file_size` [bytes] bounds what may be unpacked: 256 times as much and 1 MiB.
  VtpArrays(const VtpEncoding& encoding, std::string file, std::size_t file_size)
      : encoding_(encoding), file_(std::move(file)), bytes_left_((std::size_t{1} << 20) + 256 * file_size) {}

  /// All numbers of an array, which are `count`. Throws InputError with the line and the array's name where they are not as many, no finite
  /// numbers (or no whole ones), damaged, or too much to unpack.
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
  std::size_t bytes_left_;  // to be unpacked from here on: the same bytes may be named by many arrays
};

}  // namespace fccda
