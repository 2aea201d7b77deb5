/// Raw or base64-encoded bytes (RFC 4648, section 4).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace fccda {

enum class Encoding : std::uint8_t { raw, base64 };

/// Decodes `text` sequentially. In base64, white space is skipped, and a new run of digits may follow padding.
class EncodedBytes {
 public:
  /// `text` must outlive this object.
  EncodedBytes(std::string_view text, Encoding encoding) : text_(text), encoding_(encoding) {}

  /// The next `count` bytes; nothing where the text ends earlier or has invalid base64 characters, in which case no memory is allocated.
  std::optional<std::string> next(std::size_t count);

 private:
  bool decode_four();

  std::string_view text_;
  Encoding encoding_;
  std::string decoded_;  // decoded bytes not yet returned, at most two
};

}  // namespace fccda
