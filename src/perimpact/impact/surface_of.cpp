#include "perimpact/impact/surface_of.hpp"

#include "fccda/shapes/box.hpp"
#include "fccda/shapes/cylinder.hpp"
#include "fccda/shapes/sphere.hpp"
#include "fccda/surface/place.hpp"
#include "fccda/surface/read/read_panels.hpp"
#include "perimpact/setup/setup_error.hpp"

namespace perimpact {

namespace {

fccda::PanelKind kind(const Choice& panels) { return panels.as<fccda::PanelKind>(); }

fccda::Panels panels_of(const CylinderSurface& s) { return fccda::make_cylinder({s.diameter, s.height, s.axis.as<fccda::Axis>(), s.panel, kind(s.panels)}); }
fccda::Panels panels_of(const SphereSurface& s) { return fccda::make_sphere({s.diameter, s.panel}); }
fccda::Panels panels_of(const BoxSurface& s) { return fccda::make_box({s.size, s.panel, kind(s.panels)}); }
fccda::Panels panels_of(const FileSurface& s) {
  fccda::Panels panels = fccda::read_panels(s.file, s.parts);
  const auto plane = [](const Choice& choice) { return choice.as<fccda::MirrorPlane>(); };
  fccda::place(panels, {s.scale, plane(s.mirror), plane(s.complete), s.rotate, s.translate});
  return panels;
}

/// Surfaces that we make ourselves are closed; a file says.
fccda::OutsideIs outside(const SurfaceSetup& setup) {
  const auto* file = std::get_if<FileSurface>(&setup);
  return file ? file->outside.as<fccda::OutsideIs>() : fccda::OutsideIs::undeclared;
}

}  // namespace

fccda::Surface surface_of(const SurfaceSetup& setup, const std::string& name) {
  const std::string key = "impactors." + name + ".surface";
  try {
    return std::visit([&](const auto& surface) { return fccda::Surface(panels_of(surface), {.outside = outside(setup), .name = name}); }, setup);
  } catch (const fccda::InputError& error) {
    throw SetupError(key, error.what());
  }
}

}  // namespace perimpact
