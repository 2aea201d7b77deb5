#include "io/results/pressure_area.hpp"

#include <vector>

#include "fccda/respond/nested_areas.hpp"

namespace perimpact {

namespace {

const std::vector<std::string>& process_columns() {
  static const std::vector<std::string> all = {"time [s]", "contact_area [m2]", "mean_contact_area [m2]", "normal_force [N]", "mean_pressure [Pa]"};
  return all;
}

}  // namespace

PressureArea::PressureArea(const output::ResultsFolder& folder, const std::string& impactor, std::uint64_t size) {
  if (size > 0) process_.emplace(process_curve(folder.path(), impactor), process_columns().size(), size);
}

void PressureArea::sync() {
  if (process_) process_->sync();
}

void PressureArea::after_interval(const output::ResultsFolder& folder, const Impactor& impactor) {
  if (!impactor.record().was_in_contact()) return;
  if (!process_) process_.emplace(process_curve(folder.path(), impactor.name()), process_columns());
  const ContactRecord::Interval& interval = impactor.record().interval();
  process_->append(std::vector<double>{interval.time, interval.contact_area, interval.mean_contact_area, interval.normal_force, interval.mean_pressure()});
}

void PressureArea::finish(const output::ResultsFolder& folder, const Impactor& impactor) const {
  constexpr std::size_t rows = 20;
  const std::vector<double>& pressure = impactor.record().peak().panel_pressure;
  if (!process_ || pressure.empty()) return;
  const auto nested = fccda::nested_areas(impactor.record().panels().faces(), pressure, rows);
  if (nested.empty()) return;  // analytic shapes have no panels
  std::vector<double> numbers;
  for (const fccda::NestedArea& area : nested) numbers.insert(numbers.end(), {area.area, area.mean_pressure});
  const std::vector<std::string> columns = {"area [m2]", "mean_pressure [Pa]"};
  output::write_csv(folder.pressure_area() / (impactor.name() + "_at_peak.csv"), columns, numbers);
}

}  // namespace perimpact
