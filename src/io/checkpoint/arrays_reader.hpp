/// Reader of the HDF5 files of ArraysWriter; verifies the checksum of every array.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "base/state.hpp"
#include "io/hdf5/number_type.hpp"

namespace perimpact::checkpoint {

/// Opens a file. Throws InputError where it was not written by ArraysWriter or is incomplete.
class ArraysReader {
 public:
  explicit ArraysReader(const std::filesystem::path& path);
  ~ArraysReader();

  /// State visitor (base/state.hpp) that restores the state; lists are resized to their length in the file.
  template <class Values>
  void operator()(std::string_view name, Values&& values) {
    using T = typename decltype(fccda::numbers_in(values))::value_type;
    const std::string named(name);
    const std::size_t count = length(named, hdf5::number_type<T>());
    if constexpr (fccda::is_list<std::remove_cvref_t<Values>>) values.resize(count);
    const auto numbers = fccda::numbers_in(values);
    expect(numbers.size() == count, "the array " + named + " has another length than expected");
    read(named, hdf5::number_type<T>(), numbers.data(), count);
  }

  std::string text(const std::string& name);

  std::int64_t integer(const char* name);
  std::uint64_t natural(const char* name);
  double number(const char* name);
  std::string word(const char* name);

  /// Reads all arrays and texts, and throws InputError where a checksum does not match: for a reader of whose errors others must know beforehand.
  void expect_intact();

  /// Checks that all arrays of the file were read.
  void expect_all_read();

 private:
  std::size_t length(const std::string& name, hdf5::NumberType type);
  void read(const std::string& name, hdf5::NumberType type, void* numbers, std::size_t count);
  void expect(bool sound, const std::string& what) const;

  struct File;
  std::unique_ptr<File> file_;
};

}  // namespace perimpact::checkpoint
