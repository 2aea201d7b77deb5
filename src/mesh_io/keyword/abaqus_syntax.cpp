#include "mesh_io/keyword/abaqus_syntax.hpp"
#include "mesh_io/file/text.hpp"

#include <algorithm>

namespace fccda {
namespace {

std::string without_blanks(std::string_view text) {
  std::string out(text);
  std::erase_if(out, [](char c) { return c == ' ' || c == '\t'; });
  return out;
}

std::string_view without_quotes(std::string_view text) {
  const bool is_quoted = text.size() >= 2 && (text.front() == '"' || text.front() == '\'') && text.back() == text.front();
  return is_quoted ? text.substr(1, text.size() - 2) : text;
}

/// The position of the next comma outside quotes, or the end.
std::size_t next_comma(std::string_view text, std::size_t from) {
  char quote = 0;
  for (std::size_t k = from; k < text.size(); ++k) {
    if (quote != 0) {
      if (text[k] == quote) quote = 0;
    } else if (text[k] == '"' || text[k] == '\'') {
      quote = text[k];
    } else if (text[k] == ',') {
      return k;
    }
  }
  return text.size();
}

}  // namespace

const std::string* AbaqusKeyword::find(std::string_view parameter) const {
  const auto found = std::find_if(parameters.begin(), parameters.end(), [&](const auto& one) { return one.first == parameter; });
  return found == parameters.end() ? nullptr : &found->second;
}

bool is_abaqus_comment(std::string_view line) { return trimmed(line).starts_with("**"); }
bool is_abaqus_keyword(std::string_view line) { return trimmed(line).starts_with('*') && !is_abaqus_comment(line); }

AbaqusKeyword abaqus_keyword(Lines& lines) {
  AbaqusKeyword out;
  std::string text(trimmed(lines.line()).substr(1));
  while (text.ends_with(',') && lines.next()) {
    if (!is_abaqus_comment(lines.line())) text += trimmed(lines.line());
  }
  const std::string_view all = text;
  for (std::size_t begin = 0, end = 0; begin <= all.size(); begin = end + 1) {
    end = next_comma(all, begin);
    const std::string_view word = all.substr(begin, end - begin);
    if (begin == 0) {
      out.name = capitals(without_blanks(word));
    } else if (!trimmed(word).empty()) {
      const std::size_t equals = std::min(word.find('='), word.size());
      const std::string_view value = equals < word.size() ? trimmed(word.substr(equals + 1)) : std::string_view{};
      out.parameters.emplace_back(capitals(without_blanks(word.substr(0, equals))), printable(without_quotes(value)));
    }
  }
  return out;
}

void split_abaqus_values(std::string_view line, AbaqusValues& out) {
  out.values.clear();
  std::size_t begin = 0;
  for (std::size_t comma = line.find(','); comma != std::string_view::npos; comma = line.find(',', begin)) {
    out.values.push_back(trimmed(line.substr(begin, comma - begin)));
    begin = comma + 1;
  }
  const std::string_view last = trimmed(line.substr(begin));
  out.goes_on = last.empty() && !out.values.empty();
  if (!last.empty()) out.values.push_back(last);
}

}  // namespace fccda
