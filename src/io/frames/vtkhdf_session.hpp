/// A VTKHDF file that is being written: a session of HDF5 on its storage, and the steps of which all else consists.
#pragma once

#include <hdf5.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "io/frames/chunks.hpp"
#include "io/hdf5/driver.hpp"
#include "io/hdf5/handle.hpp"
#include "io/hdf5/number_type.hpp"
#include "io/hdf5/storage.hpp"

namespace perimpact::frames {

using hdf5::Handle;

/// One session of HDF5 on a file. Declared in the order of construction. Names are below VTKHDF. All functions throw RunError where HDF5 fails.
struct Session {
  Session(hdf5::Storage& its_storage, std::string its_file);
  ~Session() { opened.close(); }  // before its target is destroyed

  void expect(bool done) const;
  void open();
  void close() { expect(opened.close()); }
  Handle dataset(const std::string& name) const;
  bool has(const std::string& name) const;

  hdf5::Quiet quiet;
  std::string file;
  hdf5::DriverTarget target;
  Handle access, opened;
};

/// Creation of groups and data sets: without timestamps, so that equal frames give equal files; links in the header of the group, in their order.
Handle creation(hid_t kind);

void make_group(const Session& session, const std::string& name);

struct Shape {
  hsize_t length, columns;
  hsize_t rows;  // of a chunk; 0: contiguous
  bool grows, is_packed;
};
Handle make_dataset(const Session& session, const std::string& name, hid_t type, const Shape& shape);
void put_attribute(const Session& session, const std::string& group, const char* name, hid_t type, const Handle& space, const void* value);

/// The attribute NSteps.
std::int64_t steps_in(const Session& session);
void set_steps(const Session& session, std::int64_t steps);

/// Length and columns of a data set.
std::array<hsize_t, 2> extent_of(const Session& session, const Handle& dataset);
bool grows(const Session& session, const Handle& dataset);
void set_length(const Session& session, const Handle& dataset, hsize_t length);

/// The entry of a step in an array of whole numbers with one row per step.
std::int64_t entry(const Session& session, const std::string& name, hsize_t step);

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
void set_entry(const Session& session, const std::string& name, hsize_t step, std::int64_t value);

/// Writes rows of `row_bytes` from `first`, the beginning of a chunk, to the end of an array, as whole chunks of `rows` rows. `number_size`: [byte]
void append_rows(const Session& session, const std::string& name, hsize_t first, std::size_t rows, std::span<const std::byte> bytes, std::size_t row_bytes,
                 std::size_t number_size);

template <class Number>
void write_fixed(const Session& session, const std::string& name, std::span<const Number> numbers) {
  constexpr std::size_t worth_packing = 1024;
  const bool is_long = numbers.size() > worth_packing;
  const hid_t type = hdf5::type_in_memory(hdf5::number_type<Number>());
  const Handle made = make_dataset(session, name, type, {numbers.size(), 1, is_long ? rows_of_chunk(numbers.size()) : 0, false, is_long});
  session.expect(numbers.empty() || H5Dwrite(made.id(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data()) >= 0);
}

/// Names of the data sets of a group; none where there is no such group.
std::vector<std::string> names_in(const Session& session, const std::string& group);
std::int64_t fixed_number(const Session& session, const std::string& name);

}  // namespace perimpact::frames
