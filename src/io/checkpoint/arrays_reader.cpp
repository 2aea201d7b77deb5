#include "io/checkpoint/arrays_reader.hpp"

#include <fcntl.h>
#include <fmt/format.h>

#include <cerrno>
#include <cstddef>
#include <cstring>
#include <system_error>
#include <vector>

#include "base/error.hpp"
#include "io/checkpoint/fingerprint.hpp"
#include "io/hdf5/handle.hpp"
#include "io/output/file.hpp"

namespace perimpact::checkpoint {

using hdf5::Handle, hdf5::Quiet, hdf5::type_in_memory;

struct ArraysReader::File {
  Quiet quiet;
  std::filesystem::path path;
  std::uintmax_t size = 0;
  Handle opened;
  std::uint64_t read = 0;
};

namespace {

bool get_attribute(hid_t of, const char* name, hid_t type, void* into) {
  const Handle attribute(H5Aopen(of, name, H5P_DEFAULT), H5Aclose);
  if (!attribute.is_open()) return false;
  const Handle stored(H5Aget_type(attribute.id()), H5Tclose), space(H5Aget_space(attribute.id()), H5Sclose);
  return H5Tequal(stored.id(), type) > 0 && H5Sget_simple_extent_npoints(space.id()) == 1 && H5Aread(attribute.id(), type, into) >= 0;
}

bool is_text(hid_t type) { return type >= 0 && H5Tget_class(type) == H5T_STRING && H5Tis_variable_str(type) == 0 && H5Tget_size(type) > 0; }

bool has_fingerprint(hid_t array, const std::string& name, const void* bytes, std::size_t count) {
  std::uint64_t sum = 0;
  return get_attribute(array, "fingerprint", H5T_NATIVE_UINT64, &sum) && sum == fingerprint(name, bytes, count);
}

}  // namespace

ArraysReader::ArraysReader(const std::filesystem::path& path) : file_(std::make_unique<File>()) {
  file_->path = path;
  std::error_code unknown;
  file_->size = std::filesystem::file_size(path, unknown);
  const output::Descriptor readable(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (!readable.is_open())
    throw fccda::InputError(fmt::format("{} cannot be read: {}. Make it readable, or start a new run without --resume.", path.string(), std::strerror(errno)));
  const Handle access = hdf5::file_access();
  file_->opened = Handle(H5Fopen(path.c_str(), H5F_ACC_RDONLY, access.id()), H5Fclose);
  expect(!unknown && file_->opened.is_open(), "it is not a complete HDF5 file");
}

ArraysReader::~ArraysReader() = default;

void ArraysReader::expect(bool sound, const std::string& what) const {
  if (!sound)
    throw fccda::InputError(
        fmt::format("{} is damaged or of another run: {}. Restore an intact copy, or start a new run without --resume.", file_->path.string(), what));
}

std::size_t ArraysReader::length(const std::string& name, hdf5::NumberType type) {
  const Handle array(H5Dopen2(file_->opened.id(), name.c_str(), H5P_DEFAULT), H5Dclose);
  expect(array.is_open(), "the array " + name + " is missing");
  const Handle stored(H5Dget_type(array.id()), H5Tclose), space(H5Dget_space(array.id()), H5Sclose);
  const hssize_t count = H5Sget_simple_extent_npoints(space.id());
  expect(H5Tequal(stored.id(), type_in_memory(type)) > 0 && count >= 0, "the array " + name + " has another number type than expected");
  // before memory is allocated: a stated array size cannot exceed the file size
  expect(count == 0 || static_cast<std::uintmax_t>(count) <= file_->size, "the array " + name + " is longer than the file");
  return static_cast<std::size_t>(count);
}

void ArraysReader::read(const std::string& name, hdf5::NumberType type, void* numbers, std::size_t count) {
  const Handle array(H5Dopen2(file_->opened.id(), name.c_str(), H5P_DEFAULT), H5Dclose);
  const hid_t kind = type_in_memory(type);
  expect((count == 0 || H5Dread(array.id(), kind, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers) >= 0) &&
             has_fingerprint(array.id(), name, numbers, count * H5Tget_size(kind)),
         "the checksum of " + name + " does not match");
  ++file_->read;
}

std::string ArraysReader::text(const std::string& name) {
  const Handle array(H5Dopen2(file_->opened.id(), name.c_str(), H5P_DEFAULT), H5Dclose);
  expect(array.is_open(), "the text " + name + " is missing");
  const Handle type(H5Dget_type(array.id()), H5Tclose), space(H5Dget_space(array.id()), H5Sclose);
  expect(is_text(type.id()) && H5Sget_simple_extent_npoints(space.id()) == 1 && H5Tget_size(type.id()) <= file_->size, name + " is not a text");
  std::string text(H5Tget_size(type.id()), '\0');
  const bool done = H5Dread(array.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data()) >= 0;
  text.pop_back();
  expect(done && has_fingerprint(array.id(), name, text.data(), text.size()), "the checksum of the text " + name + " does not match");
  return text;
}

std::int64_t ArraysReader::integer(const char* name) {
  std::int64_t value = 0;
  expect(get_attribute(file_->opened.id(), name, H5T_NATIVE_INT64, &value), fmt::format("{} is missing", name));
  return value;
}

std::uint64_t ArraysReader::natural(const char* name) {
  std::uint64_t value = 0;
  expect(get_attribute(file_->opened.id(), name, H5T_NATIVE_UINT64, &value), fmt::format("{} is missing", name));
  return value;
}

double ArraysReader::number(const char* name) {
  double value = 0;
  expect(get_attribute(file_->opened.id(), name, H5T_NATIVE_DOUBLE, &value), fmt::format("{} is missing", name));
  return value;
}

std::string ArraysReader::word(const char* name) {
  const Handle attribute(H5Aopen(file_->opened.id(), name, H5P_DEFAULT), H5Aclose);
  const Handle type(attribute.is_open() ? H5Aget_type(attribute.id()) : -1, H5Tclose);
  constexpr std::size_t longest = 1000;  // maximum length of a word
  expect(is_text(type.id()) && H5Tget_size(type.id()) <= longest, fmt::format("{} is missing", name));
  std::string word(H5Tget_size(type.id()), '\0');
  expect(H5Aread(attribute.id(), type.id(), word.data()) >= 0, fmt::format("{} is missing", name));
  word.resize(std::strlen(word.c_str()));
  return word;
}

void ArraysReader::expect_intact() {
  std::vector<std::string> names;
  const auto add = [](hid_t, const char* name, const H5L_info_t*, void* all) {
    static_cast<std::vector<std::string>*>(all)->emplace_back(name);
    return herr_t{0};
  };
  expect(H5Lvisit(file_->opened.id(), H5_INDEX_NAME, H5_ITER_NATIVE, add, &names) >= 0, "its arrays cannot be listed");
  for (const std::string& name : names) {
    const Handle array(H5Dopen2(file_->opened.id(), name.c_str(), H5P_DEFAULT), H5Dclose);
    if (!array.is_open()) continue;  // a group
    const Handle type(H5Dget_type(array.id()), H5Tclose), space(H5Dget_space(array.id()), H5Sclose);
    const hssize_t count = H5Sget_simple_extent_npoints(space.id());
    expect(count >= 0 && static_cast<std::uintmax_t>(count) * H5Tget_size(type.id()) <= file_->size, "the array " + name + " is longer than the file");
    std::vector<std::byte> bytes(static_cast<std::size_t>(count) * H5Tget_size(type.id()));
    const bool done = bytes.empty() || H5Dread(array.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data()) >= 0;
    if (is_text(type.id())) bytes.pop_back();  // its terminating zero
    expect(done && has_fingerprint(array.id(), name, bytes.data(), bytes.size()), "the checksum of " + name + " does not match");
  }
}

void ArraysReader::expect_all_read() { expect(natural("arrays") == file_->read, "it contains other arrays than expected"); }

}  // namespace perimpact::checkpoint
