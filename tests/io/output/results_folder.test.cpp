#include "io/output/results_folder.hpp"

#include <doctest/doctest.h>

#include "base/error.hpp"
#include "fixtures/temporary_folder.hpp"

using namespace perimpact::output;
using fixtures::TemporaryFolder;
using Names = std::set<std::string>;

namespace {

FileList list_of(const Names& names) {
  FileList list;
  for (const std::string& name : names) list.add(name);
  return list;
}

}  // namespace

TEST_CASE("results: the folder is created with its parents, with the list of what the run will write") {
  const TemporaryFolder folder;
  const ResultsFolder results(folder / "ice/run 1", list_of({"run.json"}));
  CHECK(std::filesystem::is_directory(results.frames()));
  CHECK(std::filesystem::is_directory(results.line("along_x", 2e-4).parent_path()));
  CHECK(results.line("along_x", 2e-4).filename() == "along_x_t0.0002.csv");
  CHECK(fixtures::files_in(folder.path()) == Names{"ice/run 1/files.txt"});
}

TEST_CASE("results: a list of files contains frames by number, partial files, and nothing outside the folder") {
  FileList list = list_of({"run.json", "lines/a_t1.csv"});
  list.add_frames("frames/plate", 41);
  list.add_frames("frames/plate_2", 100000);
  for (const char* name : {"run.json", "run.json.part", "lines/a_t1.csv", "frames/plate_00000.vtp", "frames/plate_00041.vtp", "frames/plate_00041.vtp.part",
                           "frames/plate_2_100000.vtp"})
    CHECK_MESSAGE(list.contains(name), name);
  for (const char* name : {"history.csv", "a_t1.csv", "frames/plate_00042.vtp", "frames/plate_41.vtp", "frames/plate_000041.vtp", "frames/plate_-0001.vtp",
                           "frames/plate_.vtp", "frames/hull_00000.vtp", "frames/plate_00000.vtp.bak", "plate_00000.vtp", "run.json.part.part"})
    CHECK_MESSAGE(!list.contains(name), name);

  const TemporaryFolder folder;
  list.write_to(folder.path());
  const FileList read = FileList::of(folder.path());
  CHECK(read.files() == list.files());
  CHECK(read.contains("frames/plate_00041.vtp"));
  CHECK(!read.contains("frames/plate_00042.vtp"));
  CHECK(read.contains("frames/plate_2_100000.vtp"));

  fixtures::put(folder / "files.txt", "../a.csv\n/b.csv\nfrones/../../c.csv\n./d.csv\nok.csv\n");
  CHECK(FileList::of(folder.path()).files() == Names{"ok.csv"});
}

TEST_CASE("results: the files that a run has listed are removed, everything else is kept") {
  const TemporaryFolder folder;
  const Names ours = {
      "run.json", "run.json.part", "history.csv", "checkpoint.h5", "lines/a_t5e-05.csv", "frames/plate_00001.vtp", "frames/plate_00002.vtp.part"};
  const Names foreign = {"notes.txt", "history.csv.bak", "check/plate.vtp", "lines/reference.csv", "frames/plate_00003.vtp", "frames/sub/plate_00001.vtp"};
  FileList list = list_of({"run.json", "history.csv", "checkpoint.h5", "lines/a_t5e-05.csv"});
  list.add_frames("frames/plate", 2);
  for (const Names& names : {ours, foreign})
    for (const std::string& name : names) fixtures::put(folder / name, "x");
  list.write_to(folder.path());
  const ResultsFolder results(folder.path(), list_of({"run.json"}));
  Names left = foreign;
  left.insert("files.txt");
  CHECK(fixtures::files_in(folder.path()) == left);
  CHECK(FileList::of(folder.path()).files() == Names{"run.json"});
}

TEST_CASE("results: a file that no run has listed is not replaced, and refused before anything is changed") {
  const TemporaryFolder folder;
  list_of({"run.json"}).write_to(folder.path());
  for (const char* name : {"run.json", "history.csv"}) fixtures::put(folder / name, "x");
  CHECK_THROWS_WITH_AS(ResultsFolder(folder.path(), list_of({"run.json", "history.csv"})),
                       ((folder / "history.csv").string() + " would be replaced, but " + (folder / "files.txt").string() +
                        " does not list it as a file of a run; move it, or choose another folder with --out or output.folder.")
                           .c_str(),
                       fccda::InputError);
  CHECK(fixtures::files_in(folder.path()) == Names{"files.txt", "history.csv", "run.json"});
}

TEST_CASE("results: an unusable folder is an input error before anything is computed") {
  const TemporaryFolder folder;
  fixtures::put(folder / "file", "x");
  CHECK_THROWS_WITH_AS(ResultsFolder(folder / "file/run", FileList()),
                       ("results cannot be written to the folder " + (folder / "file/run").string() +
                        ": Not a directory. Choose another one with --out, or with output.folder in the deck.")
                           .c_str(),
                       fccda::InputError);
  CHECK_THROWS_AS(prepare_folder("/proc"), fccda::InputError);                      // exists, but is not writable even for root
  CHECK_THROWS_AS(ResultsFolder("/proc/self/run", FileList()), fccda::InputError);  // cannot be created
}

TEST_CASE("results: an unusable folder keeps the earlier run") {
  const TemporaryFolder folder;
  list_of({"run.json"}).write_to(folder.path());
  fixtures::put(folder / "run.json", "earlier");
  fixtures::put(folder / "lines", "a file where a folder must be");
  CHECK_THROWS_AS(ResultsFolder(folder.path(), FileList()), fccda::InputError);
  CHECK(fixtures::text_of(folder / "run.json") == "earlier");
}

TEST_CASE("results: a restart keeps the files of the earlier run, except partial ones and those that it discards") {
  const TemporaryFolder folder;
  const Names listed = {"history.csv", "checkpoint.h5", "lines/a_t1.csv", "lines/a_t2.csv", "run.json"};
  const Names kept = {"history.csv", "checkpoint.h5", "lines/a_t1.csv", "notes.part", "files.txt"};
  list_of(listed).write_to(folder.path());
  for (const Names& names : {listed, Names{"checkpoint.h5.part", "notes.part"}})
    for (const std::string& name : names) fixtures::put(folder / name, "x");
  const ResultsFolder results(folder.path(), list_of({"run.json", "lines/a_t3.csv"}), list_of({"run.json", "lines/a_t2.csv"}));
  CHECK(fixtures::files_in(folder.path()) == kept);
  CHECK(FileList::of(folder.path()).contains("lines/a_t3.csv"));
  CHECK(FileList::of(folder.path()).contains("history.csv"));
}
