/// What a column of history.csv is: its name and unit, and what its rows are. Programs that read the table take this from history.json,
/// which a run writes beside it, and never from names.
#pragma once

#include <string>
#include <string_view>

namespace perimpact {

enum class ColumnKind {
  instantaneous,  ///< the value at the time of the row
  interval_mean,  ///< the mean since the row before: its sum times the intervals is exact
  cumulative,     ///< the sum since the start, at the time of the row
};

constexpr std::string_view word_for(ColumnKind kind) {
  switch (kind) {
    case ColumnKind::instantaneous:
      return "instantaneous";
    case ColumnKind::interval_mean:
      return "interval mean";
    case ColumnKind::cumulative:
      return "cumulative";
  }
  return "";
}

struct Column {
  std::string name;  ///< "cylinder.force_y"
  std::string unit;  ///< "N"
  ColumnKind kind;
  std::string meaning;   ///< a sentence without its full stop
  bool is_load = false;  ///< forces on impactors, forces and torques of their gauges: what statistics reads where nothing else is asked for

  std::string heading() const { return name + " [" + unit + "]"; }  ///< in history.csv
};

}  // namespace perimpact
