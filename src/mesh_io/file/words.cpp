#include "mesh_io/file/words.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/error.hpp"
#include "mesh_io/file/text.hpp"

namespace fccda {
namespace {
bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
bool is_break(char c) { return c == '\n' || c == '\r'; }
char lowered(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }
/// Look-up table by character, since every byte of files with millions of words is tested.
constexpr auto ends_word = [] {
  std::array<bool, 256> ends{};
  for (const char c : {' ', '\t', '\v', '\f', '\n', '\r'}) ends[static_cast<unsigned char>(c)] = true;
  return ends;
}();
}  // namespace

Words::Words(std::string_view text, std::string file, std::size_t first_line) : text_(text), file_(std::move(file)), line_(first_line) {
  if (text_.starts_with(byte_order_mark)) at_ = byte_order_mark.size();
}

bool Words::at_line_end() const { return at_ == text_.size() || is_break(text_[at_]); }

void Words::pass_line_end() {
  if (at_ == text_.size()) return;
  const bool two_bytes = text_[at_] == '\r' && at_ + 1 < text_.size() && text_[at_ + 1] == '\n';
  at_ += two_bytes ? 2 : 1;
  ++line_;
}

std::string_view Words::take_word() {
  const std::size_t begin = at_;
  std::size_t end = at_;  // local, because a member would be stored at every character
  while (end < text_.size() && !ends_word[static_cast<unsigned char>(text_[end])]) ++end;
  at_ = end;
  return text_.substr(begin, end - begin);
}

bool Words::at_end() {
  while (at_ < text_.size()) {
    if (!ends_word[static_cast<unsigned char>(text_[at_])]) return false;
    if (is_break(text_[at_]))
      pass_line_end();
    else
      ++at_;
  }
  return true;
}

std::string_view Words::next() { return at_end() ? std::string_view{} : take_word(); }

std::string_view Words::next_in_line() {
  while (!at_line_end()) {
    if (is_blank(text_[at_])) {
      ++at_;
    } else if (text_[at_] == '\\' && at_ + 1 < text_.size() && is_break(text_[at_ + 1])) {
      ++at_;
      pass_line_end();
    } else {
      return take_word();
    }
  }
  return {};
}

std::string Words::rest_of_line() {
  while (!at_line_end() && is_blank(text_[at_])) ++at_;
  const std::size_t begin = at_;
  while (!at_line_end()) ++at_;
  std::string_view rest = text_.substr(begin, at_ - begin);
  while (!rest.empty() && is_blank(rest.back())) rest.remove_suffix(1);
  return printable(rest);
}

void Words::skip_line() {
  while (!at_line_end()) ++at_;
  pass_line_end();
}

std::string_view Words::bytes(std::size_t count) {
  const std::string_view taken = text_.substr(at_, count);
  at_ += taken.size();
  return taken;
}

double Words::number(std::string_view word, std::string_view what) const {
  const std::optional<double> value = parsed<double>(without_plus(word));
  if (!value || !std::isfinite(*value)) {
    fail(std::string(what) + " has " + shown(word) + " where a finite number is expected; correct the file or export it again.");
  }
  return *value;
}

void Words::fail(const std::string& sentence) const { throw InputError(file_ + ":" + std::to_string(line_) + ": " + sentence); }

std::string excerpt(std::string_view word, std::size_t longest) {
  std::string text(word.substr(0, longest));
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return text + (word.size() > longest ? "…" : "");
}

std::string shown(std::string_view word) {
  constexpr std::size_t longest = 24;
  return word.empty() ? "nothing" : "`" + excerpt(word, longest) + "`";
}

bool is_word(std::string_view word, std::string_view lower) {
  return word.size() == lower.size() && std::equal(word.begin(), word.end(), lower.begin(), [](char a, char b) { return lowered(a) == b; });
}

}  // namespace fccda
