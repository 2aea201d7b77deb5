/// What an Abaqus input file holds, before it becomes one mesh: parts with their own numbers, instances that place them, sets.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "base/quaternion.hpp"
#include "mesh_io/file/elements.hpp"
#include "mesh_io/keyword/lines.hpp"
#include "mesh_io/keyword/numbered_mesh.hpp"

namespace fccda {

/// Element numbers first, first + step … last.
struct AbaqusRange {
  std::int64_t first, last, step;
};

/// An *ELSET. `is_own`: made by the user, of elements alone; sets that Abaqus/CAE makes for itself and unions of sets are not.
struct AbaqusSet {
  std::string name;
  std::string instance;  ///< that an *ELSET of the assembly speaks of; else empty
  std::vector<AbaqusRange> members;
  bool is_own = true;
};

/// A mesh with numbers of its own: of a part, of an instance, of the assembly or of a file without any of these.
struct AbaqusMesh {
  NumberedMesh mesh;
  std::vector<std::string> groups{""};  ///< ELSET= on *ELEMENT, by the group of an element; the first is of elements without
  std::vector<AbaqusSet> sets;

  int group_number(const std::string& set);  ///< which is new where the set is; case does not count

 private:
  std::map<std::string, int> numbers_;  // of groups, by name in capitals
};

/// *INSTANCE: first translated, then turned about the axis through two points (Abaqus Keywords Guide, *INSTANCE).
struct AbaqusInstance {
  std::string name;
  std::string part;
  std::size_t line = 0;
  Vec3d translation{};
  Vec3d axis_point{};
  Quaternion turn;
  AbaqusMesh own;  ///< what is defined between *INSTANCE and *END INSTANCE

  Vec3d placed(const Vec3d& point) const;
};

struct AbaqusModel {
  std::map<std::string, std::pair<std::string, AbaqusMesh>> parts;  ///< by name in capitals: name as written, mesh
  std::vector<AbaqusInstance> instances;
  AbaqusMesh assembly;
  AbaqusMesh flat;  ///< outside parts and assembly
  bool has_assembly = false;
};

/// One mesh of all: every instance in its place, or every part where there is no assembly. Throws InputError through `lines` where nodes or parts are not
/// defined, numbers mean two things, or instances would make the mesh much larger than the file.
Elements mesh_of(AbaqusModel model, const Lines& lines);

}  // namespace fccda
