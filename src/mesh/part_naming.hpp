/// Gives names to panels while they are added, for readers and generators:
///
///   PartNaming parts(panels);
///   parts.begin("blade_1");      // what is added from here on
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
  /// `panels` must outlive this, and hold none yet.
  explicit PartNaming(Panels& panels) : panels_(panels) {}

  /// Panels added from here on belong to the part of that name; a name that comes again means the same part. Panels added before the
  /// first call belong to a part without a name.
  void begin(std::string name);

  /// Call after the last panel. A part without panels is none; where nothing but a part without a name is left, `panels` stays without parts.
  void finish();

 private:
  void close();

  Panels& panels_;
  std::string name_;
  std::unordered_map<std::string, int> number_of_;
};

}  // namespace fccda
