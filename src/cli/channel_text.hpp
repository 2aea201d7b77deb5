/// Channel width in broken ice, for `perimpact statistics`.
#pragma once

#include <optional>
#include <string>

#include "cli/statistics_command.hpp"

namespace perimpact {

/// Summary of the widths; those of each column are written to fragments/<body>_channel_<axis>.csv. `latest` [s]: of the output frame that
/// is read. Throws InputError.
std::string channel_text(const StatisticsArguments& arguments, std::optional<double> latest);

/// Value of an option with a unit or in SI; empty if the option is empty. Throws InputError.
std::optional<double> quantity_of_option(const char* option, const std::string& text, const char* unit);

}  // namespace perimpact
