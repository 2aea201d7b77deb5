#include "io/statistics/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>

#include "base/error.hpp"
#include "base/nearest_word.hpp"
#include "io/deck/yaml_node.hpp"
#include "io/output/results_folder.hpp"
#include "mesh_io/file/contents.hpp"

namespace perimpact {

namespace {

/// The cells of a line; a quoted cell ends at the next single quote character (RFC 4180).
std::vector<std::string> cells_of(std::string_view line) {
  std::vector<std::string> cells(1);
  bool is_quoted = false;
  for (std::size_t at = 0; at < line.size(); ++at) {
    const char c = line[at];
    if (c == '"') {
      if (is_quoted && at + 1 < line.size() && line[at + 1] == '"')
        cells.back() += line[++at];
      else
        is_quoted = !is_quoted;
    } else if (c == ',' && !is_quoted) {
      cells.emplace_back();
    } else {
      cells.back() += c;
    }
  }
  return cells;
}

/// Removes and returns the first line of the text, without its line end.
std::string_view take_line(std::string_view& text) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

/// Appends the numbers of a line to the columns; returns the fault of an invalid line.
std::optional<std::string> add_row(Table& table, std::string_view line) {
  const char *at = line.data(), *const end = line.data() + line.size();
  for (std::size_t column = 0; column < table.columns.size(); ++column) {
    if (column > 0 && (at == end || *at++ != ',')) return fmt::format("has {} numbers, but the first line names {} columns", column, table.columns.size());
    double value = 0;
    const auto [behind, error] = std::from_chars(at, end, value);
    if (error != std::errc()) return fmt::format("has no number in column {} ({})", column + 1, table.names[column]);
    table.columns[column].push_back(value);
    at = behind;
  }
  if (at != end) return fmt::format("has text after its {} numbers", table.columns.size());
  return {};
}

bool begins_at_a_joint(std::string_view quantity, std::string_view word) {
  return quantity.starts_with(word) && (quantity.size() == word.size() || quantity[word.size()] == '.' || quantity[word.size()] == '_');
}

[[noreturn]] void refuse_facts(const std::filesystem::path& file, std::string_view what) {
  throw fccda::InputError(fmt::format("{} {}; use the file as written by the run.", file.string(), what));
}

std::string word_in(const deck::YamlNode& column, std::string_view key) {
  const deck::YamlNode::Entry* entry = column.find(key);
  return entry ? entry->value.text : std::string();
}

ColumnFacts facts_of(const deck::YamlNode& column, const std::string& heading, const std::filesystem::path& file) {
  if (fmt::format("{} [{}]", word_in(column, "name"), word_in(column, "unit")) != heading)
    refuse_facts(file, fmt::format("names a different column where history.csv has {}", heading));
  const std::string kind = word_in(column, "kind");
  if (kind != "instantaneous" && kind != "interval mean" && kind != "cumulative")
    refuse_facts(file, fmt::format("gives {} the kind \"{}\", which is not instantaneous, interval mean or cumulative", heading, kind));
  return {.is_mean = kind == "interval mean", .is_load = word_in(column, "is_load") == "true"};
}

}  // namespace

Table read_table(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file))
    throw fccda::InputError(fmt::format("{} does not exist; give a results folder written by `perimpact run`.", file.string()));
  const std::string contents = fccda::contents_of(file);
  std::string_view text = contents;
  Table table{.file = file, .names = cells_of(take_line(text)), .columns = {}};
  table.columns.resize(table.names.size());
  for (std::size_t line = 2; !text.empty(); ++line)
    if (const auto fault = add_row(table, take_line(text)))
      throw fccda::InputError(fmt::format("{}:{}: this row {}; use the file as written by the run.", file.string(), line, *fault));
  return table;
}

Table read_history(const std::filesystem::path& results) {
  Table table = read_table(output::ResultsFolder::history_in(results));
  const std::filesystem::path file = output::ResultsFolder::history_columns_in(results);
  if (!std::filesystem::exists(file))
    throw fccda::InputError(
        fmt::format("{} does not exist; it describes the columns of history.csv. If an older version wrote the results, start `perimpact run` of this version "
                    "with another folder, which writes the file at once, and copy it from there.",
                    file.string()));
  const deck::YamlNode known = deck::parse_document(fccda::contents_of(file), file.string());
  const deck::YamlNode::Entry* columns = known.find("columns");
  if (!columns || columns->value.items.size() != table.names.size())
    refuse_facts(file, fmt::format("does not describe the {} columns of history.csv", table.names.size()));
  for (std::size_t c = 0; c < table.names.size(); ++c) table.facts.push_back(facts_of(columns->value.items[c], table.names[c], file));
  return table;
}

std::string_view quantity_of(std::string_view column) { return column.substr(0, std::min(column.rfind(" ["), column.size())); }

std::string_view unit_of(std::string_view column) {
  const std::size_t bracket = column.rfind(" [");
  if (bracket == std::string_view::npos || !column.ends_with(']')) return {};
  return column.substr(bracket + 2, column.size() - bracket - 3);
}

std::vector<std::size_t> columns_of_loads(const Table& table) {
  std::vector<std::size_t> chosen;
  for (std::size_t c = 0; c < table.facts.size(); ++c)
    if (table.facts[c].is_load) chosen.push_back(c);
  return chosen;
}

std::vector<std::size_t> columns_named(const Table& table, const std::vector<std::string>& words) {
  std::vector<bool> is_chosen(table.names.size(), false);
  for (const std::string& word : words) {
    bool is_found = false;
    // a whole name is that column alone: total.energy, not total.energy_balance_error
    for (std::size_t c = 1; c < table.names.size(); ++c)
      if (word == table.names[c] || word == quantity_of(table.names[c])) is_chosen[c] = is_found = true;
    if (is_found) continue;
    for (std::size_t c = 1; c < table.names.size(); ++c)
      if (!word.empty() && begins_at_a_joint(quantity_of(table.names[c]), word)) is_chosen[c] = is_found = true;
    if (is_found) continue;
    std::vector<std::string> known;
    for (std::size_t c = 1; c < table.names.size(); ++c) known.emplace_back(quantity_of(table.names[c]));
    const std::string_view meant = fccda::nearest_word(word, known);
    throw fccda::InputError(fmt::format("--columns: {} has no column {}; {}", table.file.string(), word.empty() ? "without a name" : word,
                                        meant.empty() ? "its first line lists the columns." : fmt::format("did you mean {}?", meant)));
  }
  std::vector<std::size_t> chosen;
  for (std::size_t c = 0; c < is_chosen.size(); ++c)
    if (is_chosen[c]) chosen.push_back(c);
  return chosen;
}

}  // namespace perimpact
