/// Surface mesh from a file, with its scale and placement.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/parameter.hpp"
#include "base/vec3.hpp"

namespace fccda {
class NamedPanels;
}

namespace perimpact {

using fccda::Choice;
using fccda::Field;
using fccda::Vec3d;

inline constexpr std::string_view open_side_words[] = {"undeclared", "normals", "reversed"};

inline constexpr std::string_view mirror_plane_words[] = {"none", "x", "y", "z"};

/// `surface: {file: hull.stl, scale: 0.001}`
struct FileSurface {
  static constexpr std::string_view name = "file";
  std::string file;                     ///< path; a relative one starts at the deck's folder. Or the name of `panels`
  std::vector<std::string> file_parts;  ///< of the file; all where empty
  double scale = 1;                     ///< converts the file's coordinates to metres
  Choice mirror{mirror_plane_words};
  Choice mirror_merge{mirror_plane_words};             ///< adds the mirror image
  Vec3d rotate{};                                      ///< [rad] about x, then y, then z
  Vec3d translate{};                                   ///< [m]
  std::optional<double> weld;                          ///< [m] welding tolerance; 1e-9 of the size where absent
  Choice orientation{open_side_words};                 ///< outer side of an open surface
  std::shared_ptr<const fccda::NamedPanels> panels{};  ///< in memory, instead of a file
  static std::span<const Field<FileSurface>> fields();
};

}  // namespace perimpact
