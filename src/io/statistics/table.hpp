/// Reader of the tables of a run: history.csv with the column descriptions of history.json, or any other CSV file.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace perimpact {

/// Properties of a column besides its name.
struct ColumnFacts {
  bool is_mean = false;  ///< interval mean since the previous row; else instantaneous
  bool is_load = false;
};

struct Table {
  std::filesystem::path file;
  std::vector<std::string> names;            ///< "ship.force_x [N]"
  std::vector<std::vector<double>> columns;  ///< one number per row
  std::vector<ColumnFacts> facts;            ///< per column of a history

  std::size_t rows() const { return columns.empty() ? 0 : columns.front().size(); }
};

/// Reads a table. Throws InputError with file and line where it does not exist or is invalid.
Table read_table(const std::filesystem::path& file);

/// history.csv of a results folder with the column descriptions of history.json. Throws InputError where either is missing or they disagree.
Table read_history(const std::filesystem::path& results);

/// The quantity of a heading: `ship.force_x` of "ship.force_x [N]".
std::string_view quantity_of(std::string_view column);
std::string_view unit_of(std::string_view column);

/// The default columns: those marked as loads in history.json.
std::vector<std::size_t> columns_of_loads(const Table& table);

/// The columns that the words select, in table order. A word is a full name, with or without its unit, or a prefix up to a full stop or
/// underscore: `ship`, `ship.force`, `ship.force_x`. Throws InputError for a word that selects nothing.
std::vector<std::size_t> columns_named(const Table& table, const std::vector<std::string>& words);

}  // namespace perimpact
