#include "perimpact/impact/surface_of.hpp"

#include "fccda/shapes/box.hpp"
#include "fccda/shapes/cylinder.hpp"
#include "fccda/shapes/sphere.hpp"
#include "perimpact/setup/setup_error.hpp"

namespace perimpact {

namespace {

fccda::PanelKind kind(const Choice& panels) { return panels.as<fccda::PanelKind>(); }

fccda::Panels panels_of(const CylinderSurface& s) { return fccda::make_cylinder({s.diameter, s.height, s.axis.as<fccda::Axis>(), s.panel, kind(s.panels)}); }
fccda::Panels panels_of(const SphereSurface& s) { return fccda::make_sphere({s.diameter, s.panel}); }
fccda::Panels panels_of(const FileSurface&) { return {}; }
fccda::Panels panels_of(const BoxSurface& s) { return fccda::make_box({s.size, s.panel, kind(s.panels)}); }

}  // namespace

fccda::Surface surface_of(const SurfaceSetup& setup, const std::string& name) {
  const std::string key = "impactors." + name + ".surface";
  try {
    return std::visit([&](const auto& surface) { return fccda::Surface(panels_of(surface), {.name = name}); }, setup);
  } catch (const fccda::InputError& error) {
    throw SetupError(key, error.what());
  }
}

}  // namespace perimpact
