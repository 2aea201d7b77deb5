#include "io/frames/vtkhdf.hpp"

#include <doctest/doctest.h>
#include <hdf5.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <fstream>
#include <random>

#include "base/error.hpp"
#include "fixtures/file_size_limit.hpp"
#include "fixtures/temporary_folder.hpp"
#include "io/frames/frame.hpp"
#include "io/frames/read_vtkhdf.hpp"
#include "io/hdf5/staged.hpp"
#include "io/output/file.hpp"

using namespace perimpact;
using namespace perimpact::frames;

namespace {

/// Particles, or the panels of a surface, with random numbers in every array of each step.
struct Numbers {
  std::vector<float> points, vectors, made;
  std::vector<std::int32_t> fragments, original;
  std::vector<double> vertices, pressure;
  std::vector<std::array<int, 4>> panels;

  Numbers(std::size_t count, unsigned step) {
    std::mt19937 chance(1 + step), same(0);
    const auto fill = [&](auto& numbers, std::size_t length) {
      numbers.resize(length);
      for (auto& number : numbers) number = static_cast<std::remove_reference_t<decltype(number)>>(static_cast<double>(chance()) - 2e9);
    };
    fill(points, 3 * count), fill(vectors, 3 * count), fill(made, count), fill(fragments, count), fill(vertices, 3 * count), fill(pressure, count / 2);
    original.resize(count);
    for (std::int32_t& number : original) number = static_cast<std::int32_t>(same() >> 1);
    for (std::size_t p = 0; p < count / 2; ++p) {
      const int at = static_cast<int>(p);
      panels.push_back({at, at + 1, at + 2, p % 3 == 0 && p + 3 < count ? at + 3 : -1});
    }
  }
  output::PolyData particles(bool varies = false) const {
    return {.points = std::span(points),
            .point_arrays = {{"velocity", 3, std::span(vectors)},
                             {"damage", 1, output::MadeFloats{made.size(), [this] { return made; }}},
                             {"fragment", 1, std::span(fragments)},
                             {"original", 1, std::span(original), !varies}},
            .varies = varies};
  }
  output::PolyData surface() const { return {.points = std::span(vertices), .panels = panels, .cell_arrays = {{"pressure", 1, std::span(pressure)}}}; }
};

/// The number of particles in the steps of a series: one number, or with each step another one, from none to several chunks.
struct Count {
  std::size_t always = 0;
  bool varies = false;

  Count(std::size_t count) : always(count) {}  // NOLINT: a number is a count
  explicit Count(bool it_varies) : varies(it_varies) {}

  std::size_t of(std::size_t step) const {
    constexpr std::size_t counts[] = {3, 0, 50, 8191, 8192, 20000, 1};
    return varies ? counts[step % std::size(counts)] : always;
  }
  Numbers numbers(std::size_t step) const { return {of(step), static_cast<unsigned>(step)}; }
};
const Count varying(true);

template <class T>
bool same(const std::vector<double>& found, const std::vector<T>& wanted) {
  return std::ranges::equal(found, wanted,
                            [](double a, T b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(static_cast<double>(b)); });
}

std::vector<double> places(const Frame& frame) {
  std::vector<double> numbers;
  for (const fccda::Vec3d& point : frame.points) numbers.insert(numbers.end(), {point.x, point.y, point.z});
  return numbers;
}

bool holds_particles(const std::filesystem::path& file, unsigned step, const Count& count) {
  const Frame found = read_vtkhdf(file, step);
  const Numbers wanted = count.numbers(step);
  return found.panels.empty() && found.arrays.size() == 4 && found.arrays[0].name == "velocity" && same(places(found), wanted.points) &&
         same(found.find("velocity")->numbers, wanted.vectors) && same(found.find("damage")->numbers, wanted.made) &&
         same(found.find("fragment")->numbers, wanted.fragments) && same(found.find("original")->numbers, wanted.original);
}

bool holds_surface(const std::filesystem::path& file, unsigned step, std::size_t count) {
  const Frame found = read_vtkhdf(file, step);
  const Numbers wanted(count, step);
  return found.panels == wanted.panels && same(places(found), wanted.vertices) && found.arrays.size() == 1 &&
         same(found.find("pressure")->numbers, wanted.pressure);
}

std::vector<double> times(std::size_t count) {
  std::vector<double> out;
  for (std::size_t k = 0; k < count; ++k) out.push_back(0.1 * static_cast<double>(k));
  return out;
}

/// A series of particles with steps 0 … last.
void write(const std::filesystem::path& file, const Count& count, std::size_t steps, std::size_t from = 0) {
  VtkhdfSeries series(file, times(from));
  for (std::size_t step = from; step < steps; ++step) series.add(count.numbers(step).particles(count.varies), 0.1 * static_cast<double>(step));
}

/// Number of entries of a data set.
hsize_t length_of(const std::filesystem::path& file, const char* name) {
  const hid_t opened = H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), array = H5Dopen2(opened, name, H5P_DEFAULT), space = H5Dget_space(array);
  hsize_t extent[2] = {};
  H5Sget_simple_extent_dims(space, extent, nullptr);
  H5Sclose(space), H5Dclose(array), H5Fclose(opened);
  return extent[0];
}

