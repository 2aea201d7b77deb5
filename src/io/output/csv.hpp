/// Tables of numbers as CSV: a header of `name.quantity_axis [unit]`, then rows. Each number is written with as few digits as
/// read back to the very same double; not-a-number is `nan`.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "io/output/file.hpp"

namespace perimpact::output {

/// A table that grows while the run goes on (history.csv). Each row reaches the system at once, so a killed run keeps its rows.
class CsvWriter {
 public:
  CsvWriter(const std::filesystem::path& path, std::span<const std::string> columns);
  /// Goes on with a table of so many columns behind its first `size` bytes; the rest is cut off.
  CsvWriter(const std::filesystem::path& path, std::size_t columns, std::uint64_t size) : columns_(columns), file_(path, size) {}

  void append(std::span<const double> row);            ///< one number a column
  void sync() { file_.sync(); }                        ///< all rows reach the disk
  std::uint64_t size() const { return file_.size(); }  ///< [byte]

 private:
  std::size_t columns_;
  GrowingFile file_;
};

/// A table that is known as a whole (lines/*.csv). `rows` holds one row after the other.
void write_csv(const std::filesystem::path& path, std::span<const std::string> columns, std::span<const double> rows);

}  // namespace perimpact::output
