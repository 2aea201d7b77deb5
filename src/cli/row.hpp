/// A line of a report.
#pragma once

#include <fmt/format.h>

#include <string>

namespace perimpact {

/// "  name              value".
inline std::string row(const char* name, const std::string& value) { return fmt::format("  {:<18}{}\n", name, value); }

}  // namespace perimpact
