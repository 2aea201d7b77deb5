#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"
#include "base/parameter.hpp"
#include "cli/commands.hpp"
#include "cli/mesh_report.hpp"
#include "cli/surface_text.hpp"
#include "io/deck/units.hpp"
#include "io/output/surface_file.hpp"
#include "io/results/defect_files.hpp"
#include "mesh/placement.hpp"
#include "mesh_io/file/contents.hpp"
#include "mesh_io/read_panels.hpp"

namespace perimpact {

using namespace fccda;

namespace {

/// Length of an option, with a unit or in metres; 0 if not given.
double length_of(const char* option, const std::string& text) {
  if (text.empty()) return 0;
  const deck::Converted length = deck::to_si(text, "m");
  if (!length.complaint.empty()) throw InputError(fmt::format("{} is {}: {}.", option, text, length.complaint));
  if (!positive().contains(length.value)) throw InputError(fmt::format("{} is {}, but it must be above 0.", option, text));
  return length.value;
}

/// hull_defects.vtp in the working directory, for hull.stl.gz.
std::filesystem::path defects_file(const std::filesystem::path& surface) { return fccda::unpacked(surface).stem().string() + "_defects.vtp"; }

Surface fit_surface(const Panels& panels, double weld, const std::filesystem::path& file) {
  try {
    // the report includes open surfaces and does not depend on the outer side
    return Surface(panels, {.weld_distance = weld, .orientation = Orientation::normals, .name = file.string()});
  } catch (const SurfaceError& error) {
    write_defects(defects_file(file), panels, {&error.defect(), 1});
    throw InputError(fmt::format("{} These panels are in {}, for ParaView.", error.what(), defects_file(file).string()));
  }
}

/// All defects that can be shown in a file.
std::vector<Defect> defects_of(const Surface& surface, const SelfIntersections& folds) {
  std::vector<Defect> defects = folds.defects;
  if (!surface.is_closed()) defects.push_back({DefectKind::rim, surface.panels_on_boundary()});
  return defects;
}

}  // namespace

int mesh_command(const MeshArguments& arguments) {
  if (!positive().contains(arguments.scale))
    throw InputError(fmt::format("--scale is {}, but it must be above 0: the factor that converts the coordinates to metres.", arguments.scale));
  const double spacing = length_of("--spacing", arguments.spacing), weld = length_of("--weld", arguments.weld);  // checked before the file is read
  if (!arguments.out.empty()) output::expect_surface_file(arguments.out);
  Panels panels = read_panels(arguments.file, arguments.parts);
  place(panels, {.scale = arguments.scale});
  const Surface surface = fit_surface(panels, weld, arguments.file);
  const Bvh bvh(surface);
  const SelfIntersections folds = self_intersections(surface, bvh);

  fmt::print("{}\n{}{}", arguments.file.string(), surface_text(surface.report()), defects_text(surface, folds));
  if (const auto suspicion = unit_suspicion(surface.report())) fmt::print("  {:<18}{}\n", "unit?", *suspicion);
  if (spacing > 0) fmt::print("{}", spacing_text(surface, bvh, spacing));
  if (const auto suspicion = half_suspicion(surface)) fmt::print("  {:<18}{}\n", "half?", *suspicion);
  if (const auto distance = closing_weld(panels, surface))
    fmt::print("  {:<18}vertices differ by rounding; --weld {:.3g} (`weld: {:.3g}` in the deck) closes the surface\n", "gaps?", *distance, *distance);
  if (!surface.is_closed()) fmt::print("  an open surface requires `orientation: normals` or `orientation: reversed` in the deck to define its outer side\n");
  if (const std::vector<Defect> defects = defects_of(surface, folds); !defects.empty()) {
    write_defects(defects_file(arguments.file), panels, defects);
    fmt::print("  defective panels are in {}, for ParaView\n", defects_file(arguments.file).string());
  }
  if (!arguments.out.empty()) {
    output::write_surface(arguments.out, surface);
    fmt::print("  the repaired surface is in {}\n", arguments.out.string());
  }
  return 0;
}

}  // namespace perimpact
