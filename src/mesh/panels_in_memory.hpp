/// Panels that a program has in memory, under a name that may stand wherever the file of a surface is named.
///
/// The name is made of what the panels are: equal panels have equal names, others almost surely not. So a name never comes to mean
/// something else, and who notes it notes which panels they were.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "mesh/panels.hpp"

namespace fccda {

class PanelsInMemory {
 public:
  /// From now on they are found under their name, for as long as this object or a copy lives.
  explicit PanelsInMemory(Panels panels);

  const Panels& panels() const { return *panels_; }
  const std::string& name() const { return name_; }

 private:
  std::shared_ptr<const Panels> panels_;
  std::string name_;
};

/// Those of that name; null where there are none. Any number of threads may ask.
std::shared_ptr<const Panels> panels_in_memory(std::string_view name);

}  // namespace fccda
