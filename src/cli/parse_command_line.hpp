/// Parses a command line by the table of commands.
#pragma once

#include <functional>

#include "cli/command.hpp"

namespace perimpact {

/// Sets the options and returns what is to be run: a command, or the help that was asked for. Throws InputError.
std::function<int()> parse_command_line(const Command& program, int argc, const char* const* argv);

}  // namespace perimpact
