#include "io/deck/deck_file.hpp"

#include <fmt/format.h>

#include "io/deck/yaml_node.hpp"

namespace perimpact::deck {

std::string full_path(const std::filesystem::path& file, const std::string& place) {
  const std::filesystem::path path = std::filesystem::absolute(file).lexically_normal();
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) refuse(place, fmt::format("{} is a folder, but a file is needed.", path.string()));
  if (!std::filesystem::is_regular_file(path, ignored))
    refuse(place, fmt::format("there is no file {}; relative names start at the deck's folder.", path.string()));
  return path.string();
}

std::ifstream open_file(const std::string& full_path, const std::string& place) {
  std::ifstream stream(full_path);
  if (!stream) refuse(place, fmt::format("the file {} cannot be opened; check its permissions.", full_path));
  return stream;
}

}  // namespace perimpact::deck
