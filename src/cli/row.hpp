/// Text of reports: a line, and a number of things.
#pragma once

#include <fmt/format.h>

#include <string>

namespace perimpact {

/// "  name              value".
inline std::string row(const char* name, const std::string& value) { return fmt::format("  {:<18}{}\n", name, value); }

/// "1 thread", "2 threads".
inline std::string counted(int number, const char* noun) { return fmt::format("{} {}{}", number, noun, number == 1 ? "" : "s"); }

}  // namespace perimpact
