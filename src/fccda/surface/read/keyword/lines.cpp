#include "fccda/surface/read/keyword/lines.hpp"

#include <algorithm>
#include <utility>

#include "fccda/core/error.hpp"

namespace fccda {
namespace {
constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";  // some editors put it before UTF-8
}  // namespace

Lines::Lines(std::string_view text, std::string file) : text_(text), file_(std::move(file)) {
  if (text_.starts_with(byte_order_mark)) at_ = byte_order_mark.size();
}

bool Lines::next() {
  if (at_ >= text_.size()) return false;
  const std::size_t end = std::min(text_.find_first_of("\r\n", at_), text_.size());
  line_ = text_.substr(at_, end - at_);
  at_ = end + (text_.substr(end).starts_with("\r\n") ? 2 : 1);
  ++number_;
  return true;
}

void Lines::fail_at(std::size_t number, const std::string& sentence) const { throw InputError(file_ + ":" + std::to_string(number) + ": " + sentence); }

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t";
  const std::size_t begin = text.find_first_not_of(blanks);
  return begin == std::string_view::npos ? std::string_view{} : text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

std::string capitals(std::string_view text) {
  std::string out(text);
  for (char& c : out) c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  return out;
}

std::string printable(std::string_view text) {
  std::string out(text);
  std::replace_if(
      out.begin(), out.end(), [](char c) { return (c >= '\0' && c < ' ') || c == '\x7f'; }, '?');
  return out;
}

}  // namespace fccda
