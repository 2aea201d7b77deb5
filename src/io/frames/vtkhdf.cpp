#include "io/frames/vtkhdf.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <span>

#include "base/contract.hpp"
#include "base/error.hpp"
#include "io/frames/chunks.hpp"
#include "io/hdf5/driver.hpp"
#include "io/hdf5/handle.hpp"
#include "io/hdf5/staged.hpp"
#include "io/output/file.hpp"

namespace perimpact::frames {

namespace {

using hdf5::Handle;
using output::PolyData;

constexpr const char* cell_kinds[] = {"Vertices", "Lines", "Polygons", "Strips"};  // in the order of the columns of CellOffsets
constexpr hsize_t step_chunk = 128;                                                // entries of a chunk of the arrays with one entry per step

/// One session of HDF5 on a file. Declared in the order of construction.
struct Session {
  Session(hdf5::Storage& its_storage, std::string its_file) : file(std::move(its_file)), target{its_storage}, access(hdf5::file_access(H5F_LIBVER_V110)) {
    expect(hdf5::use_driver(access.id(), target));
    // each item at the end of the file on its own, so that no later write reaches into an earlier one
    expect(H5Pset_meta_block_size(access.id(), 0) >= 0 && H5Pset_small_data_block_size(access.id(), 0) >= 0);
  }
  ~Session() { opened.close(); }  // before its target is destroyed

  void expect(bool done) const {
    target.rethrow();
    if (!done) throw fccda::RunError(fmt::format("{} cannot be written: HDF5 failed. Everything written before is intact.", file));
  }
  void open() {
    opened = Handle(H5Fopen(file.c_str(), H5F_ACC_RDWR, access.id()), H5Fclose);
    expect(opened.is_open());
  }
  void close() { expect(opened.close()); }

  Handle dataset(const std::string& name) const {
    Handle found(H5Dopen2(opened.id(), ("VTKHDF/" + name).c_str(), H5P_DEFAULT), H5Dclose);
    expect(found.is_open());
    return found;
  }
  bool has(const std::string& name) const { return H5Lexists(opened.id(), ("VTKHDF/" + name).c_str(), H5P_DEFAULT) > 0; }

