/// history.csv as a report holds it.
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

/// The table, whose first column is the time, with at most so many rows: where there are more, equally many in a row become one. Of means over
/// an interval it holds their mean over its time, of all others the last value.
Table joined(const Table& table, std::size_t most_rows);

Curves curves_of(const Table& table);

}  // namespace perimpact::report
