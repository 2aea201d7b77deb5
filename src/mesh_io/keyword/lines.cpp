#include "mesh_io/keyword/lines.hpp"

#include <algorithm>
#include <utility>

#include "base/error.hpp"
#include "mesh_io/file/text.hpp"

namespace fccda {

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

std::string capitals(std::string_view text) {
  std::string out(text);
  for (char& c : out) c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  return out;
}

}  // namespace fccda
