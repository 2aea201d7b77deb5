/// Bytes that a file holds as they are, or as base64 (RFC 4648, section 4).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace fccda {

enum class Encoding : std::uint8_t { raw, base64 };

/// Gives bytes from the start of `text` on. In base64, white space is passed over, and behind padding a new run of digits may begin.
class EncodedBytes {
 public:
  /// `text` must outlive this.
  EncodedBytes(std::string_view text, Encoding encoding) : text_(text), encoding_(encoding) {}

  /// The next `count` bytes; nothing where the text ends before, or has characters that are no base64. Takes no memory in that case.
  std::optional<std::string> next(std::size_t count);

 private:
  bool decode_four();

  std::string_view text_;
  Encoding encoding_;
  std::string decoded_;  // bytes that are decoded and not given yet, at most two
};

}  // namespace fccda
