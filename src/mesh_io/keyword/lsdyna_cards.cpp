#include "mesh_io/keyword/lsdyna_cards.hpp"
#include "mesh_io/file/text.hpp"

#include <algorithm>
#include <optional>

#include "base/contract.hpp"
#include "mesh_io/file/words.hpp"
#include "mesh_io/keyword/fortran_number.hpp"

namespace fccda {
namespace {

std::size_t columns(int standard, LsdynaWidth width) {
  const int at_least = width == LsdynaWidth::large ? 20 : width == LsdynaWidth::i10 ? 10 : 0;
  return static_cast<std::size_t>(std::max(standard, at_least));
}

/// The field width that a sign after a keyword denotes.
std::optional<LsdynaWidth> width_of(char sign) {
  switch (sign) {
    case '+':
      return LsdynaWidth::large;
    case '%':
      return LsdynaWidth::i10;
    case '-':
      return LsdynaWidth::standard;
    default:
      return std::nullopt;
  }
}

}  // namespace

LsdynaKeyword lsdyna_keyword(std::string_view line, LsdynaWidth usual) {
  const std::string all = printable(capitals(trimmed(line.substr(1))));
  const std::size_t end = std::min(all.find_first_of(" \t,"), all.size());
  LsdynaKeyword out{all.substr(0, end), std::string(trimmed(std::string_view(all).substr(end))), usual};
  std::string& sign = out.rest.size() == 1 ? out.rest : out.name;
  if (const auto width = sign.empty() ? std::nullopt : width_of(sign.back())) {
    out.width = *width;
    sign.pop_back();
  }
  return out;
}

LsdynaWidth lsdyna_usual_width(const LsdynaKeyword& keyword) {
  std::string options = keyword.rest;
  std::erase_if(options, [](char c) { return c == ' ' || c == '\t'; });
  const auto says = [&](std::string_view option) { return options.find(option) != std::string::npos; };
  if (says("LONG=Y") || says("LONG=K")) return LsdynaWidth::large;
  return says("I10=Y") ? LsdynaWidth::i10 : LsdynaWidth::standard;
}

LsdynaCard::LsdynaCard(const Lines& lines, std::span<const int> widths, LsdynaWidth width) : lines_(lines) {
  EXPECTS(widths.size() <= most);
  std::string_view rest = lines.line();
  const bool has_commas = rest.find(',') != std::string_view::npos;
  if (!has_commas && rest.find('\t') != std::string_view::npos) lines.fail("the card contains a tab, so its columns are ambiguous; replace tabs by blanks.");
  for (std::size_t k = 0; k < widths.size() && !rest.empty(); ++k) {
    const std::size_t end = std::min(has_commas ? rest.find(',') : columns(widths[k], width), rest.size());
    fields_[k] = trimmed(rest.substr(0, end));
    rest.remove_prefix(std::min(end + (has_commas ? 1 : 0), rest.size()));
  }
}

double LsdynaCard::real(std::size_t k, const std::string& what) const {
  if (field(k).empty()) return 0;
  const std::optional<double> value = fortran_real(field(k));
  if (!value) refuse(k, what, "a finite number");
  return *value;
}

std::int64_t LsdynaCard::integer(std::size_t k, const std::string& what) const {
  if (field(k).empty()) return 0;
  const std::optional<std::int64_t> value = fortran_integer(field(k));
  if (!value) refuse(k, what, "an integer");
  return *value;
}

void LsdynaCard::refuse(std::size_t k, const std::string& what, std::string_view belongs) const {
  const bool is_parameter = field(k).find('&') != std::string_view::npos;
  lines_.fail(what + " has " + shown(field(k)) + " where " + std::string(belongs) + " is expected; " +
              (is_parameter ? "parameters are not supported: write the number itself." : "correct the file or export it again."));
}

}  // namespace fccda
