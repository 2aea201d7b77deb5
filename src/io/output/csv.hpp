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

  void append(std::span<const double> row);  ///< one number a column

 private:
  std::size_t columns_;
  GrowingFile file_;
};

/// A table that is known as a whole (lines/*.csv). `rows` holds one row after the other.
void write_csv(const std::filesystem::path& path, std::span<const std::string> columns, std::span<const double> rows);

}  // namespace perimpact::output
