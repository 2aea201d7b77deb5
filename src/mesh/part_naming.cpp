#include "mesh/part_naming.hpp"

#include <utility>

namespace fccda {

void PartNaming::begin(std::string name) {
  close();
  name_ = std::move(name);
}

void PartNaming::finish() {
  close();
  if (panels_.part_names.size() == 1 && panels_.part_names[0].empty()) panels_.part.clear(), panels_.part_names.clear();
}

void PartNaming::close() {
  if (panels_.part.size() == panels_.panels.size()) return;
  const auto [entry, is_new] = number_of_.try_emplace(name_, static_cast<int>(panels_.part_names.size()));
  if (is_new) panels_.part_names.push_back(name_);
  panels_.part.resize(panels_.panels.size(), entry->second);
}

}  // namespace fccda
