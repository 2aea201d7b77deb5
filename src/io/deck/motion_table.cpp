#include "io/deck/motion_table.hpp"

#include <utility>

#include "io/deck/time_series.hpp"

namespace perimpact::deck {

void read_table(MotionTable& table, bool of_rotation, const std::string& path, const std::filesystem::path& folder, const Places& places) {
  if (table.file.empty()) return;
  TimeSeries series = read_time_series(folder / table.file, of_rotation, places.of(path + ".file"));
  table.times = std::move(series.times);
  (series.is_displacement ? table.displacements : table.velocities) = std::move(series.values);
  table.file.clear();
}

}  // namespace perimpact::deck
