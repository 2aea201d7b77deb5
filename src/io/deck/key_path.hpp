/// Paths of keys: "bodies.plate.family".
#pragma once

#include <string_view>
#include <vector>

namespace perimpact::deck {

/// The dot-separated keys of a path, outermost first; keys may be empty.
inline std::vector<std::string_view> keys_of(std::string_view path) {
  std::vector<std::string_view> keys;
  for (;;) {
    const std::size_t dot = path.find('.');
    keys.push_back(path.substr(0, dot));
    if (dot == std::string_view::npos) return keys;
    path.remove_prefix(dot + 1);
  }
}

}  // namespace perimpact::deck
