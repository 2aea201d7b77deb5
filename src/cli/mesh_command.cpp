#include <fmt/format.h>

#include "cli/commands.hpp"
#include "cli/surface_text.hpp"
#include "fccda/core/error.hpp"
#include "fccda/core/parameter.hpp"
#include "fccda/surface/read/read_panels.hpp"

namespace perimpact {

int mesh_command(const MeshArguments& arguments) {
  if (!fccda::positive().contains(arguments.scale))
    throw fccda::InputError(fmt::format("--scale is {}, but it must be above 0; it multiplies the coordinates, so that they become metres.", arguments.scale));
  fccda::Panels panels = fccda::read_panels(arguments.file);
  for (fccda::Vec3d& vertex : panels.vertices) vertex *= arguments.scale;
  // a report is wanted of open surfaces too, and which side is outside changes nothing in it
  const fccda::Surface surface(panels, {.outside = fccda::OutsideIs::normals, .name = arguments.file.string()});
  fmt::print("{}\n{}", arguments.file.string(), surface_text(surface.report()));
  if (!surface.is_closed()) fmt::print("  an open surface needs `outside: normals` or `outside: reversed` in the deck, to say which side is outside\n");
  return 0;
}

}  // namespace perimpact
