/// Syntax of LS-DYNA keyword files: keywords, and cards with fields in fixed columns or separated by commas (LS-DYNA Keyword User's Manual I,
/// "General Card Format").
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "mesh_io/keyword/lines.hpp"

namespace fccda {

/// Field widths: standard for each keyword (8, 10 and 16 columns), widths below 10 widened to 10 (`I10=Y`, or % after a keyword), or all 20
/// (`LONG=Y`, or + after a keyword; - means standard).
enum class LsdynaWidth : std::uint8_t { standard, i10, large };

/// A keyword line such as `*ELEMENT_SHELL_THICKNESS %`.
struct LsdynaKeyword {
  std::string name;  ///< in capitals, without asterisk and width sign: ELEMENT_SHELL_THICKNESS
  std::string rest;  ///< in capitals: the remainder of the line
  LsdynaWidth width = LsdynaWidth::standard;
};

/// The keyword on a line that begins with an asterisk. `usual`: the width where the line gives none.
LsdynaKeyword lsdyna_keyword(std::string_view line, LsdynaWidth usual);

/// The default field width that `*KEYWORD` sets.
LsdynaWidth lsdyna_usual_width(const LsdynaKeyword& keyword);

/// The fields of one card: comma-separated where the line has commas, else in columns. Blank and missing fields are empty.
class LsdynaCard {
 public:
  static constexpr std::size_t most = 10;

  /// `widths`: in standard format [columns]. Throws InputError through `lines` where tabs make the columns ambiguous.
  LsdynaCard(const Lines& lines, std::span<const int> widths, LsdynaWidth width);

  std::string_view field(std::size_t k) const { return fields_[k]; }

  /// Numbers; 0 where the field is blank. `what` names the item in the message for invalid text.
  double real(std::size_t k, const std::string& what) const;
  std::int64_t integer(std::size_t k, const std::string& what) const;

 private:
  [[noreturn]] void refuse(std::size_t k, const std::string& what, std::string_view belongs) const;

  const Lines& lines_;
  std::array<std::string_view, most> fields_{};
};

}  // namespace fccda
