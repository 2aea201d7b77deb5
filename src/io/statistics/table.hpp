/// A table that a run left behind, read back: history.csv, or any other of its CSV files.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace perimpact {

struct Table {
  std::filesystem::path file;
  std::vector<std::string> names;            ///< "ship.force_x [N]"
  std::vector<std::vector<double>> columns;  ///< each with a number a row

  std::size_t rows() const { return columns.empty() ? 0 : columns.front().size(); }
};

/// Throws InputError, at file and line, where there is no such table.
Table read_table(const std::filesystem::path& file);

/// "ship.force_x [N]" is the quantity `ship.force_x` in the unit `N`.
std::string_view quantity_of(std::string_view column);
std::string_view unit_of(std::string_view column);

/// Is each row the mean since the row before? So are forces, moments and torques of history.csv (docs/guide/results.md).
bool is_mean(std::string_view column);

/// The columns that are read where nothing else is asked for: forces on impactors, forces and torques of their gauges.
std::vector<std::size_t> columns_of_loads(const Table& table);

/// The columns that the words choose, in the order of the table. A word is a whole name, with or without its unit, or the beginning of one up
/// to a full stop or underscore: `ship`, `ship.force`, `ship.force_x`. Throws InputError for one that chooses nothing.
std::vector<std::size_t> columns_named(const Table& table, const std::vector<std::string>& words);

}  // namespace perimpact
