/// A registry of panels in memory under names that are accepted wherever a surface file is.
///
/// The name is a hash of the contents: equal panels have equal names, different ones almost surely not. So a name never changes its
/// meaning, and a recorded name identifies the panels.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "mesh/panels.hpp"

namespace fccda {

class PanelsInMemory {
 public:
  /// Registers the panels under their name for the lifetime of this object and its copies.
  explicit PanelsInMemory(Panels panels);

  const Panels& panels() const { return *panels_; }
  const std::string& name() const { return name_; }

 private:
  std::shared_ptr<const Panels> panels_;
  std::string name_;
};

/// The panels of that name; null if there are none. Thread-safe.
std::shared_ptr<const Panels> panels_in_memory(std::string_view name);

}  // namespace fccda
