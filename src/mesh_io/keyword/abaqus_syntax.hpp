/// Syntax of Abaqus input files: keywords with parameters, and comma-separated data lines (Abaqus Analysis User's Guide, "Input syntax rules").
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mesh_io/keyword/lines.hpp"

namespace fccda {

/// A keyword line such as `*ELEMENT, TYPE=S4, ELSET=bow`; case and blanks are ignored outside quotes.
struct AbaqusKeyword {
  std::string name;                                             ///< in capitals, without blanks and star: ENDPART
  std::vector<std::pair<std::string, std::string>> parameters;  ///< name in capitals, value as written without quotes; the value may be empty

  const std::string* find(std::string_view parameter) const;  ///< value of the parameter; nullptr where it is absent
};

/// Classification of a line.
bool is_abaqus_comment(std::string_view line);  ///< **
bool is_abaqus_keyword(std::string_view line);  ///< *, after optional blanks

/// The keyword on the current line; a trailing comma continues it on the next non-comment line.
AbaqusKeyword abaqus_keyword(Lines& lines);

/// The comma-separated values of a data line, trimmed. A blank field after the last comma is not a value; it sets `goes_on`.
struct AbaqusValues {
  std::vector<std::string_view> values;
  bool goes_on = false;  ///< the line ends with a comma
};
void split_abaqus_values(std::string_view line, AbaqusValues& out);

}  // namespace fccda
