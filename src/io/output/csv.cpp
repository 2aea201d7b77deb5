#include "io/output/csv.hpp"

#include <fmt/format.h>

#include <iterator>

#include "base/contract.hpp"

namespace perimpact::output {

namespace {

/// Quotes names with commas or quotes (RFC 4180), since names come from decks.
std::string quoted(const std::string& name) {
  if (name.find_first_of(",\"\n\r") == std::string::npos) return name;
  std::string text = "\"";
  for (const char c : name) text += c == '"' ? std::string("\"\"") : std::string(1, c);
  return text + '"';
}

void add_row(fmt::memory_buffer& text, std::span<const double> row) { fmt::format_to(std::back_inserter(text), "{}\n", fmt::join(row, ",")); }

}  // namespace

std::string csv_header(std::span<const std::string> columns) {
  std::string text;
  for (const std::string& column : columns) text += (text.empty() ? "" : ",") + quoted(column);
  return text + '\n';
}

CsvWriter::CsvWriter(const std::filesystem::path& path, std::span<const std::string> columns) : columns_(columns.size()), file_(path) {
  file_.append(csv_header(columns));
}

void CsvWriter::append(std::span<const double> row) {
  EXPECTS(row.size() == columns_);
  fmt::memory_buffer text;
  add_row(text, row);
  file_.append({text.data(), text.size()});
}

void write_csv(const std::filesystem::path& path, std::span<const std::string> columns, std::span<const double> rows) {
  EXPECTS(!columns.empty() && rows.size() % columns.size() == 0);
  fmt::memory_buffer text;
  for (; !rows.empty(); rows = rows.subspan(columns.size())) add_row(text, rows.first(columns.size()));
  WholeFile file(path);
  file.write(csv_header(columns));
  file.write(std::string_view(text.data(), text.size()));
  file.finish();
}

}  // namespace perimpact::output
