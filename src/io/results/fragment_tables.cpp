#include "io/results/fragment_tables.hpp"

#include <algorithm>
#include <vector>

namespace perimpact {

namespace {

const std::vector<std::string>& fragment_columns() {
  static const std::vector<std::string> all = {
      "time [s]", "fragments [-]", "single_particles [-]", "largest [kg]", "second_largest [kg]", "above_1_percent [-]", "outside_largest [kg]"};
  return all;
}

}  // namespace

FragmentTable::FragmentTable(const output::ResultsFolder& folder, const std::string& body, std::uint64_t size) {
  if (size > 0) table_.emplace(table(folder.path(), body), fragment_columns().size(), size);
}

void FragmentTable::after_frame(const output::ResultsFolder& folder, const std::string& body, double time, const Fragments& fragments) {
  if (!table_) table_.emplace(table(folder.path(), body), fragment_columns());
  const FragmentCount count = fragments.count();
  table_->append(std::vector<double>{time, static_cast<double>(count.fragments), static_cast<double>(count.single_particles), count.largest,
                                     count.second_largest, static_cast<double>(count.above_one_percent), count.outside_largest});
}

void FragmentTable::sync() {
  if (table_) table_->sync();
}

void write_last_fragments(const output::ResultsFolder* folder, const Body& body) {
  constexpr std::size_t most = 10'000;
  const Fragments fragments(body.particles, body.family);
  const std::vector<FragmentState> states = states_of(fragments, body.particles, std::min(most, fragments.all().size()));
  std::vector<double> rows;
  for (std::size_t n = 0; n < states.size(); ++n) {
    const Fragment& fragment = fragments.all()[n];
    if (fragment.particles == 1) continue;
    const FragmentState& state = states[n];
    rows.insert(rows.end(), {static_cast<double>(n), static_cast<double>(fragment.particles), fragment.mass});
    for (const Vec3d& v : {state.centre, state.extent, state.velocity}) rows.insert(rows.end(), {v.x, v.y, v.z});
  }
  const std::vector<std::string> columns = {"fragment [-]", "particles [-]", "mass [kg]",    "centre_x [m]",     "centre_y [m]",     "centre_z [m]",
                                            "extent_x [m]", "extent_y [m]",  "extent_z [m]", "velocity_x [m/s]", "velocity_y [m/s]", "velocity_z [m/s]"};
  if (folder) output::write_csv(folder->fragments() / (body.name + "_end.csv"), columns, rows);
}

output::Json fragment_report(const FragmentCount& count) {
  output::Json json = output::Json::object();
  json["fragments"] = count.fragments;
  json["single_particles"] = count.single_particles;
  json["largest [kg]"] = count.largest;
  json["second_largest [kg]"] = count.second_largest;
  json["above_1_percent"] = count.above_one_percent;
  json["outside_largest [kg]"] = count.outside_largest;
  return json;
}

}  // namespace perimpact
