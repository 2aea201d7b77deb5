/// Writer of named arrays of numbers to an HDF5 file, each with a checksum (contents: docs/guide/restart.md). The file replaces an earlier one
/// atomically when finish() returns.
///
///   ArraysWriter file(path);
///   file.text("setup", deck::setup_to_text(setup));
///   simulation.visit_state(fccda::under("state", file));
///   file.number("step", 1200);
///   file.finish();
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "base/state.hpp"
#include "io/hdf5/number_type.hpp"

namespace perimpact::checkpoint {

/// Creates the file. Throws RunError where it cannot be written.
class ArraysWriter {
 public:
  explicit ArraysWriter(const std::filesystem::path& path);
  ~ArraysWriter();

  /// State visitor (base/state.hpp).
  template <class Values>
  void operator()(std::string_view name, Values&& values) {
    const auto numbers = fccda::numbers_in(values);
    write(std::string(name), hdf5::number_type<typename decltype(numbers)::value_type>(), numbers.data(), numbers.size());
  }

  void text(const std::string& name, std::string_view text);

  /// Attributes of the file.
  void number(const char* name, std::int64_t value);
  void number(const char* name, std::uint64_t value);
  void number(const char* name, double value);
  void word(const char* name, const std::string& word);

  void finish();

 private:
  void write(const std::string& name, hdf5::NumberType type, const void* numbers, std::size_t count);

  struct File;
  std::unique_ptr<File> file_;
};

}  // namespace perimpact::checkpoint
