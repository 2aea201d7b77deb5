#include "perimpact/impactor/surface_of.hpp"

#include "mesh/inspect/self_intersections.hpp"
#include "mesh/shapes/box.hpp"
#include "mesh/shapes/cylinder.hpp"
#include "mesh/shapes/sphere.hpp"
#include "perimpact/discretisation/panels_of_file.hpp"
#include "perimpact/impactor/generated_shape.hpp"

namespace perimpact {

namespace {

fccda::PanelKind kind(const Choice& panels) { return panels.as<fccda::PanelKind, panel_words>(); }

fccda::Panels panels_of(const CylinderSurface& s) {
  return fccda::make_cylinder({s.diameter, s.height, s.axis.as<fccda::Axis, axis_words>(), s.edge_length, kind(s.panel_shape)});
}
fccda::Panels panels_of(const SphereSurface& s) { return fccda::make_sphere({s.diameter, s.edge_length}); }
fccda::Panels panels_of(const BoxSurface& s) { return fccda::make_box({s.size, s.edge_length, kind(s.panel_shape)}); }
fccda::Panels panels_of(const HullSurface& s) { return fccda::make_hull(shape_of(s)); }
fccda::Panels panels_of(const PropellerSurface& s) { return fccda::make_propeller(shape_of(s)); }
fccda::Panels panels_of(const FileSurface& s) { return panels_of_file(s); }

/// Generated surfaces are closed; for a file the deck declares the orientation.
fccda::Orientation orientation(const SurfaceSetup& setup) {
  const auto* file = std::get_if<FileSurface>(&setup);
  return file ? file->orientation.as<fccda::Orientation, open_side_words>() : fccda::Orientation::undeclared;
}

}  // namespace

GivenSurface surface_of(const SurfaceSetup& setup, const std::string& name) {
  const std::string key = "impactors." + name + ".surface";
  fccda::Panels panels;
  try {
    panels = std::visit([](const auto& surface) { return panels_of(surface); }, setup);
    const auto* file = std::get_if<FileSurface>(&setup);
    GivenSurface given{fccda::Surface(panels, {.weld_distance = file ? file->weld.value_or(0) : 0, .orientation = orientation(setup), .name = name})};
    if (file) {
      const fccda::SelfIntersections found = fccda::self_intersections(given.surface, fccda::Bvh(given.surface));
      fccda::expect_no_pockets(found, name);
      for (const fccda::Defect& defect : found.defects) given.crossing_panels += defect.panels.size();
    }
    return given;
  } catch (const fccda::SurfaceError& error) {
    throw DefectiveSurface(key, name, std::move(panels), error);
  } catch (const fccda::InputError& error) {
    throw SetupError(key, error);
  }
}

}  // namespace perimpact
