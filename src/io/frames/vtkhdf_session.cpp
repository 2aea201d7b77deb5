#include "io/frames/vtkhdf_session.hpp"

#include <fmt/format.h>

#include <utility>

#include "base/error.hpp"

namespace perimpact::frames {

Session::Session(hdf5::Storage& its_storage, std::string its_file)
    : file(std::move(its_file)), target{its_storage}, access(hdf5::file_access(H5F_LIBVER_V110)) {
  expect(hdf5::use_driver(access.id(), target));
  // each item at the end of the file on its own, so that no later write reaches into an earlier one
  expect(H5Pset_meta_block_size(access.id(), 0) >= 0 && H5Pset_small_data_block_size(access.id(), 0) >= 0);
}

void Session::expect(bool done) const {
  target.rethrow();
  if (!done) throw fccda::RunError(fmt::format("{} cannot be written: HDF5 failed. Everything written before is intact.", file));
}

void Session::open() {
  opened = Handle(H5Fopen(file.c_str(), H5F_ACC_RDWR, access.id()), H5Fclose);
  expect(opened.is_open());
}

Handle Session::dataset(const std::string& name) const {
  Handle found(H5Dopen2(opened.id(), ("VTKHDF/" + name).c_str(), H5P_DEFAULT), H5Dclose);
  expect(found.is_open());
  return found;
}

bool Session::has(const std::string& name) const { return H5Lexists(opened.id(), ("VTKHDF/" + name).c_str(), H5P_DEFAULT) > 0; }

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

namespace {

Handle number_of_steps(const Session& session, const Handle& steps) {
  Handle attribute(H5Aopen(steps.id(), "NSteps", H5P_DEFAULT), H5Aclose);  // H5Aopen_by_name opens it so that H5Awrite fails (HDF5 1.10.8)
  session.expect(attribute.is_open());
  return attribute;
}

Handle group_of_steps(const Session& session) { return {H5Gopen2(session.opened.id(), "VTKHDF/Steps", H5P_DEFAULT), H5Gclose}; }

}  // namespace

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

std::array<hsize_t, 2> extent_of(const Session& session, const Handle& dataset) {
  const Handle space(H5Dget_space(dataset.id()), H5Sclose);
  std::array<hsize_t, 2> extent{0, 1};
  session.expect(H5Sget_simple_extent_ndims(space.id()) <= 2 && H5Sget_simple_extent_dims(space.id(), extent.data(), nullptr) >= 0);
  return extent;
}

bool grows(const Session& session, const Handle& dataset) {
  const Handle space(H5Dget_space(dataset.id()), H5Sclose);
  std::array<hsize_t, 2> most{0, 1};
  session.expect(H5Sget_simple_extent_ndims(space.id()) <= 2 && H5Sget_simple_extent_dims(space.id(), nullptr, most.data()) >= 0);
  return most[0] == H5S_UNLIMITED;
}

void set_length(const Session& session, const Handle& dataset, hsize_t length) {
  std::array<hsize_t, 2> extent = extent_of(session, dataset);
  if (extent[0] == length) return;
  extent[0] = length;
  session.expect(H5Dset_extent(dataset.id(), extent.data()) >= 0);
}

std::int64_t entry(const Session& session, const std::string& name, hsize_t step) {
  const Handle dataset = session.dataset(name);
  const hsize_t start[] = {step, 0}, count[] = {1, 1};
  const Handle memory(H5Screate(H5S_SCALAR), H5Sclose), space(H5Dget_space(dataset.id()), H5Sclose);
  std::int64_t value = 0;
  session.expect(H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, start, nullptr, count, nullptr) >= 0 &&
                 H5Dread(dataset.id(), H5T_NATIVE_INT64, memory.id(), space.id(), H5P_DEFAULT, &value) >= 0);
  return value;
}

void set_entry(const Session& session, const std::string& name, hsize_t step, std::int64_t value) {
  set_entry(session, name, step, std::span<const std::int64_t>(&value, 1));
}

void append_rows(const Session& session, const std::string& name, hsize_t first, std::size_t rows, std::span<const std::byte> bytes, std::size_t row_bytes,
                 std::size_t number_size) {
  const Handle dataset = session.dataset(name);
  const std::vector<std::vector<std::byte>> packed = packed_chunks(bytes, rows * row_bytes, number_size);
  set_length(session, dataset, first + packed.size() * rows);
  for (std::size_t k = 0; k < packed.size(); ++k) {
    const hsize_t at[] = {first + k * rows, 0};
    session.expect(H5Dwrite_chunk(dataset.id(), H5P_DEFAULT, 0, at, packed[k].size(), packed[k].data()) >= 0);
  }
}

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

}  // namespace perimpact::frames
