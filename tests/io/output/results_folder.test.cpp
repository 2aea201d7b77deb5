#include "io/output/results_folder.hpp"

#include <doctest/doctest.h>

#include "base/error.hpp"
#include "fixtures/temporary_folder.hpp"

using namespace perimpact::output;
using fixtures::TemporaryFolder;
using Names = std::set<std::string>;

TEST_CASE("results: the folder is created with its parents, empty") {
  const TemporaryFolder folder;
  const ResultsFolder results(folder / "ice/run 1");
  CHECK(std::filesystem::is_directory(results.frames()));
  CHECK(std::filesystem::is_directory(results.line("along_x", 2e-4).parent_path()));
  CHECK(results.line("along_x", 2e-4).filename() == "along_x_t0.0002.csv");
  CHECK(fixtures::files_in(folder.path()).empty());
}

TEST_CASE("results: the files of an earlier run are removed, everything else is kept") {
  const TemporaryFolder folder;
  const Names ours = {"run.json",
                      "run.json.part",
                      "history.csv",
                      "history.json",
                      "statistics.csv",
                      "windows.csv",
                      "spectrum.csv",
                      "fragments/ice.csv",
                      "fragments/ice_end.csv.part",
                      "lines/along_x_t0.0002.csv",
                      "lines/a_t_t5e-05.csv",
                      "frames/plate.pvd",
                      "frames/plate.pvd.part",
                      "frames/plate_00000.vtp",
                      "frames/plate_00001.vtp",
                      "frames/plate_100000.vtp",
                      "frames/plate_00002.vtp.part"};
  const Names foreign = {
      "notes.txt",        "deck.yaml",         "history.csv.bak", "check/plate.vtp",         "lines/reference.csv",    "lines/measured_top.csv",
      "frames/view.pvsm", "frames/other.pvd",  "frames/hull.vtp", "frames/hull_0001.vtp",    "frames/sub/x_00000.vtp", "frames/plate_00000.png",
      "plate_00000.vtp",  "frames/_00000.vtp", "lines/run.json",  "frames/plate_00000.vtp~", "lines/_t1.csv",          "lines/a_t1.txt"};
  for (const Names& names : {ours, foreign}) {
    for (const std::string& name : names) fixtures::put(folder / name, "x");
  }
  const ResultsFolder results(folder.path());
  CHECK(fixtures::files_in(folder.path()) == foreign);
}

TEST_CASE("results: an unusable folder is an input error before anything is computed") {
  const TemporaryFolder folder;
  fixtures::put(folder / "file", "x");
  CHECK_THROWS_WITH_AS(ResultsFolder(folder / "file/run"),
                       ("results cannot be written to the folder " + (folder / "file/run").string() +
                        ": Not a directory. Choose another one with --out, or with output.folder in the deck.")
                           .c_str(),
                       fccda::InputError);
  CHECK_THROWS_AS(prepare_folder("/proc"), fccda::InputError);          // exists, but is not writable even for root
  CHECK_THROWS_AS(ResultsFolder("/proc/self/run"), fccda::InputError);  // cannot be created
}

TEST_CASE("results: an unusable folder keeps the earlier run") {
  const TemporaryFolder folder;
  fixtures::put(folder / "run.json", "earlier");
  fixtures::put(folder / "lines", "a file where a folder must be");
  CHECK_THROWS_AS(ResultsFolder(folder.path()), fccda::InputError);
  CHECK(fixtures::text_of(folder / "run.json") == "earlier");
}

TEST_CASE("results: a restart keeps the files of the earlier run, except partial ones and the one that describes how it ended") {
  const TemporaryFolder folder;
  const Names kept = {"history.csv",      "history.json",           "checkpoint.h5",          "lines/along_x_t0.0002.csv",
                      "frames/plate.pvd", "frames/plate_00000.vtp", "pressure_area/hull.csv", "fragments/ice.csv",
                      "notes.part"};
  for (const std::string& name : kept) fixtures::put(folder / name, "x");
  for (const char* name : {"run.json", "checkpoint.h5.part", "frames/plate_00001.vtp.part", "frames/plate.pvd.part"}) fixtures::put(folder / name, "x");
  const ResultsFolder results(folder.path(), EarlierRun::continued);
  CHECK(fixtures::files_in(folder.path()) == kept);
  const ResultsFolder anew(folder.path());
  CHECK(fixtures::files_in(folder.path()) == Names{"notes.part"});
}
