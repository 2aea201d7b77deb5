/// Manual pages of the table of commands.
#pragma once

#include <string>

#include "cli/command.hpp"

namespace perimpact {

std::string manual_page(const Command& program);      ///< troff, for man
std::string manual_markdown(const Command& program);  ///< docs/guide/command_line.md

}  // namespace perimpact
