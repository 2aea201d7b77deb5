/// CSV tables of numbers: a header of `name.quantity_axis [unit]`, then rows. Each number has the fewest digits that read back to the same
/// double; not-a-number is `nan`.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "io/output/file.hpp"

namespace perimpact::output {

/// A table that grows during a run (history.csv). Each row is passed to the operating system at once, so a killed run keeps its rows.
class CsvWriter {
 public:
  CsvWriter(const std::filesystem::path& path, std::span<const std::string> columns);
  /// Resumes a table with this number of columns after its first `size` bytes; the rest is truncated.
  CsvWriter(const std::filesystem::path& path, std::size_t columns, std::uint64_t size) : columns_(columns), file_(path, size) {}

  void append(std::span<const double> row);            ///< one number per column
  void sync() { file_.sync(); }                        ///< flushes all rows to disk
  std::uint64_t size() const { return file_.size(); }  ///< [byte]

 private:
  std::size_t columns_;
  GrowingFile file_;
};

/// The first line, with the new line at its end.
std::string csv_header(std::span<const std::string> columns);

/// Writes a complete table (lines/*.csv). `rows`: row-major values.
void write_csv(const std::filesystem::path& path, std::span<const std::string> columns, std::span<const double> rows);

}  // namespace perimpact::output
