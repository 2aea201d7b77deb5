/// How Abaqus input files are written: keywords with parameters, and data lines of values between commas (Abaqus Analysis User's Guide, "Input syntax rules").
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mesh_io/keyword/lines.hpp"

namespace fccda {

/// `*ELEMENT, TYPE=S4, ELSET=bow`: case and blanks do not count, but for those in quotes.
struct AbaqusKeyword {
  std::string name;                                             ///< in capitals, without blanks and star: ENDPART
  std::vector<std::pair<std::string, std::string>> parameters;  ///< name in capitals, value as written (without quotes); empty where there is none

  const std::string* find(std::string_view parameter) const;  ///< its value; null where it is not given
};

/// What a line is.
bool is_abaqus_comment(std::string_view line);  ///< **
bool is_abaqus_keyword(std::string_view line);  ///< *, first but for blanks

/// The keyword on the current line; where that ends with a comma it goes on in the next line that is no comment.
AbaqusKeyword abaqus_keyword(Lines& lines);

/// The values between the commas of a data line, without the blanks around them. What follows the last comma counts only where it is not blank: then
/// `goes_on` is false.
struct AbaqusValues {
  std::vector<std::string_view> values;
  bool goes_on = false;  ///< the line ends with a comma
};
void split_abaqus_values(std::string_view line, AbaqusValues& out);

}  // namespace fccda
