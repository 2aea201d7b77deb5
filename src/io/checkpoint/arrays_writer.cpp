#include "io/checkpoint/arrays_writer.hpp"

#include <fmt/format.h>

#include "base/error.hpp"
#include "io/checkpoint/fingerprint.hpp"
#include "io/hdf5/driver.hpp"
#include "io/hdf5/handle.hpp"
#include "io/output/file.hpp"

namespace perimpact::checkpoint {

using hdf5::Handle, hdf5::Quiet, hdf5::DriverTarget, hdf5::type_in_memory;

struct ArraysWriter::File {
  explicit File(const std::filesystem::path& its_path) : path(its_path), whole(path), storage(whole), target{storage} {}
  ~File() { opened.close(); }  // before its target is destroyed

  /// HDF5 fails for lack of memory or for a duplicate name; a full disk is reported through the driver.
  void expect(bool done) const {
    target.rethrow();
    if (!done) throw fccda::RunError(fmt::format("{} cannot be written: HDF5 failed. Everything written before is intact.", path.string()));
  }

  /// Creates the missing parent groups of a name such as "state/plate/velocity".
  void make_groups(const std::string& name) {
    for (std::size_t slash = name.find('/', 1); slash != std::string::npos; slash = name.find('/', slash + 1)) {
      const std::string above = name.substr(0, slash);
      if (H5Lexists(opened.id(), above.c_str(), H5P_DEFAULT) > 0) continue;
      expect(Handle(H5Gcreate2(opened.id(), above.c_str(), H5P_DEFAULT, group.id(), H5P_DEFAULT), H5Gclose).is_open());
    }
  }

  Quiet quiet;
  std::filesystem::path path;
  output::WholeFile whole;
  hdf5::FileStorage<output::WholeFile> storage;
  DriverTarget target;
  Handle opened, group, array;  // creation properties of groups and arrays: without timestamps, so that equal states give equal files
  std::uint64_t arrays = 0;
};

namespace {

/// A scalar dataspace.
Handle one_number() { return {H5Screate(H5S_SCALAR), H5Sclose}; }

bool put_attribute(hid_t of, const char* name, hid_t type, const void* value) {
  const Handle space = one_number();
  const Handle attribute(H5Acreate2(of, name, type, space.id(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  return attribute.is_open() && H5Awrite(attribute.id(), type, value) >= 0;
}

/// HDF5 string type of that length; HDF5 has none of length 0.
Handle text_type(std::size_t bytes) {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type.id(), bytes + 1);
  H5Tset_cset(type.id(), H5T_CSET_UTF8);
  return type;
}

}  // namespace

ArraysWriter::ArraysWriter(const std::filesystem::path& path) : file_(std::make_unique<File>(path)) {
  const Handle access = hdf5::file_access();
  file_->expect(hdf5::use_driver(access.id(), file_->target));
  const Handle root(H5Pcreate(H5P_FILE_CREATE), H5Pclose);
  file_->group = Handle(H5Pcreate(H5P_GROUP_CREATE), H5Pclose);
  file_->array = Handle(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  for (const hid_t made : {root.id(), file_->group.id(), file_->array.id()}) file_->expect(H5Pset_obj_track_times(made, false) >= 0);
  file_->opened = Handle(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, root.id(), access.id()), H5Fclose);
  file_->expect(file_->opened.is_open());
}

ArraysWriter::~ArraysWriter() = default;

void ArraysWriter::write(const std::string& name, hdf5::NumberType type, const void* numbers, std::size_t count) {
  file_->make_groups(name);
  const hsize_t length = count;
  const Handle space(H5Screate_simple(1, &length, nullptr), H5Sclose);
  const hid_t kind = type_in_memory(type);
  const Handle array(H5Dcreate2(file_->opened.id(), name.c_str(), kind, space.id(), H5P_DEFAULT, file_->array.id(), H5P_DEFAULT), H5Dclose);
  const std::uint64_t sum = fingerprint(name, numbers, count * H5Tget_size(kind));
  file_->expect(array.is_open() && (count == 0 || H5Dwrite(array.id(), kind, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers) >= 0) &&
                put_attribute(array.id(), "fingerprint", H5T_NATIVE_UINT64, &sum));
  ++file_->arrays;
}

void ArraysWriter::text(const std::string& name, std::string_view text) {
  const std::string ended(text);
  const Handle type = text_type(ended.size()), space = one_number();
  const Handle array(H5Dcreate2(file_->opened.id(), name.c_str(), type.id(), space.id(), H5P_DEFAULT, file_->array.id(), H5P_DEFAULT), H5Dclose);
  const std::uint64_t sum = fingerprint(name, ended.data(), ended.size());
  file_->expect(array.is_open() && H5Dwrite(array.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, ended.c_str()) >= 0 &&
                put_attribute(array.id(), "fingerprint", H5T_NATIVE_UINT64, &sum));
}

void ArraysWriter::number(const char* name, std::int64_t value) { file_->expect(put_attribute(file_->opened.id(), name, H5T_NATIVE_INT64, &value)); }
void ArraysWriter::number(const char* name, std::uint64_t value) { file_->expect(put_attribute(file_->opened.id(), name, H5T_NATIVE_UINT64, &value)); }
void ArraysWriter::number(const char* name, double value) { file_->expect(put_attribute(file_->opened.id(), name, H5T_NATIVE_DOUBLE, &value)); }
void ArraysWriter::word(const char* name, const std::string& word) {
  const Handle type = text_type(word.size());
  file_->expect(put_attribute(file_->opened.id(), name, type.id(), word.c_str()));
}

void ArraysWriter::finish() {
  number("arrays", file_->arrays);
  file_->expect(file_->opened.close());
  file_->whole.finish();
  output::sync_folder(file_->path.has_parent_path() ? file_->path.parent_path() : ".");
}

}  // namespace perimpact::checkpoint
