/// Writes arrays of numbers by name into an HDF5 file, with a fingerprint each (docs/guide/restart.md says what such a file holds). The
/// file appears under its name when finish() returns; until then an earlier one of that name stays.
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
#include "io/checkpoint/number_type.hpp"

namespace perimpact::checkpoint {

/// Throws RunError where the file cannot be written.
class ArraysWriter {
 public:
  explicit ArraysWriter(const std::filesystem::path& path);
  ~ArraysWriter();

  /// A visitor of state (base/state.hpp).
  template <class Values>
  void operator()(std::string_view name, Values&& values) {
    const auto numbers = fccda::numbers_in(values);
    write(std::string(name), number_type<typename decltype(numbers)::value_type>(), numbers.data(), numbers.size());
  }

  void text(const std::string& name, std::string_view text);

  /// Facts about the file, as attributes.
  void number(const char* name, std::int64_t value);
  void number(const char* name, std::uint64_t value);
  void number(const char* name, double value);
  void word(const char* name, const std::string& word);

  void finish();

 private:
  void write(const std::string& name, NumberType type, const void* numbers, std::size_t count);

  struct File;
  std::unique_ptr<File> file_;
};

}  // namespace perimpact::checkpoint
