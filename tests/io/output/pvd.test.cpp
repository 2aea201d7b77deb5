#include "io/output/pvd.hpp"

#include <doctest/doctest.h>

#include <stdexcept>

#include "fixtures/temporary_folder.hpp"
#include "io/output/file.hpp"

using namespace perimpact::output;

TEST_CASE("pvd: after each frame the list names every frame with its time, and no other") {
  const fixtures::TemporaryFolder folder;
  Series plate(folder.path(), "plate & ice");
  const auto frame = [](const std::filesystem::path& path) { write_whole_file(path, "frame"); };
  const auto list = [&] { return fixtures::text_of(folder / "plate & ice.pvd"); };
  const std::string head = "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n  <Collection>\n";
  const std::string first = "    <DataSet timestep=\"0\" group=\"\" part=\"0\" file=\"plate &amp; ice_00000.vtp\"/>\n";
  const std::string second = "    <DataSet timestep=\"5e-06\" group=\"\" part=\"0\" file=\"plate &amp; ice_00001.vtp\"/>\n";
  const std::string tail = "  </Collection>\n</VTKFile>\n";

  plate.add(0, frame);
  CHECK(list() == head + first + tail);
  CHECK_THROWS(plate.add(5e-6, [](const std::filesystem::path&) { throw std::runtime_error("disk full"); }));
  CHECK(list() == head + first + tail);
  plate.add(5e-6, frame);
  CHECK(list() == head + first + second + tail);
  CHECK(fixtures::files_in(folder.path()) == std::set<std::string>{"plate & ice.pvd", "plate & ice_00000.vtp", "plate & ice_00001.vtp"});
}
