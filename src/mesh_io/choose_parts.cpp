#include "mesh_io/choose_parts.hpp"

#include <algorithm>
#include <vector>

#include "base/error.hpp"
#include "base/no_such_part.hpp"

namespace fccda {
namespace {

/// A flag for each part: whether it is selected.
std::vector<bool> wanted_parts(std::span<const std::string> parts, std::span<const std::string> names, const std::string& file) {
  const std::vector<std::string> nameless(1);
  const std::span<const std::string> known = names.empty() ? std::span<const std::string>(nameless) : names;
  std::vector<bool> wanted(names.size(), false);
  for (const std::string& part : parts) {
    const auto found = std::find(names.begin(), names.end(), part);
    if (found == names.end()) throw InputError(file + ": " + no_such_part(part, known));
    wanted[static_cast<std::size_t>(found - names.begin())] = true;
  }
  return wanted;
}

}  // namespace

void keep_parts(Panels& panels, std::span<const std::string> parts, const std::string& file) {
  if (parts.empty()) return;
  const std::vector<bool> wanted = wanted_parts(parts, panels.part_names, file);
  std::size_t kept = 0;
  for (std::size_t p = 0; p < panels.panels.size(); ++p) {
    if (!wanted[static_cast<std::size_t>(panels.part[p])]) continue;
    panels.panels[kept] = panels.panels[p];
    panels.part[kept++] = panels.part[p];
  }
  panels.panels.resize(kept);
  panels.part.resize(kept);
  std::vector<int> number(wanted.size(), -1);
  std::vector<std::string> names;
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    if (!wanted[k]) continue;
    number[k] = static_cast<int>(names.size());
    names.push_back(panels.part_names[k]);
  }
  for (int& part : panels.part) part = number[static_cast<std::size_t>(part)];
  panels.part_names = std::move(names);
}

void keep_parts(Elements& elements, std::span<const std::string> parts, const std::string& file) {
  if (parts.empty()) return;
  const std::vector<bool> wanted = wanted_parts(parts, elements.part_names, file);
  Elements kept;
  for (std::size_t e = 0; e < elements.size(); ++e) {
    const auto part = static_cast<std::size_t>(elements.part[e]);
    if (wanted[part]) kept.add(elements.kinds[e], elements.nodes_of_element(e), kept.part_number(elements.part_names[part]));
  }
  kept.vertices = std::move(elements.vertices);
  elements = std::move(kept);
}

}  // namespace fccda
