/// The part of `perimpact statistics` that tells of a channel in ice.
#pragma once

#include <optional>
#include <string>

#include "cli/statistics_command.hpp"

namespace perimpact {

/// The widths in words; column by column they are written to fragments/<body>_channel_<axis>.csv. `latest` [s]: of the picture that is read. Throws
/// InputError.
std::string channel_text(const StatisticsArguments& arguments, std::optional<double> latest);

/// What an option gives, with a unit or in SI; nothing where it is empty. Throws InputError.
std::optional<double> quantity_of_option(const char* option, const std::string& text, const char* unit);

}  // namespace perimpact
