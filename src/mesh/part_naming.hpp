/// Assigns part names to panels while they are added, for readers and generators:
///
///   PartNaming parts(panels);
///   parts.begin("blade_1");      // panels added from here on
///   panels.add_triangle(…);
///   parts.begin("hub");
///   …
///   parts.finish();
#pragma once

#include <string>
#include <unordered_map>

#include "mesh/panels.hpp"

namespace fccda {

class PartNaming {
 public:
  /// `panels` must outlive this object and be empty.
  explicit PartNaming(Panels& panels) : panels_(panels) {}

  /// Panels added from here on belong to the part of that name; a repeated name continues the same part. Panels added before the first
  /// call belong to an unnamed part.
  void begin(std::string name);

  /// Call after the last panel. Parts without panels are dropped; if only an unnamed part is left, `panels` stays without parts.
  void finish();

 private:
  void close();

  Panels& panels_;
  std::string name_;
  std::unordered_map<std::string, int> number_of_;
};

}  // namespace fccda