  hdf5::Quiet quiet;
  std::string file;
  hdf5::DriverTarget target;
  Handle access, opened;
};

/// Creation of groups and data sets: without timestamps, so that equal frames give equal files; links in the header of the group, in their order.
Handle creation(hid_t kind) {
  Handle made(H5Pcreate(kind), H5Pclose);
  H5Pset_obj_track_times(made.id(), false);
  if (kind != H5P_DATASET_CREATE) H5Pset_link_phase_change(made.id(), 64, 32), H5Pset_est_link_info(made.id(), 16, 24);
  if (kind == H5P_GROUP_CREATE) H5Pset_link_creation_order(made.id(), H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED);
  return made;
}

void make_group(const Session& session, const std::string& name) {
  const Handle how = creation(H5P_GROUP_CREATE);
  session.expect(Handle(H5Gcreate2(session.opened.id(), name.c_str(), H5P_DEFAULT, how.id(), H5P_DEFAULT), H5Gclose).is_open());
}

struct Shape {
  hsize_t length, columns;
  hsize_t rows;  // of a chunk; 0: contiguous
  bool grows, is_packed;
};

Handle make_dataset(const Session& session, const std::string& name, hid_t type, const Shape& shape) {
  const int rank = shape.columns == 1 ? 1 : 2;
  const hsize_t now[] = {shape.length, shape.columns}, most[] = {H5S_UNLIMITED, shape.columns}, chunk[] = {shape.rows, shape.columns};
  const Handle space(H5Screate_simple(rank, now, shape.grows ? most : nullptr), H5Sclose), how = creation(H5P_DATASET_CREATE);
  if (shape.rows > 0) H5Pset_chunk(how.id(), rank, chunk);
  if (shape.is_packed) add_filters(how.id());
  Handle made(H5Dcreate2(session.opened.id(), ("VTKHDF/" + name).c_str(), type, space.id(), H5P_DEFAULT, how.id(), H5P_DEFAULT), H5Dclose);
  session.expect(made.is_open());
  return made;
}

void put_attribute(const Session& session, const std::string& group, const char* name, hid_t type, const Handle& space, const void* value) {
  const Handle owner(H5Gopen2(session.opened.id(), group.c_str(), H5P_DEFAULT), H5Gclose);
  const Handle made(H5Acreate2(owner.id(), name, type, space.id(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  session.expect(made.is_open() && H5Awrite(made.id(), type, value) >= 0);
}

Handle number_of_steps(const Session& session, const Handle& steps) {
  Handle attribute(H5Aopen(steps.id(), "NSteps", H5P_DEFAULT), H5Aclose);  // H5Aopen_by_name opens it so that H5Awrite fails (HDF5 1.10.8)
  session.expect(attribute.is_open());
  return attribute;
}

Handle group_of_steps(const Session& session) { return {H5Gopen2(session.opened.id(), "VTKHDF/Steps", H5P_DEFAULT), H5Gclose}; }

std::int64_t steps_in(const Session& session) {
  const Handle group = group_of_steps(session);
  std::int64_t steps = 0;
  session.expect(H5Aread(number_of_steps(session, group).id(), H5T_NATIVE_INT64, &steps) >= 0 && steps > 0);
  return steps;
}

void set_steps(const Session& session, std::int64_t steps) {
  const Handle group = group_of_steps(session);
  session.expect(H5Awrite(number_of_steps(session, group).id(), H5T_NATIVE_INT64, &steps) >= 0);
}

/// Length and columns of a data set.
std::array<hsize_t, 2> extent_of(const Session& session, const Handle& dataset) {
  const Handle space(H5Dget_space(dataset.id()), H5Sclose);
  std::array<hsize_t, 2> extent{0, 1};
  session.expect(H5Sget_simple_extent_ndims(space.id()) <= 2 && H5Sget_simple_extent_dims(space.id(), extent.data(), nullptr) >= 0);
  return extent;
}

void set_length(const Session& session, const Handle& dataset, hsize_t length) {
  std::array<hsize_t, 2> extent = extent_of(session, dataset);
  if (extent[0] == length) return;
  extent[0] = length;
  session.expect(H5Dset_extent(dataset.id(), extent.data()) >= 0);
}

/// Writes the entry of a step in an array with one row per step.
template <class Number>
void set_entry(const Session& session, const std::string& name, hsize_t step, std::span<const Number> row) {
  const Handle dataset = session.dataset(name);
  set_length(session, dataset, step + 1);
  const hsize_t start[] = {step, 0}, count[] = {1, row.size()};
  const Handle memory(H5Screate_simple(1, &count[1], nullptr), H5Sclose), space(H5Dget_space(dataset.id()), H5Sclose);
  session.expect(H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, start, nullptr, count, nullptr) >= 0 &&
                 H5Dwrite(dataset.id(), hdf5::type_in_memory(hdf5::number_type<Number>()), memory.id(), space.id(), H5P_DEFAULT, row.data()) >= 0);
}

void set_entry(const Session& session, const std::string& name, hsize_t step, std::int64_t value) {
  set_entry(session, name, step, std::span<const std::int64_t>(&value, 1));
}

template <class Number>
void write_fixed(const Session& session, const std::string& name, std::span<const Number> numbers) {
  constexpr std::size_t worth_packing = 1024;
  const bool is_long = numbers.size() > worth_packing;
  const hid_t type = hdf5::type_in_memory(hdf5::number_type<Number>());
  const Handle made = make_dataset(session, name, type, {numbers.size(), 1, is_long ? rows_of_chunk(numbers.size()) : 0, false, is_long});
  session.expect(numbers.empty() || H5Dwrite(made.id(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data()) >= 0);
}

/// An array of a frame, with its place in the file.
struct Place {
  std::string name, offsets;  ///< below VTKHDF: "PointData/damage", "Steps/PointDataOffsets/damage"
  int components;
  const output::Numbers& numbers;
  bool is_constant;

  std::size_t rows() const { return output::count_of(numbers) / static_cast<std::size_t>(components); }
};

std::vector<Place> places_of(const PolyData& frame) {
  std::vector<Place> places = {{"Points", "Steps/PointOffsets", 3, frame.points, false}};
  const auto add = [&](const std::string& group, const std::vector<output::VtpArray>& arrays) {
    for (const output::VtpArray& each : arrays)
      places.push_back({group + "/" + each.name, "Steps/" + group + "Offsets/" + each.name, each.components, each.numbers, each.is_constant});
  };
  add("PointData", frame.point_arrays), add("CellData", frame.cell_arrays);
  return places;
}

hid_t type_of(const output::Numbers& numbers) {
  return std::visit(
      []<class Given>(const Given&) {
        if constexpr (std::is_same_v<Given, output::MadeFloats>)
          return hdf5::type_in_memory(hdf5::NumberType::float32);
        else
          return hdf5::type_in_memory(hdf5::number_type<typename Given::value_type>());
      },
      numbers);
}

/// Appends the rows of a step as whole chunks.
void append(const Session& session, const Place& place, hsize_t step) {
  if (place.is_constant && step > 0) return set_entry(session, place.offsets, step, std::int64_t{0});
  const Handle dataset = session.dataset(place.name);
  const std::size_t count = place.rows(), rows = rows_of_chunk(count), chunks = (count + rows - 1) / rows;
  const hsize_t first = step * chunks * rows;
  set_length(session, dataset, first + chunks * rows);
  const auto write = [&](std::span<const std::byte> bytes, std::size_t number_size) {
    const std::size_t row_bytes = number_size * static_cast<std::size_t>(place.components);
    const std::vector<std::vector<std::byte>> packed = packed_chunks(bytes, rows * row_bytes, number_size);
    for (std::size_t k = 0; k < packed.size(); ++k) {
      const hsize_t at[] = {first + k * rows, 0};
      session.expect(H5Dwrite_chunk(dataset.id(), H5P_DEFAULT, 0, at, packed[k].size(), packed[k].data()) >= 0);
    }
  };
  std::visit(
      [&]<class Given>(const Given& given) {
        if constexpr (std::is_same_v<Given, output::MadeFloats>) {
          const std::vector<float> made = given.make();
          write(std::as_bytes(std::span(made)), sizeof(float));
        } else {
          write(std::as_bytes(given), sizeof(typename Given::value_type));
        }
      },
      place.numbers);
  set_entry(session, place.offsets, step, static_cast<std::int64_t>(first));
}

/// NSteps and Steps/Values, by which readers find the step, are the last that they see (StagedStorage).
void add_step(const Session& session, const PolyData& frame, double time, std::int64_t step) {
  const auto number = static_cast<hsize_t>(step);
  for (const Place& place : places_of(frame)) append(session, place, number);
  constexpr std::int64_t none[std::size(cell_kinds)] = {};
  set_entry(session, "Steps/PartOffsets", number, std::int64_t{0});
  set_entry(session, "Steps/NumberOfParts", number, std::int64_t{1});
  set_entry(session, "Steps/CellOffsets", number, std::span<const std::int64_t>(none));
  set_entry(session, "Steps/ConnectivityIdOffsets", number, std::span<const std::int64_t>(none));
  set_entry(session, "Steps/Values", number, std::span<const double>(&time, 1));
  set_steps(session, step + 1);
}

/// The cells of a frame: one vertex per particle, or the panels.
void write_cells(const Session& session, const PolyData& frame) {
  const std::int64_t points = static_cast<std::int64_t>(output::count_of(frame.points) / 3);
  std::vector<std::int64_t> connectivity, offsets{0};
  if (frame.panels.empty()) {
    connectivity.resize(static_cast<std::size_t>(points)), offsets.resize(static_cast<std::size_t>(points) + 1);
    std::iota(connectivity.begin(), connectivity.end(), 0), std::iota(offsets.begin(), offsets.end(), 0);
  }
  for (const std::array<int, 4>& panel : frame.panels) {
    connectivity.insert(connectivity.end(), panel.begin(), panel[3] < 0 ? panel.end() - 1 : panel.end());
    offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
  }
  write_fixed(session, "NumberOfPoints", std::span<const std::int64_t>(&points, 1));
  const std::string_view kind = frame.panels.empty() ? "Vertices" : "Polygons";
  for (const std::string group : cell_kinds) {
    make_group(session, "VTKHDF/" + group);
    const bool has_cells = group == kind;
    const std::int64_t cells = has_cells ? static_cast<std::int64_t>(offsets.size()) - 1 : 0,
                       ids = has_cells ? static_cast<std::int64_t>(connectivity.size()) : 0;
    write_fixed(session, group + "/NumberOfCells", std::span<const std::int64_t>(&cells, 1));
    write_fixed(session, group + "/NumberOfConnectivityIds", std::span<const std::int64_t>(&ids, 1));
    write_fixed(session, group + "/Offsets", std::span<const std::int64_t>(offsets).first(static_cast<std::size_t>(cells) + 1));
    write_fixed(session, group + "/Connectivity", std::span<const std::int64_t>(connectivity).first(static_cast<std::size_t>(ids)));
  }
}

/// Groups, the arrays of steps and empty arrays of the frames. The first page contains the headers of Steps and Steps/Values, so they come first.
void make_structure(const Session& session, const PolyData& frame) {
  make_group(session, "VTKHDF"), make_group(session, "VTKHDF/Steps");
  const Handle one(H5Screate(H5S_SCALAR), H5Sclose);
  const std::int64_t none = 0, version[] = {2, 0};
  put_attribute(session, "VTKHDF/Steps", "NSteps", H5T_NATIVE_INT64, one, &none);
  make_dataset(session, "Steps/Values", H5T_NATIVE_DOUBLE, {0, 1, step_chunk, true, false});

  const hsize_t two = 2;
  put_attribute(session, "VTKHDF", "Version", H5T_NATIVE_INT64, Handle(H5Screate_simple(1, &two, nullptr), H5Sclose), version);
  constexpr std::string_view type = "PolyData";
  const Handle text(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(text.id(), type.size()), H5Tset_strpad(text.id(), H5T_STR_NULLPAD);  // VTK takes its whole length as the word
  put_attribute(session, "VTKHDF", "Type", text.id(), one, type.data());
  write_cells(session, frame);

  const auto per_step = [&](const std::string& name, hsize_t columns) { make_dataset(session, name, H5T_NATIVE_INT64, {0, columns, step_chunk, true, false}); };
  per_step("Steps/PartOffsets", 1), per_step("Steps/NumberOfParts", 1);
  per_step("Steps/CellOffsets", std::size(cell_kinds)), per_step("Steps/ConnectivityIdOffsets", std::size(cell_kinds));
  for (const std::string group : {"PointData", "CellData"})
    if (!(group == "PointData" ? frame.point_arrays : frame.cell_arrays).empty())
      make_group(session, "VTKHDF/" + group), make_group(session, "VTKHDF/Steps/" + group + "Offsets");
  for (const Place& place : places_of(frame)) {
    make_dataset(session, place.name, type_of(place.numbers), {0, static_cast<hsize_t>(place.components), rows_of_chunk(place.rows()), true, true});
    per_step(place.offsets, 1);
  }
}

/// Runs a session on a file that readers may open at any moment.
template <class Change>
void change(hdf5::Storage& storage, const std::string& file, const Change& work) {
  hdf5::StagedStorage staged(storage);
  try {
    Session session(staged, file);
    session.open();
    work(session);
    session.close();
  } catch (...) {
    staged.discard();
    throw;
  }
  staged.commit();
}

/// Names of the data sets of a group below VTKHDF; none where there is no such group.
std::vector<std::string> names_in(const Session& session, const std::string& group) {
  std::vector<std::string> names;
  if (!session.has(group)) return names;
  const Handle opened(H5Gopen2(session.opened.id(), ("VTKHDF/" + group).c_str(), H5P_DEFAULT), H5Gclose);
  H5G_info_t info{};
  session.expect(opened.is_open() && H5Gget_info(opened.id(), &info) >= 0);
  for (hsize_t k = 0; k < info.nlinks; ++k) {
    std::array<char, 256> name{};
    session.expect(H5Lget_name_by_idx(opened.id(), ".", H5_INDEX_NAME, H5_ITER_INC, k, name.data(), name.size(), H5P_DEFAULT) > 0);
    names.emplace_back(name.data());
  }
  return names;
}

std::int64_t fixed_number(const Session& session, const std::string& name) {
  std::int64_t number = 0;
  session.expect(H5Dread(session.dataset(name).id(), H5T_NATIVE_INT64, H5S_ALL, H5S_ALL, H5P_DEFAULT, &number) >= 0 && number >= 0);
  return number;
}

/// Cuts the arrays of the frames to their first steps. A constant array is shorter than that from the second step on.
void truncate_arrays(const Session& session, hsize_t steps) {
  const auto truncate = [&](const std::string& name, const std::string& offsets, std::int64_t count) {
    const std::size_t rows = rows_of_chunk(static_cast<std::size_t>(count)), chunks = (static_cast<std::size_t>(count) + rows - 1) / rows;
    const Handle dataset = session.dataset(name);
    set_length(session, dataset, std::min<hsize_t>(extent_of(session, dataset)[0], steps * chunks * rows));
    set_length(session, session.dataset(offsets), steps);
  };
  const std::int64_t points = fixed_number(session, "NumberOfPoints");
  std::int64_t cells = 0;
  for (const std::string kind : cell_kinds) cells += fixed_number(session, kind + "/NumberOfCells");
  truncate("Points", "Steps/PointOffsets", points);
  for (const std::string& name : names_in(session, "PointData")) truncate("PointData/" + name, "Steps/PointDataOffsets/" + name, points);
  for (const std::string& name : names_in(session, "CellData")) truncate("CellData/" + name, "Steps/CellDataOffsets/" + name, cells);
  for (const char* name : {"PartOffsets", "NumberOfParts", "CellOffsets", "ConnectivityIdOffsets"})
    set_length(session, session.dataset(std::string("Steps/") + name), steps);
}

}  // namespace

void create_vtkhdf(hdf5::Storage& storage, const std::string& file, const PolyData& frame, double time) {
  Session session(storage, file);
  const Handle root = creation(H5P_FILE_CREATE);
  session.opened = Handle(H5Fcreate(file.c_str(), H5F_ACC_TRUNC, root.id(), session.access.id()), H5Fclose);
  session.expect(session.opened.is_open());
  make_structure(session, frame);
  add_step(session, frame, time, 0);
  session.close();
}

void append_vtkhdf(hdf5::Storage& storage, const std::string& file, const PolyData& frame, double time) {
  change(storage, file, [&](const Session& session) { add_step(session, frame, time, steps_in(session)); });
}

void truncate_vtkhdf(hdf5::Storage& storage, const std::string& file, std::size_t steps) {
  EXPECTS(steps > 0);
  change(storage, file, [&](const Session& session) {  // first, so that readers look for no step that disappears
    set_steps(session, static_cast<std::int64_t>(steps));
    set_length(session, session.dataset("Steps/Values"), steps);
  });
  change(storage, file, [&](const Session& session) { truncate_arrays(session, steps); });
}

VtkhdfSeries::VtkhdfSeries(std::filesystem::path file, std::vector<double> times) : file_(std::move(file)), times_(std::move(times)) {
  std::error_code none;
  if (times_.empty()) {
    std::filesystem::remove(file_, none);
    return;
  }
  output::UpdatedFile updated(file_);
  hdf5::FileStorage storage(updated);
  truncate_vtkhdf(storage, file_.string(), times_.size());
}

void VtkhdfSeries::add(const PolyData& frame, double time) {
  if (times_.empty()) {
    output::WholeFile whole(file_);
    hdf5::FileStorage storage(whole);
    create_vtkhdf(storage, file_.string(), frame, time);
    whole.finish();
  } else {
    output::UpdatedFile updated(file_);
    hdf5::FileStorage storage(updated);
    append_vtkhdf(storage, file_.string(), frame, time);
  }
  times_.push_back(time);
}

void VtkhdfSeries::sync() const {
  if (!times_.empty()) output::UpdatedFile(file_).sync();
}

}  // namespace perimpact::frames
