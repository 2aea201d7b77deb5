#include <doctest/doctest.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "fixtures/file_size_limit.hpp"
#include "fixtures/temporary_folder.hpp"
#include "io/checkpoint/arrays_reader.hpp"
#include "io/checkpoint/arrays_writer.hpp"

using namespace perimpact::checkpoint;

namespace {

/// An owner of state with every form and type of numbers.
struct Owner {
  std::vector<double> fixed{0.1, -0.0, std::numeric_limits<double>::infinity(), 5e-324};
  std::vector<std::uint64_t> list{1, std::numeric_limits<std::uint64_t>::max(), 3};
  std::vector<int> none{};
  std::vector<float> floats{1.5f};
  std::vector<std::uint8_t> bits{0, 255, 7};
  long step = -12;
  std::uint32_t number = 4'000'000'000;
  double energy = 1 / 3.0;

  template <class Visitor>
  void visit_state(Visitor&& visit) {
    visit("fixed", std::span<double>(fixed));
    visit("list", list);
    visit("none", none);
    visit("floats", floats);
    visit("group/bits", std::span<std::uint8_t>(bits));
    visit("step", step);
    visit("number", number);
    visit("energy", energy);
  }
  bool operator==(const Owner&) const = default;
};

const std::string setup = "{\"title\": \"Eis ∅\"}\n";

void write(const std::filesystem::path& path, Owner owner) {
  ArraysWriter file(path);
  file.text("setup", setup);
  owner.visit_state(file);
  file.word("program", "perimpact 9.8.7");
  file.number("steps", std::int64_t{1200});
  file.number("hash", std::uint64_t{0xffffffffffffffff});
  file.number("time [s]", 1e-7);
  file.finish();
}

/// The contents of the file, read into an owner with different values.
Owner read(const std::filesystem::path& path) {
  ArraysReader file(path);
  Owner owner{{0, 0, 0, 0}, {9}, {9, 9}, {}, {0, 0, 0}, 0, 0, 0};
  const std::string text = file.text("setup");
  owner.visit_state(file);
  const std::string program = file.word("program");
  const bool facts = file.integer("steps") == 1200 && file.natural("hash") == 0xffffffffffffffff && file.number("time [s]") == 1e-7;
  CHECK(facts);
  CHECK(text == setup);
  CHECK(program == "perimpact 9.8.7");
  file.expect_all_read();
  return owner;
}

std::string complaint(const std::function<void()>& f) {
  try {
    f();
  } catch (const fccda::InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("checkpoint file: numbers of every type and form are restored bitwise, lists with their length") {
  const fixtures::TemporaryFolder folder;
  write(folder / "c.h5", {});
  const Owner back = read(folder / "c.h5");
  CHECK(back == Owner{});
  CHECK(std::signbit(back.fixed[1]));
  CHECK(fixtures::files_in(folder.path()) == std::set<std::string>{"c.h5"});
}

TEST_CASE("checkpoint file: a file truncated at any byte is refused") {
  const fixtures::TemporaryFolder folder;
  write(folder / "c.h5", {});
  for (std::uintmax_t size = std::filesystem::file_size(folder / "c.h5"); size-- > 0;) {
    std::filesystem::resize_file(folder / "c.h5", size);
    CAPTURE(size);
    REQUIRE(complaint([&] { read(folder / "c.h5"); }).find("c.h5 is damaged") != std::string::npos);
  }
}

TEST_CASE("checkpoint file: a changed byte is refused, or has no effect") {
  const fixtures::TemporaryFolder folder;
  write(folder / "c.h5", {});
  const std::string whole = fixtures::text_of(folder / "c.h5");
  std::mt19937 random(1);
  std::size_t refused = 0;
  std::fstream file(folder / "c.h5", std::ios::in | std::ios::out | std::ios::binary);
  const auto put = [&](std::size_t at, char byte) { file.seekp(static_cast<std::streamoff>(at)).put(byte).flush(); };
  for (std::size_t at = 0; at < whole.size(); at += at < 1000 ? 1 : 1 + random() % 5) {  // the first thousand bytes locate the rest
    put(at, static_cast<char>(static_cast<unsigned char>(whole[at]) ^ (1 + random() % 255)));
    CAPTURE(at);
    Owner back;
    const std::string message = complaint([&] { back = read(folder / "c.h5"); });
    REQUIRE(back == Owner{});
    if (!message.empty()) ++refused;
    put(at, whole[at]);
  }
  CHECK(refused > 1000);  // the rest is unused space of HDF5
}

TEST_CASE("checkpoint file: other names, types, lengths and numbers of arrays are refused with a sentence") {
  const fixtures::TemporaryFolder folder;
  write(folder / "c.h5", {});
  const auto message = [&](const auto& use) {
    return complaint([&] {
      ArraysReader file(folder / "c.h5");
      use(file);
    });
  };
  const std::string begin = (folder / "c.h5").string() + " is damaged or of another run: ",
                    end = ". Restore an intact copy, or start a new run without --resume.";
  std::vector<double> two(2);
  std::vector<float> floats;
  CHECK(message([&](auto& file) { file("other", floats); }) == begin + "the array other is missing" + end);
  CHECK(message([&](auto& file) { file("list", floats); }) == begin + "the array list has another number type than expected" + end);
  CHECK(message([&](auto& file) { file("fixed", std::span<double>(two)); }) == begin + "the array fixed has another length than expected" + end);
  CHECK(message([&](auto& file) { file.expect_all_read(); }) == begin + "it contains other arrays than expected" + end);
  CHECK(message([&](auto& file) { file.natural("steps"); }) == begin + "steps is missing" + end);  // it exists, but signed
  CHECK(message([&](auto& file) { file.word("steps"); }) == begin + "steps is missing" + end);
  CHECK(message([&](auto& file) { file.text("fixed"); }) == begin + "fixed is not a text" + end);
}

TEST_CASE("checkpoint file: on a full disk the earlier file remains, the message says so, and the next one can be written") {
  const fixtures::TemporaryFolder folder;
  const auto path = folder / "c.h5";
  Owner earlier, large;
  earlier.energy = 7;
  large.list.resize(10'000, 5);
  write(path, earlier);
  for (const rlim_t room : {0, 100, 3000, 40'000, 80'000}) {
    const fixtures::FileSizeLimit limit(room);
    CHECK_THROWS_WITH_AS(
        write(path, large),
        (path.string() + " cannot be written: File too large. Raise the limit on file sizes (ulimit -f) and run again; everything written before is intact.")
            .c_str(),
        fccda::RunError);
    CHECK(fixtures::files_in(folder.path()) == std::set<std::string>{"c.h5"});
    CHECK(read(path) == earlier);
  }
  write(path, large);
  CHECK(read(path) == large);
}

TEST_CASE("checkpoint file: an unfinished file leaves no trace") {
  const fixtures::TemporaryFolder folder;
  {
    Owner owner;
    ArraysWriter file(folder / "c.h5");
    owner.visit_state(file);
    CHECK(fixtures::files_in(folder.path()) == std::set<std::string>{"c.h5.part"});
  }
  CHECK(fixtures::files_in(folder.path()).empty());
}
