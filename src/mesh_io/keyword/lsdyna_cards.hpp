/// How LS-DYNA keyword files are written: keywords, and cards of fields in fixed columns or between commas (LS-DYNA Keyword User's Manual I, "General Card
/// Format").
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "mesh_io/keyword/lines.hpp"

namespace fccda {

/// Widths of fields: as each keyword says (8, 10 and 16 columns), those below 10 widened to 10 (`I10=Y`, or % behind a keyword), or all of
/// them 20 (`LONG=Y`, or + behind a keyword; - means standard).
enum class LsdynaWidth : std::uint8_t { standard, i10, large };

/// `*ELEMENT_SHELL_THICKNESS %`
struct LsdynaKeyword {
  std::string name;  ///< in capitals, without star and the sign of the width: ELEMENT_SHELL_THICKNESS
  std::string rest;  ///< in capitals: what follows on the line
  LsdynaWidth width = LsdynaWidth::standard;
};

/// The keyword on a line that begins with a star. `usual`: the width where the line says none.
LsdynaKeyword lsdyna_keyword(std::string_view line, LsdynaWidth usual);

/// What `*KEYWORD` says of the width of all fields.
LsdynaWidth lsdyna_usual_width(const LsdynaKeyword& keyword);

/// The fields of one card: between commas where the line has any, else in columns. What is blank or not there is empty.
class LsdynaCard {
 public:
  static constexpr std::size_t most = 10;

  /// `widths`: in the standard form [columns]. Throws InputError through `lines` where columns cannot be counted because of tabs.
  LsdynaCard(const Lines& lines, std::span<const int> widths, LsdynaWidth width);

  std::string_view field(std::size_t k) const { return fields_[k]; }

  /// Numbers; 0 where the field is blank. `what`: what the sentence calls it where there is another text.
  double real(std::size_t k, const std::string& what) const;
  std::int64_t integer(std::size_t k, const std::string& what) const;

 private:
  [[noreturn]] void refuse(std::size_t k, const std::string& what, std::string_view belongs) const;

  const Lines& lines_;
  std::array<std::string_view, most> fields_{};
};

}  // namespace fccda
