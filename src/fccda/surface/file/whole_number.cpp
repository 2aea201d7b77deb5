#include "fccda/surface/file/whole_number.hpp"

#include <charconv>

namespace fccda {
namespace {

[[noreturn]] void refuse(const Words& words, std::string_view word, std::string_view what, const char* belongs) {
  words.fail(std::string(what) + " has " + shown(word) + " where a " + belongs + " belongs; mend the file or write it again.");
}

bool parsed(std::string_view word, std::int64_t& value) {
  const std::string_view digits = word.starts_with('+') && !word.starts_with("+-") ? word.substr(1) : word;
  const auto [end, problem] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  return problem == std::errc{} && end == digits.data() + digits.size();
}

}  // namespace

std::int64_t whole_number(const Words& words, std::string_view word, std::string_view what) {
  std::int64_t value = 0;
  if (!parsed(word, value)) refuse(words, word, what, "whole number");
  return value;
}

std::size_t count_number(const Words& words, std::string_view word, std::string_view what) {
  std::int64_t value = 0;
  if (!parsed(word, value) || value < 0) refuse(words, word, what, "count");
  return static_cast<std::size_t>(value);
}

}  // namespace fccda
