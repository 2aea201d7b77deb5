#include "perimpact/discretisation/panels_of_file.hpp"

#include "mesh/placement.hpp"
#include "mesh_io/read_panels.hpp"

namespace perimpact {

fccda::Panels panels_of_file(const FileSurface& setup) {
  fccda::Panels panels = fccda::read_panels(setup.file, setup.file_parts);
  const auto plane = [](const Choice& choice) { return choice.as<fccda::MirrorPlane, mirror_plane_words>(); };
  fccda::place(panels, {setup.scale, plane(setup.mirror), plane(setup.mirror_merge), setup.rotate, setup.translate});
  return panels;
}

}  // namespace perimpact
