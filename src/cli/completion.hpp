/// Completion scripts of shells for the table of commands.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cli/command.hpp"

namespace perimpact {

const std::vector<std::string>& shells();  ///< bash, zsh, fish

/// Throws InputError for an unknown shell.
std::string completion_script(const Command& program, const std::string& shell);

}  // namespace perimpact
