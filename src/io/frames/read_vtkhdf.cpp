#include "io/frames/read_vtkhdf.hpp"

#include <fcntl.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

#include "base/error.hpp"
#include "io/hdf5/handle.hpp"
#include "io/output/file.hpp"

namespace perimpact::frames {

namespace {

using hdf5::Handle;

constexpr int most_components = 9;

class Reader {
 public:
  explicit Reader(const std::filesystem::path& path) : file_(path.string()) {
    const output::Descriptor readable(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
    if (!readable.is_open()) throw fccda::InputError(fmt::format("{} cannot be read: {}; use the file as written by the run.", file_, std::strerror(errno)));
    const Handle access = hdf5::file_access(H5F_LIBVER_V110);
    opened_ = Handle(H5Fopen(path.c_str(), H5F_ACC_RDONLY, access.id()), H5Fclose);
    expect(opened_.is_open(), "it is not a complete HDF5 file");
    size_ = std::filesystem::file_size(path);
  }

  std::vector<double> times() const {
    const Handle attribute(H5Aopen_by_name(opened_.id(), "VTKHDF/Steps", "NSteps", H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    const Handle space(attribute.is_open() ? H5Aget_space(attribute.id()) : -1, H5Sclose);
    std::int64_t steps = 0;
    expect(space.is_open() && H5Sget_simple_extent_npoints(space.id()) == 1 && H5Aread(attribute.id(), H5T_NATIVE_INT64, &steps) >= 0 && steps > 0,
           "it has no time steps");
    return rows<double>("Steps/Values", 0, static_cast<std::uint64_t>(steps));
  }

  Frame step(std::size_t number) const {
    const std::uint64_t part = entry("Steps/PartOffsets", number);
    const std::uint64_t points = entry("NumberOfPoints", part), cells = entry("Polygons/NumberOfCells", part);
    Frame frame;
    const std::vector<double> places = rows<double>("Points", entry("Steps/PointOffsets", number), points, 3);
    for (std::size_t k = 0; k < places.size(); k += 3) frame.points.push_back({places[k], places[k + 1], places[k + 2]});
    if (cells > 0) frame.panels = panels(number, part, points, cells);
    frame.arrays = arrays(cells > 0 ? "CellData" : "PointData", number, cells > 0 ? cells : points);
    if (cells > 0) frame.vertex_arrays = arrays("PointData", number, points);
    return frame;
  }

 private:
  void expect(bool sound, std::string_view what) const {
    if (!sound) throw fccda::InputError(fmt::format("{} is damaged: {}; use the file as written by the run.", file_, what));
  }

  Handle dataset(const std::string& name) const {
    Handle found(H5Dopen2(opened_.id(), ("VTKHDF/" + name).c_str(), H5P_DEFAULT), H5Dclose);
    expect(found.is_open(), "it has no " + name);
    return found;
  }

  /// Rows and columns.
  std::array<hsize_t, 2> extent_of(const Handle& dataset, const std::string& name) const {
    const Handle space(H5Dget_space(dataset.id()), H5Sclose);
    std::array<hsize_t, 2> extent{0, 1};
    const int rank = H5Sget_simple_extent_ndims(space.id());
    expect((rank == 1 || rank == 2) && H5Sget_simple_extent_dims(space.id(), extent.data(), nullptr) >= 0 && extent[1] >= 1 && extent[1] <= most_components,
           name + " has other dimensions than expected");
    return extent;
  }

  hsize_t columns_of(const std::string& name) const { return extent_of(dataset(name), name)[1]; }

  template <class Number>
  std::vector<Number> rows(const std::string& name, std::uint64_t first, std::uint64_t count, hsize_t columns = 1) const {
    const Handle array = dataset(name);
    const std::array<hsize_t, 2> extent = extent_of(array, name);
    // before memory is allocated; deflate packs at most 1032 bytes into one
    expect(extent[1] == columns && first <= extent[0] && count <= extent[0] - first && count / 1032 <= size_, name + " is shorter than its offsets say");
    std::vector<Number> numbers(count * columns);
    const hsize_t start[] = {first, 0}, counts[] = {count, columns}, length = numbers.size();
    const Handle memory(H5Screate_simple(1, &length, nullptr), H5Sclose), space(H5Dget_space(array.id()), H5Sclose);
    expect(count == 0 || (H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, start, nullptr, counts, nullptr) >= 0 &&
                          H5Dread(array.id(), hdf5::type_in_memory(hdf5::number_type<Number>()), memory.id(), space.id(), H5P_DEFAULT, numbers.data()) >= 0),
           name + " cannot be read");
    return numbers;
  }

  std::uint64_t entry(const std::string& name, std::uint64_t row, std::uint64_t column = 0) const {
    const hsize_t columns = columns_of(name);
    const std::vector<std::int64_t> numbers = rows<std::int64_t>(name, row, 1, columns);
    expect(column < columns && numbers[column] >= 0, name + " has a negative number");
    return static_cast<std::uint64_t>(numbers[column]);
  }

  /// All arrays of a group at a step, with `count` tuples.
  std::vector<FrameArray> arrays(const std::string& group, std::size_t step, std::uint64_t count) const {
    std::vector<FrameArray> found;
    for (const std::string& name : names_in(group)) {
      const std::string array = group + "/" + name;
      const hsize_t components = columns_of(array);
      found.push_back({name, static_cast<int>(components), rows<double>(array, entry("Steps/" + group + "Offsets/" + name, step), count, components)});
    }
    return found;
  }

  std::vector<std::array<int, 4>> panels(std::size_t number, std::uint64_t part, std::uint64_t points, std::uint64_t cells) const {
    constexpr std::uint64_t polygons = 2;  // column of the offsets
    const std::uint64_t first = entry("Steps/CellOffsets", number, polygons), id = entry("Steps/ConnectivityIdOffsets", number, polygons);
    std::vector<std::int64_t> ends = rows<std::int64_t>("Polygons/Offsets", first + part, cells + 1);
    ends.erase(ends.begin());
    const std::vector<std::int64_t> corners = rows<std::int64_t>("Polygons/Connectivity", id, entry("Polygons/NumberOfConnectivityIds", part));
    return panels_of(corners, ends, points, file_);
  }

  std::vector<std::string> names_in(const std::string& group) const {
    std::vector<std::string> names;
    if (H5Lexists(opened_.id(), ("VTKHDF/" + group).c_str(), H5P_DEFAULT) <= 0) return names;
    const Handle its(H5Gopen2(opened_.id(), ("VTKHDF/" + group).c_str(), H5P_DEFAULT), H5Gclose);
    H5G_info_t info{};
    expect(its.is_open() && H5Gget_info(its.id(), &info) >= 0, group + " cannot be read");
    for (hsize_t k = 0; k < info.nlinks; ++k) {
      std::array<char, 256> name{};
      const auto get = [&](H5_index_t order) { return H5Lget_name_by_idx(its.id(), ".", order, H5_ITER_INC, k, name.data(), name.size(), H5P_DEFAULT) > 0; };
      expect(get(H5_INDEX_CRT_ORDER) || get(H5_INDEX_NAME), group + " cannot be read");
      names.emplace_back(name.data());
    }
    return names;
  }

  hdf5::Quiet quiet_;
  std::string file_;
  Handle opened_;
  std::uintmax_t size_ = 0;  // [byte]
};

}  // namespace

std::vector<double> times_of_vtkhdf(const std::filesystem::path& file) { return Reader(file).times(); }

Frame read_vtkhdf(const std::filesystem::path& file, std::size_t step) { return Reader(file).step(step); }

}  // namespace perimpact::frames
