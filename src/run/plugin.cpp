#include "run/plugin.hpp"

#include <cstdlib>
#include <system_error>

namespace perimpact {

namespace fs = std::filesystem;

fs::path plugin_file(const char* library_name, const char* variable) {
  if (const char* const given = std::getenv(variable)) return given;
  std::error_code ignored;
  const fs::path folder = fs::read_symlink("/proc/self/exe", ignored).parent_path();
  for (const fs::path& file : {folder / library_name, folder / PERIMPACT_PLUGIN_FOLDER / library_name})
    if (fs::exists(file, ignored)) return file;
  return {};
}

}  // namespace perimpact
