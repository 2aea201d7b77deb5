#include "io/deck/motion_table.hpp"

#include <fmt/format.h>

#include <utility>

#include "io/deck/time_series.hpp"
#include "io/deck/yaml_node.hpp"

namespace perimpact::deck {

void check_increasing(const std::vector<double>& times, const std::string& place) {
  for (std::size_t k = 1; k < times.size(); ++k)
    if (times[k] <= times[k - 1]) refuse(place, fmt::format("times contains {} s after {} s, but times must increase.", times[k], times[k - 1]));
}

void check_as_many(std::size_t values, std::size_t times, std::string_view name, const std::string& place) {
  if (values != times) refuse(place, fmt::format("{} has {} values for {} times; give one for each time.", name, values, times));
}

void check_table(const MotionTable& table, const std::string& path, const Places& places) {
  if (!table.file.empty()) {
    for (const std::string_view list : {"times", "velocities", "displacements"})
      if (places.has(fmt::format("{}.{}", path, list)))
        refuse(places.of(fmt::format("{}.{}", path, list)),
               fmt::format("{} is given together with file, which contains times and values; keep one of the two.", list));
    return;
  }
  if (!table.velocities.empty() && !table.displacements.empty())
    refuse(places.of(path + ".displacements"), "displacements is given together with velocities, which determine it; keep one of the two.");
  const bool has_velocities = !table.velocities.empty();
  const std::vector<double>& values = has_velocities ? table.velocities : table.displacements;
  if (table.times.empty() || values.empty()) refuse(places.of(path), fmt::format("{} needs times with velocities or displacements, or a file.", path));
  const std::string list = has_velocities ? "velocities" : "displacements";
  check_as_many(values.size(), table.times.size(), list, places.of(path + "." + list));
  check_increasing(table.times, places.of(path + ".times"));
}

void read_table(MotionTable& table, bool of_rotation, const std::string& path, const std::filesystem::path& folder, const Places& places) {
  if (table.file.empty()) return;
  TimeSeries series = read_time_series(folder / table.file, of_rotation, places.of(path + ".file"));
  table.times = std::move(series.times);
  (series.is_displacement ? table.displacements : table.velocities) = std::move(series.values);
  table.file.clear();
}

}  // namespace perimpact::deck
