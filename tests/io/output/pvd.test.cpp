#include "io/output/pvd.hpp"

#include <doctest/doctest.h>

#include <stdexcept>

#include "base/error.hpp"
#include "fixtures/temporary_folder.hpp"
#include "io/output/file.hpp"

using namespace perimpact::output;

TEST_CASE("pvd: after each frame the list contains every frame with its time, and no other") {
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

TEST_CASE("pvd: a resumed series lists the given frames and those that follow, and removes later ones") {
  const fixtures::TemporaryFolder folder, whole;
  const auto frame = [](const std::filesystem::path& path) { write_whole_file(path, "frame"); };
  for (const auto* each : {&folder, &whole}) {
    Series plate(each->path(), "plate");
    for (const double time : {0.0, 1e-6, 2e-6, 3e-6}) plate.add(time, frame);
  }
  fixtures::put(folder / "plate_00003.vtp", "later");
  Series again(folder.path(), "plate", {0, 1e-6});
  CHECK(fixtures::files_in(folder.path()) == std::set<std::string>{"plate.pvd", "plate_00000.vtp", "plate_00001.vtp"});
  for (const double time : {2e-6, 3e-6}) again.add(time, frame);
  CHECK(again.times() == std::vector<double>{0, 1e-6, 2e-6, 3e-6});
  const std::vector<FrameFile> frames = frame_files_of(folder / "plate.pvd");
  REQUIRE(frames.size() == 4);
  for (std::size_t k = 0; k < 4; ++k) {
    CHECK(frames[k].time == again.times()[k]);
    CHECK(frames[k].file == folder / ("plate_0000" + std::to_string(k) + ".vtp"));
  }
  for (const std::string& name : fixtures::files_in(whole.path())) CHECK(fixtures::text_of(folder / name) == fixtures::text_of(whole / name));
}

TEST_CASE("pvd: a file that lists no frames is refused") {
  const fixtures::TemporaryFolder folder;
  for (const char* text : {"", "<VTKFile></VTKFile>", "<DataSet timestep=\"one\" file=\"a.vtp\"/>", "<DataSet timestep=\"1\"/>"}) {
    fixtures::put(folder / "plate.pvd", text);
    CHECK_THROWS_WITH_AS(frame_files_of(folder / "plate.pvd"),
                         ((folder / "plate.pvd").string() + " lists no frames with their times; use the file as written by the run.").c_str(),
                         fccda::InputError);
  }
}
