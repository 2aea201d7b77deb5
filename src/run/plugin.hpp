/// Libraries that the program opens at run time, because what they need is missing on most machines.
#pragma once

#include <filesystem>

namespace perimpact {

/// The library that the environment variable names, or that of this name beside the program (build tree) or installed with it; empty if there is none.
std::filesystem::path plugin_file(const char* library_name, const char* variable);

}  // namespace perimpact