/// The bytes of a file, and each change of them in turn.
class Recorded final : public hdf5::Storage {
 public:
  explicit Recorded(const std::filesystem::path& file) {
    const std::string text = fixtures::text_of(file);
    bytes.resize(text.size());
    std::memcpy(bytes.data(), text.data(), text.size());
  }
  void write_at(std::uint64_t offset, std::span<const std::byte> given) override {
    states.push_back(bytes);
    if (offset + given.size() > bytes.size()) bytes.resize(offset + given.size());
    std::ranges::copy(given, bytes.begin() + static_cast<std::ptrdiff_t>(offset));
    largest_changed_page = std::max<std::uint64_t>(largest_changed_page, offset < hdf5::StagedStorage::page ? offset + given.size() : 0);
  }
  void read_at(std::uint64_t offset, std::span<std::byte> into) const override {
    std::copy_n(bytes.begin() + static_cast<std::ptrdiff_t>(offset), into.size(), into.begin());
  }
  void resize(std::uint64_t size) override {
    states.push_back(bytes);
    bytes.resize(size);
  }
  std::uint64_t size() const override { return bytes.size(); }
  void sync() override {}

  std::vector<std::byte> bytes;
  std::vector<std::vector<std::byte>> states;  ///< before each change
  std::uint64_t largest_changed_page = 0;
};

void put(const std::filesystem::path& file, const std::vector<std::byte>& bytes) {
  std::ofstream(file, std::ios::binary).write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

}  // namespace

TEST_CASE("vtkhdf: every number of every step is read back, of one particle and of several chunks") {
  const fixtures::TemporaryFolder folder;
  for (const std::size_t count : {std::size_t{1}, std::size_t{2000}, std::size_t{70001}}) {
    const std::filesystem::path file = folder / "plate.vtkhdf";
    write(file, count, 3);
    CHECK(times_of_vtkhdf(file) == times(3));
    for (unsigned step = 0; step < 3; ++step) CHECK(holds_particles(file, step, count));
    std::filesystem::remove(file);
  }
}

TEST_CASE("vtkhdf: panels of three and four corners are read back, with their arrays") {
  const fixtures::TemporaryFolder folder;
  VtkhdfSeries series(folder / "hull.vtkhdf", {});
  for (unsigned step = 0; step < 3; ++step) series.add(Numbers(2501, step).surface(), 0.1 * step);
  for (unsigned step = 0; step < 3; ++step) CHECK(holds_surface(folder / "hull.vtkhdf", step, 2501));
}

TEST_CASE("vtkhdf: cells and constant arrays are stored once, whatever the number of steps") {
  const fixtures::TemporaryFolder folder;
  const std::filesystem::path file = folder / "plate.vtkhdf";
  write(file, 2000, 300);
  CHECK(length_of(file, "VTKHDF/Vertices/Connectivity") == 2000);
  CHECK(length_of(file, "VTKHDF/PointData/original") == 2000);
  CHECK(length_of(file, "VTKHDF/PointData/damage") == 300 * 2000);
  for (const unsigned step : {0U, 1U, 127U, 128U, 299U}) CHECK(holds_particles(file, step, 2000));  // beyond one chunk of the offsets
}

TEST_CASE("vtkhdf: every number is read back where the number of particles varies, with steps of none and of several chunks") {
  const fixtures::TemporaryFolder folder;
  const std::filesystem::path file = folder / "plate.vtkhdf";
  write(file, varying, 140);  // beyond one chunk of the offsets
  CHECK(times_of_vtkhdf(file) == times(140));
  for (unsigned step = 0; step < 140; ++step) CHECK(holds_particles(file, step, varying));
}

/// Repeats every single write of the step that follows `steps`, and requires the earlier ones to be there each time, and the run to be resumable.
void check_every_write(const std::filesystem::path& folder, const Count& count, std::size_t steps) {
  const std::filesystem::path file = folder / "plate.vtkhdf", cut = folder / "cut.vtkhdf";
  write(file, count, steps);
  Recorded storage(file);
  append_vtkhdf(storage, "plate", count.numbers(steps).particles(count.varies), 0.1 * static_cast<double>(steps));
  CHECK(storage.largest_changed_page <= hdf5::StagedStorage::page);
  CHECK(storage.states.size() > 20);
  for (const std::vector<std::byte>& state : storage.states) {
    put(cut, state);
    CHECK(times_of_vtkhdf(cut) == times(steps));
    CHECK(length_of(cut, "VTKHDF/Steps/Values") == steps);  // VTK copies them all
    for (std::size_t step = 0; step < steps; step += std::max<std::size_t>(1, steps / 4)) CHECK(holds_particles(cut, static_cast<unsigned>(step), count));
    CHECK(holds_particles(cut, static_cast<unsigned>(steps - 1), count));
    write(cut, count, steps + 2, steps);
    CHECK(times_of_vtkhdf(cut) == times(steps + 2));
    for (std::size_t step = steps - 1; step < steps + 2; ++step) CHECK(holds_particles(cut, static_cast<unsigned>(step), count));
  }
  put(cut, storage.bytes);
  CHECK(times_of_vtkhdf(cut) == times(steps + 1));
  CHECK(holds_particles(cut, static_cast<unsigned>(steps), count));
  std::filesystem::remove(file);
}

