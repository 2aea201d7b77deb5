/// Contents of an Abaqus input file before assembly: parts with local numbering, instances that position them, and sets.
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

/// The element numbers first, first + step … last.
struct AbaqusRange {
  std::int64_t first, last, step;
};

/// An *ELSET. `is_own`: defined by the user, of elements only; false for internal sets of Abaqus/CAE and for unions of sets.
struct AbaqusSet {
  std::string name;
  std::string instance;  ///< that an *ELSET of the assembly refers to; else empty
  std::vector<AbaqusRange> members;
  bool is_own = true;
};

/// A mesh with local numbering: of a part, of an instance, of the assembly or of a file without any of these.
struct AbaqusMesh {
  NumberedMesh mesh;
  std::vector<std::string> groups{""};  ///< set names from ELSET= on *ELEMENT, by element group; the first for elements without a set
  std::vector<AbaqusSet> sets;

  int group_number(const std::string& set);  ///< adds a group for a new set; case-insensitive

 private:
  std::map<std::string, int> numbers_;  // of groups, by name in capitals
};

/// *INSTANCE: translated first, then rotated about the axis through two points (Abaqus Keywords Guide, *INSTANCE).
struct AbaqusInstance {
  std::string name;
  std::string part;
  std::size_t line = 0;
  Vec3d translation{};
  Vec3d axis_point{};
  Quaternion turn;
  AbaqusMesh own;  ///< defined between *INSTANCE and *END INSTANCE

  Vec3d placed(const Vec3d& point) const;
};

struct AbaqusModel {
  std::map<std::string, std::pair<std::string, AbaqusMesh>> parts;  ///< by name in capitals: name as written, mesh
  std::vector<AbaqusInstance> instances;
  AbaqusMesh assembly;
  AbaqusMesh flat;  ///< defined outside parts and assembly
  bool has_assembly = false;
};

/// The assembled mesh: all instances at their positions, or all parts where there is no assembly. Throws InputError through `lines` where nodes or
/// parts are undefined, numbers are ambiguous, or instances would make the mesh far larger than the file.
Elements mesh_of(AbaqusModel model, const Lines& lines);

}  // namespace fccda
