/// A table that a run left behind, read back: history.csv with what history.json says of its columns, or any other of its CSV files.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace perimpact {

/// What is known of a column beside its name.
struct ColumnFacts {
  bool is_mean = false;  ///< each row is the mean since the row before; else the value at its time
  bool is_load = false;
};

struct Table {
  std::filesystem::path file;
  std::vector<std::string> names;            ///< "ship.force_x [N]"
  std::vector<std::vector<double>> columns;  ///< each with a number a row
  std::vector<ColumnFacts> facts;            ///< of each column of a history

  std::size_t rows() const { return columns.empty() ? 0 : columns.front().size(); }
};

/// Throws InputError, at file and line, where there is no such table.
Table read_table(const std::filesystem::path& file);

/// history.csv of a results folder with the facts of history.json. Throws InputError where one of both is not there, or does not fit the other.
Table read_history(const std::filesystem::path& results);

/// "ship.force_x [N]" is the quantity `ship.force_x` in the unit `N`.
std::string_view quantity_of(std::string_view column);
std::string_view unit_of(std::string_view column);

/// The columns that are read where nothing else is asked for: those that history.json calls loads.
std::vector<std::size_t> columns_of_loads(const Table& table);

/// The columns that the words choose, in the order of the table. A word is a whole name, with or without its unit, or the beginning of one up
/// to a full stop or underscore: `ship`, `ship.force`, `ship.force_x`. Throws InputError for one that chooses nothing.
std::vector<std::size_t> columns_named(const Table& table, const std::vector<std::string>& words);

}  // namespace perimpact
