#include "perimpact/discretisation/panels_of_file.hpp"

#include "base/error.hpp"
#include "mesh/named_panels.hpp"
#include "mesh/placement.hpp"
#include "mesh_io/choose_parts.hpp"
#include "mesh_io/read_panels.hpp"

namespace perimpact {

namespace {

fccda::Panels parts_of(const fccda::NamedPanels& named, const std::vector<std::string>& parts) {
  fccda::Panels panels = named.panels();
  fccda::keep_parts(panels, parts, named.name());
  if (panels.panels.empty()) throw fccda::InputError(named.name() + ": the mesh contains no faces.");
  return panels;
}

}  // namespace

fccda::Panels panels_of_file(const FileSurface& setup) {
  fccda::Panels panels = setup.panels ? parts_of(*setup.panels, setup.file_parts) : fccda::read_panels(setup.file, setup.file_parts);
  const auto plane = [](const Choice& choice) { return choice.as<fccda::MirrorPlane, mirror_plane_words>(); };
  fccda::place(panels, {setup.scale, plane(setup.mirror), plane(setup.mirror_merge), setup.rotate, setup.translate});
  return panels;
}

}  // namespace perimpact
