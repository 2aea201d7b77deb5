#include "perimpact/deck_model/motion_table.hpp"

#include <fmt/format.h>

#include "perimpact/deck_model/setup_error.hpp"

namespace perimpact {

void check_increasing(const std::vector<double>& arguments, const std::string& key, const TableArgument& argument) {
  for (std::size_t k = 1; k < arguments.size(); ++k)
    if (arguments[k] <= arguments[k - 1])
      throw SetupError(key,
                       fmt::format("{0} contains {2} {1} after {3} {1}, but {0} must increase.", argument.list, argument.unit, arguments[k], arguments[k - 1]));
}

void check_as_many(std::size_t values, std::size_t arguments, std::string_view name, const std::string& key, const TableArgument& argument) {
  if (values != arguments)
    throw SetupError(key, fmt::format("{} has {} values for {} {}; give one for each {}.", name, values, arguments, argument.list, argument.name));
}

void check_table(const MotionTable& table, const std::string& key, const Places& places) {
  if (!table.file.empty()) {
    for (const std::string_view list : {"times", "velocities", "displacements"})
      if (places.has(fmt::format("{}.{}", key, list)))
        throw SetupError(fmt::format("{}.{}", key, list),
                         fmt::format("{} is given together with file, which contains times and values; keep one of the two.", list));
    return;
  }
  if (!table.velocities.empty() && !table.displacements.empty())
    throw SetupError(key + ".displacements", "displacements is given together with velocities, which determine it; keep one of the two.");
  const bool has_velocities = !table.velocities.empty();
  const std::vector<double>& values = has_velocities ? table.velocities : table.displacements;
  if (table.times.empty() || values.empty()) throw SetupError(key, fmt::format("{} needs times with velocities or displacements, or a file.", key));
  const std::string list = has_velocities ? "velocities" : "displacements";
  check_as_many(values.size(), table.times.size(), list, key + "." + list);
  check_increasing(table.times, key + ".times");
}

}  // namespace perimpact
