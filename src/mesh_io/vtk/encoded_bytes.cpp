#include "mesh_io/vtk/encoded_bytes.hpp"

#include <algorithm>
#include <array>

namespace fccda {
namespace {

constexpr std::uint8_t padding = 64, blank = 65, other = 66;

constexpr std::array<std::uint8_t, 256> values = [] {
  std::array<std::uint8_t, 256> table{};
  table.fill(other);
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  for (std::size_t k = 0; k < digits.size(); ++k) table[static_cast<unsigned char>(digits[k])] = static_cast<std::uint8_t>(k);
  table['='] = padding;
  for (const char c : {' ', '\t', '\r', '\n'}) table[static_cast<unsigned char>(c)] = blank;
  return table;
}();

}  // namespace

/// Decodes four digits to three bytes; each of up to two trailing padding characters means one byte less.
bool EncodedBytes::decode_four() {
  std::uint32_t bits = 0;
  std::size_t digits = 0, paddings = 0;
  std::size_t at = 0;
  for (; digits + paddings < 4 && at < text_.size(); ++at) {
    const std::uint8_t value = values[static_cast<unsigned char>(text_[at])];
    if (value == blank) continue;
    if (value == other || (value != padding && paddings > 0)) return false;
    value == padding ? ++paddings : ++digits;
    bits = bits << 6 | (value == padding ? 0u : value);
  }
  text_.remove_prefix(at);
  if (digits + paddings < 4 || paddings > 2) return false;
  for (std::size_t k = 0; k + paddings < 3; ++k) decoded_.push_back(static_cast<char>(bits >> (16 - 8 * k) & 0xff));
  return true;
}

std::optional<std::string> EncodedBytes::next(std::size_t count) {
  if (encoding_ == Encoding::raw) {
    if (count > text_.size()) return std::nullopt;
    std::string out(text_.substr(0, count));
    text_.remove_prefix(count);
    return out;
  }
  if (count > decoded_.size() + text_.size()) return std::nullopt;
  std::string out;
  out.reserve(count);
  while (out.size() < count) {
    if (decoded_.empty() && !decode_four()) return std::nullopt;
    const std::size_t taken = std::min(decoded_.size(), count - out.size());
    out.append(decoded_, 0, taken);
    decoded_.erase(0, taken);
  }
  return out;
}

}  // namespace fccda
