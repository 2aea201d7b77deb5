/// Column of history.csv: name, unit and kind of values. Programs read these from history.json, which a run writes with the table, and do
/// not infer them from names.
#pragma once

#include <string>
#include <string_view>

namespace perimpact {

enum class ColumnKind {
  instantaneous,  ///< the value at the time of the row
  interval_mean,  ///< mean since the previous row; the sum of mean times interval is exact
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
  std::string meaning;   ///< a description without full stop
  bool is_load = false;  ///< forces on impactors, forces and torques of their gauges: the default columns of statistics

  std::string heading() const { return name + " [" + unit + "]"; }  ///< in history.csv
};

}  // namespace perimpact
