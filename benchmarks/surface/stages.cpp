/// Stages from a surface file to a surface ready for queries: CSV rows on standard output.
///
///   surface_stages hull.stl --rounds 5
///
/// read: file to panels in memory. fit: class Surface; its main parts are also timed separately: weld, triangulate, connect, wind. bvh: the
/// bounding-volume hierarchy for contact and closest-point queries. check: intersection test of all pairs of panels.

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <utility>

#include "mesh/connect.hpp"
#include "mesh/inspect/self_intersections.hpp"
#include "mesh/search/bvh.hpp"
#include "mesh/surface.hpp"
#include "mesh/triangulate.hpp"
#include "mesh/weld.hpp"
#include "mesh/winding.hpp"
#include "mesh_io/read_panels.hpp"
#include "timed_rounds.hpp"

int main(int argc, char** argv) {
  std::filesystem::path file;
  int rounds = 3;
  bool only_read = false;
  CLI::App app("Times the stages from a surface file to a surface ready for queries; prints CSV rows.");
  app.add_option("file", file)->required()->check(CLI::ExistingFile);
  app.add_option("--rounds", rounds)->check(CLI::PositiveNumber);
  app.add_flag("--only-read", only_read);
  CLI11_PARSE(app, argc, argv);

  benchmark::TimedRounds timed;
  for (int round = 0; round < rounds; ++round) {
    const fccda::Panels panels = timed("read", [&] { return fccda::read_panels(file); });
    if (only_read) continue;
    {
      const auto surface =
          timed("fit", [&] { return std::make_unique<const fccda::Surface>(panels, fccda::Surface::Options{.orientation = fccda::Orientation::normals}); });
      const auto bvh = timed("bvh", [&] { return std::make_unique<const fccda::Bvh>(*surface); });
      timed("check", [&] { return fccda::self_intersections(*surface, *bvh); });
    }
    fccda::Box bounds;
    for (const fccda::Vec3d& vertex : panels.vertices) bounds.include(vertex);
    const double tolerance = fccda::Surface::Options{}.weld_tolerance * norm(bounds.size());
    fccda::Welded welded = timed("weld", [&] { return weld(panels, tolerance); });
    fccda::Triangulation triangulation = timed("triangulate", [&] { return triangulate(welded.panels, tolerance); });
    fccda::LinkedTriangles linked{std::move(welded.panels.vertices), std::move(triangulation.triangles), {}};
    timed("connect", [&] { return connect(linked); });
    timed("wind", [&] { return orient_consistently(linked, "surface"); });
  }
  timed.print();
  return 0;
}
