#include "mesh_io/file/whole_number.hpp"

#include <optional>

#include "mesh_io/file/text.hpp"

namespace fccda {
namespace {

[[noreturn]] void refuse(const Words& words, std::string_view word, std::string_view what, const char* belongs) {
  words.fail(std::string(what) + " has " + shown(word) + " where " + belongs + " is expected; correct the file or export it again.");
}

}  // namespace

std::int64_t whole_number(const Words& words, std::string_view word, std::string_view what) {
  const std::optional<std::int64_t> value = parsed<std::int64_t>(without_plus(word));
  if (!value) refuse(words, word, what, "an integer");
  return *value;
}

std::size_t count_number(const Words& words, std::string_view word, std::string_view what) {
  const std::optional<std::int64_t> value = parsed<std::int64_t>(without_plus(word));
  if (!value || *value < 0) refuse(words, word, what, "a count");
  return static_cast<std::size_t>(*value);
}

}  // namespace fccda
