/// Values as JSON text.
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <vector>

#include "base/parameter.hpp"

namespace perimpact::deck {

inline std::string json_string(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
      out += fmt::format("\\u{:04x}", static_cast<int>(c));
    else
      out += c;
  }
  return out + '"';
}

// fmt writes the shortest decimal that round-trips to the same double.
inline std::string json(double value) { return fmt::format("{}", value); }
inline std::string json(int value) { return fmt::format("{}", value); }
inline std::string json(bool value) { return value ? "true" : "false"; }
inline std::string json(const std::string& value) { return json_string(value); }
inline std::string json(const fccda::Choice& value) { return json_string(value.word()); }
inline std::string json(const fccda::Vec3d& value) { return fmt::format("[{}, {}, {}]", value.x, value.y, value.z); }
template <class T>
std::string json(const std::vector<T>& values) {
  std::vector<std::string> items;
  items.reserve(values.size());
  for (const T& value : values) items.push_back(json(value));
  return fmt::format("[{}]", fmt::join(items, ", "));
}

}  // namespace perimpact::deck
