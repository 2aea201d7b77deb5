#include "io/report/curves.hpp"

#include <algorithm>
#include <bit>

#include "base/contract.hpp"
#include "io/report/packing.hpp"

namespace perimpact::report {

Table joined(const Table& table, std::size_t most_rows) {
  EXPECTS(most_rows > 1);
  const std::size_t rows = table.rows();
  if (rows <= most_rows) return table;
  const std::size_t together = (rows - 1 + most_rows - 2) / (most_rows - 1);  // the first row is not merged: it has no preceding interval
  Table out{.file = table.file, .names = table.names, .columns = std::vector<std::vector<double>>(table.columns.size()), .facts = table.facts};
  const std::vector<double>& times = table.columns.front();
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    const std::vector<double>& values = table.columns[c];
    const bool averaged = !table.facts.empty() && table.facts[c].is_mean;
    out.columns[c].push_back(values.front());
    for (std::size_t first = 1; first < rows; first += together) {
      const std::size_t last = std::min(first + together, rows) - 1;
      double sum = 0;
      for (std::size_t row = first; row <= last; ++row) sum += values[row] * (times[row] - times[row - 1]);
      out.columns[c].push_back(averaged ? sum / (times[last] - times[first - 1]) : values[last]);
    }
  }
  return out;
}

Curves curves_of(const Table& table) {
  Curves curves{.description = output::Json::object(), .bytes = {}};
  curves.description["rows"] = table.rows();
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    output::Json& column = curves.description["columns"];
    output::Json one = output::Json::object();
    one["name"] = quantity_of(table.names[c]);
    one["unit"] = unit_of(table.names[c]);
    column.push_back(std::move(one));
    std::vector<std::uint32_t> words;
    for (const double value : table.columns[c]) words.push_back(std::bit_cast<std::uint32_t>(static_cast<float>(value)));
    ArrayPacker(4).append(words, curves.bytes);
  }
  return curves;
}

}  // namespace perimpact::report
