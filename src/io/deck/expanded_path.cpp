#include "io/deck/expanded_path.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <string_view>

#include "io/deck/yaml_node.hpp"

namespace perimpact::deck {

namespace {

/// The beginning of the path that stands for the home folder; empty if there is none.
std::string_view home_mark(std::string_view path) {
  for (const std::string_view mark : {"~", "$HOME", "${HOME}"})
    if (path.starts_with(mark) && (path.size() == mark.size() || path[mark.size()] == '/')) return mark;
  return {};
}

bool is_variable(std::string_view component) {
  return component.size() > 1 && component[0] == '$' && (component[1] == '{' || component[1] == '_' || std::isalpha(static_cast<unsigned char>(component[1])));
}

}  // namespace

std::string expanded_path(const std::string& path, const std::string& place) {
  std::string expanded = path;
  if (const std::string_view mark = home_mark(path); !mark.empty()) {
    const char* home = std::getenv("HOME");
    if (!home || !*home) refuse(place, fmt::format("{} begins with {}, but the environment has no HOME; write the full path.", path, mark));
    expanded = home + path.substr(mark.size());
  } else if (path.starts_with('~') && path.find('/') != std::string::npos) {
    refuse(place, fmt::format("{} begins with {}, which is not expanded; write the full path.", path, path.substr(0, path.find('/'))));
  }
  for (std::size_t begin = 0; begin < expanded.size(); begin = expanded.find_first_not_of('/', begin)) {
    const std::size_t end = std::min(expanded.find('/', begin), expanded.size());
    if (const std::string component = expanded.substr(begin, end - begin); is_variable(component))
      refuse(place, fmt::format("{} contains {}, but no variable except HOME is expanded; write the full path, or pass it with --set or --out, where the shell "
                                "expands it.",
                                path, component));
    begin = end;
  }
  return expanded;
}

}  // namespace perimpact::deck
