#include "io/output/file.hpp"

#include <doctest/doctest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <span>
#include <string>

#include "base/error.hpp"
#include "fixtures/file_size_limit.hpp"
#include "fixtures/temporary_folder.hpp"
#include "io/output/csv.hpp"

using namespace perimpact::output;
using fixtures::FileSizeLimit;
using fixtures::TemporaryFolder;
using fixtures::text_of;

namespace {

/// The message of the error that the action throws.
template <class Action>
std::string complaint(const Action& action) {
  try {
    action();
  } catch (const fccda::RunError& error) {
    return error.what();
  }
  return "nothing";
}

}  // namespace

TEST_CASE("file: an earlier file of the same name remains until the new one is finished") {
  const TemporaryFolder folder;
  write_whole_file(folder / "run.json", "old");
  {
    WholeFile file(folder / "run.json");
    file.write("new");
    CHECK(text_of(folder / "run.json") == "old");
    file.finish();
    CHECK(text_of(folder / "run.json") == "new");
  }
  WholeFile(folder / "run.json").write("never finished");
  CHECK(text_of(folder / "run.json") == "new");
  CHECK(fixtures::files_in(folder.path()) == std::set<std::string>{"run.json"});
}

TEST_CASE("file: a process killed while writing leaves the earlier file intact") {
  const TemporaryFolder folder;
  write_whole_file(folder / "frame.vtp", "old");
  const pid_t child = fork();
  if (child == 0) {
    WholeFile file(folder / "frame.vtp");
    file.write("ne");
    raise(SIGKILL);
  }
  int status = 0;
  REQUIRE(waitpid(child, &status, 0) == child);
  REQUIRE(WIFSIGNALED(status));
  CHECK(text_of(folder / "frame.vtp") == "old");
  CHECK(text_of(folder / "frame.vtp.part") == "ne");
}

TEST_CASE("file: on a full disk the earlier file remains, no partial file is left, and the message gives the reason") {
  const TemporaryFolder folder;
  write_whole_file(folder / "frame.vtp", "old");
  std::string message;
  {
    const FileSizeLimit limit(5000);
    message = complaint([&] { write_whole_file(folder / "frame.vtp", std::string(5001, 'x')); });
    CHECK(complaint([&] { write_whole_file(folder / "other.vtp", std::string(5000, 'x')); }) == "nothing");
  }
  CHECK(message == (folder / "frame.vtp").string() +
                       " cannot be written: File too large. Raise the limit on file sizes (ulimit -f) and run again; everything written before is intact.");
  CHECK(text_of(folder / "frame.vtp") == "old");
  CHECK(fixtures::files_in(folder.path()) == std::set<std::string>{"frame.vtp", "other.vtp"});
}

TEST_CASE("file: a full disk is reported as such") {
  const TemporaryFolder folder;
  std::filesystem::create_symlink("/dev/full", folder / "run.json.part");  // writes to it fail as on a full disk
  CHECK(complaint([&] { write_whole_file(folder / "run.json", "{}"); }) ==
        (folder / "run.json").string() + " cannot be written: No space left on device. Free disk space and run again; everything written before is intact.");
  CHECK(fixtures::files_in(folder.path()).empty());
  CHECK(complaint([&] { GrowingFile("/dev/full").append("1,2\n"); }) ==
        "/dev/full cannot be written: No space left on device. Free disk space and run again; everything written before is intact.");
}

TEST_CASE("file: a missing folder is reported as such") {
  const TemporaryFolder folder;
  CHECK(complaint([&] { write_whole_file(folder / "gone/run.json", "{}"); }) ==
        (folder / "gone/run.json").string() +
            " cannot be written: No such file or directory. Its folder does not exist (any more): do not move or delete the results during a run.");
}

TEST_CASE("csv: a row that does not fit is removed, and the rows before it remain") {
  const TemporaryFolder folder;
  const std::vector<std::string> columns = {"time [s]", "total.energy [J]"};
  const std::string whole = "time [s],total.energy [J]\n0.5,1.25\n";
  {
    CsvWriter table(folder / "history.csv", columns);
    table.append(std::vector{0.5, 1.25});
    const FileSizeLimit limit(whole.size() + 3);  // the next row is truncated after three bytes
    CHECK(complaint([&] { table.append(std::vector{0.75, 1.25}); }) != "nothing");
    CHECK(text_of(folder / "history.csv") == whole);
  }
  CHECK(text_of(folder / "history.csv") == whole);
}

TEST_CASE("csv: a killed run keeps every row, and each number reads back to the same double") {
  const TemporaryFolder folder;
  const std::vector<double> row = {1.0 / 3, -4.815162342e-300, 1e22, 200e-6};
  const pid_t child = fork();
  if (child == 0) {
    CsvWriter table(folder / "history.csv", std::vector<std::string>{"a", "b", "c", "d"});
    table.append(row);
    raise(SIGKILL);
  }
  waitpid(child, nullptr, 0);
  std::istringstream lines(text_of(folder / "history.csv"));
  std::string header, cell;
  std::getline(lines, header);
  CHECK(header == "a,b,c,d");
  for (const double value : row) {
    std::getline(lines, cell, value == row.back() ? '\n' : ',');
    CHECK(std::stod(cell) == value);
  }
  CHECK(lines.peek() == std::char_traits<char>::eof());
}

TEST_CASE("csv: names with commas and quotes remain one column") {
  const TemporaryFolder folder;
  write_csv(folder / "line.csv", std::vector<std::string>{"at 0,0 \"centre\" [m]", "b"}, std::vector{1.0, 2.0, 3.0, 4.5});
  CHECK(text_of(folder / "line.csv") == "\"at 0,0 \"\"centre\"\" [m]\",b\n1,2\n3,4.5\n");
}

TEST_CASE("file: a growing file can be resumed after its first bytes") {
  const fixtures::TemporaryFolder folder;
  fixtures::put(folder / "t.csv", "first\nsecond\nhal");
  GrowingFile file(folder / "t.csv", 6);
  CHECK(fixtures::text_of(folder / "t.csv") == "first\n");
  file.append("other\n");
  file.sync();
  CHECK(file.size() == 12);
  CHECK(fixtures::text_of(folder / "t.csv") == "first\nother\n");
  CHECK_THROWS_AS(GrowingFile(folder / "none.csv", 0), fccda::RunError);
}

TEST_CASE("file: bytes can be written and read at any offset, and the end truncated") {
  const fixtures::TemporaryFolder folder;
  const auto bytes = [](std::string_view text) { return std::as_bytes(std::span(text)); };
  WholeFile file(folder / "f");
  file.write_at(3, bytes("def"));
  file.write_at(0, bytes("abc"));
  std::array<std::byte, 2> read{};
  file.read_at(2, read);
  CHECK(std::to_integer<char>(read[0]) == 'c');
  CHECK(std::to_integer<char>(read[1]) == 'd');
  CHECK_THROWS_AS(file.read_at(5, read), fccda::RunError);
  file.resize(4);
  file.finish();
  CHECK(fixtures::text_of(folder / "f") == "abcd");
}
