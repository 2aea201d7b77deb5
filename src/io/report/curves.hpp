/// History curves of a report.
#pragma once

#include <string>
#include <vector>

#include "io/output/json.hpp"
#include "io/statistics/table.hpp"

namespace perimpact::report {

struct Curves {
  output::Json description;  ///< columns with their units, rows
  std::string bytes;         ///< packed, column after column, as floats
};

/// Reduces a table, whose first column is the time, to at most `most_rows` rows by merging groups of equal size. Interval means are averaged over
/// time; of all other columns the last value is kept.
Table joined(const Table& table, std::size_t most_rows);

Curves curves_of(const Table& table);

}  // namespace perimpact::report
