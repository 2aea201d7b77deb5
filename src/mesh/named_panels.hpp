/// Panels in memory that replace a surface file.
///
/// The name is a hash of the contents: equal panels have equal names, different ones almost surely not. So a name never changes its
/// meaning, and a recorded name identifies the panels.
#pragma once

#include <memory>
#include <string>

#include "mesh/panels.hpp"

namespace fccda {

/// Copies share the panels.
class NamedPanels {
 public:
  explicit NamedPanels(Panels panels);

  const Panels& panels() const { return *panels_; }
  const std::string& name() const { return name_; }

 private:
  std::shared_ptr<const Panels> panels_;
  std::string name_;
};

}  // namespace fccda