TEST_CASE("vtkhdf: after every single write of a step the file holds the earlier steps, and can be resumed") {
  const fixtures::TemporaryFolder folder;
  for (const std::size_t steps : {1, 4, 5, 40, 128}) check_every_write(folder.path(), 50, steps);  // with more of them, the indices of chunks grow
}

TEST_CASE("vtkhdf: where the number of particles varies, after every single write of a step the file holds the earlier steps, and can be resumed") {
  const fixtures::TemporaryFolder folder;
  for (const std::size_t steps : {1, 2, 5, 128}) check_every_write(folder.path(), varying, steps);
}

TEST_CASE("vtkhdf: while later steps are removed, the file can be read after every single write") {
  const fixtures::TemporaryFolder folder;
  const std::filesystem::path file = folder / "plate.vtkhdf", cut = folder / "cut.vtkhdf";
  constexpr std::size_t steps = 30, kept = 7;
  for (const Count& count : {Count(std::size_t{500}), varying}) {
    write(file, count, steps);
    Recorded storage(file);
    truncate_vtkhdf(storage, "plate", kept);
    CHECK(storage.bytes.size() < storage.states.front().size());  // an index of chunks among the removed steps keeps what lies before it
    for (const std::vector<std::byte>& state : storage.states) {
      put(cut, state);
      const std::size_t there = times_of_vtkhdf(cut).size();
      CHECK((there == steps || there == kept));
      CHECK(length_of(cut, "VTKHDF/Steps/Values") == there);
      for (std::size_t step = 0; step < kept; ++step) CHECK(holds_particles(cut, static_cast<unsigned>(step), count));
    }
    put(cut, storage.bytes);
    write(cut, count, steps, kept);
    CHECK(times_of_vtkhdf(cut) == times(steps));
    for (unsigned step = 0; step < steps; ++step) CHECK(holds_particles(cut, step, count));
    std::filesystem::remove(file);
  }
}

TEST_CASE("vtkhdf: on a full disk the step is refused in a sentence, and the file is as it was") {
  const fixtures::TemporaryFolder folder;
  const std::filesystem::path file = folder / "plate.vtkhdf";
  write(file, 2000, 3);
  const std::string before = fixtures::text_of(file);
  VtkhdfSeries series(file, times(3));
  for (const std::size_t room : {1, 4096, 40000}) {
    const fixtures::FileSizeLimit limit(before.size() + room);
    CHECK_THROWS_WITH_AS(
        series.add(Numbers(2000, 3).particles(), 0.3),
        (file.string() + " cannot be written: File too large. Raise the limit on file sizes (ulimit -f) and run again; everything written before is intact.")
            .c_str(),
        fccda::RunError);
    CHECK(times_of_vtkhdf(file) == times(3));
    CHECK(std::filesystem::file_size(file) <= before.size());
  }
  series.add(Numbers(2000, 3).particles(), 0.3);
  for (unsigned step = 0; step < 4; ++step) CHECK(holds_particles(file, step, 2000));
}

TEST_CASE("vtkhdf: a file that is missing, cut or of something else is refused in a sentence") {
  const fixtures::TemporaryFolder folder;
  const std::filesystem::path file = folder / "plate.vtkhdf";
  const auto said = [&] {
    try {
      read_vtkhdf(file, times_of_vtkhdf(file).size() - 1);
    } catch (const fccda::InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  const std::string use = "; use the file as written by the run.", name = file.string();
  CHECK(said() == name + " cannot be read: No such file or directory" + use);
  fixtures::put(file, "nothing");
  CHECK(said() == name + " is damaged: it is not a complete HDF5 file" + use);
  std::filesystem::remove(file);
  write(file, 2000, 3);
  CHECK(said().empty());
  const std::string whole = fixtures::text_of(file);
  fixtures::put(file, whole.substr(0, whole.size() - 1));
  CHECK(said() == name + " is damaged: it is not a complete HDF5 file" + use);
  std::mt19937 chance(5);
  for (int scene = 0; scene < 300; ++scene) {  // any damage: a sentence, or numbers
    std::string damaged = whole;
    for (int k = 0; k < 3; ++k) damaged[chance() % damaged.size()] = static_cast<char>(chance());
    fixtures::put(file, damaged);
    const std::string words = said();
    CHECK((words.empty() || (words.starts_with(name) && words.ends_with(use))));
  }
}
