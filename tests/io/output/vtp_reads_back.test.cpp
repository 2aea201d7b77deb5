#include <doctest/doctest.h>

#include "fixtures/surfaces.hpp"
#include "fixtures/temporary_folder.hpp"
#include "io/output/vtp.hpp"
#include "mesh_io/read_panels.hpp"

using namespace perimpact::output;

TEST_CASE("vtp: a written surface is read back bitwise, with its parts") {
  const fixtures::TemporaryFolder folder;
  for (const fccda::Panels& panels : {fixtures::torus(2, 0.5, 9, 7, 1), fixtures::tetrahedron()}) {
    std::vector<std::int32_t> part(panels.panels.size(), 2);
    part.front() = 7;
    const PolyData frame{.points = coordinates(panels.vertices), .panels = panels.panels, .cell_arrays = {{"part", 1, std::span(part)}}, .time = 0.5};
    for (const Compression compression : {Compression::none, Compression::zlib}) {
      write_vtp(folder / "s.vtp", frame, compression);
      const fccda::Panels back = fccda::read_panels(folder / "s.vtp");
      CHECK(back.vertices == panels.vertices);
      CHECK(back.panels == panels.panels);
      CHECK(back.part_names == std::vector<std::string>{"part 7", "part 2"});
    }
  }
}
