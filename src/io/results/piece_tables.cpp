#include "io/results/piece_tables.hpp"

#include <algorithm>
#include <vector>

namespace perimpact {

namespace {

const std::vector<std::string>& piece_columns() {
  static const std::vector<std::string> all = {
      "time [s]", "pieces [-]", "single_particles [-]", "largest [kg]", "second_largest [kg]", "above_1_percent [-]", "outside_largest [kg]"};
  return all;
}

}  // namespace

PieceTable::PieceTable(const output::ResultsFolder& folder, const std::string& body, std::uint64_t size) {
  if (size > 0) table_.emplace(table(folder.path(), body), piece_columns().size(), size);
}

void PieceTable::after_frame(const output::ResultsFolder& folder, const std::string& body, double time, const Pieces& pieces) {
  if (!table_) table_.emplace(table(folder.path(), body), piece_columns());
  const PieceCount count = pieces.count();
  table_->append(std::vector<double>{time, static_cast<double>(count.pieces), static_cast<double>(count.single_particles), count.largest, count.second_largest,
                                     static_cast<double>(count.above_one_percent), count.outside_largest});
}

void PieceTable::sync() {
  if (table_) table_->sync();
}

void write_last_pieces(const output::ResultsFolder& folder, const Body& body) {
  constexpr std::size_t most = 10'000;
  const Pieces pieces(body.particles, body.family);
  const std::vector<PieceState> states = states_of(pieces, body.particles, std::min(most, pieces.all().size()));
  std::vector<double> rows;
  for (std::size_t n = 0; n < states.size(); ++n) {
    const Piece& piece = pieces.all()[n];
    if (piece.particles == 1) continue;
    const PieceState& state = states[n];
    rows.insert(rows.end(), {static_cast<double>(n), static_cast<double>(piece.particles), piece.mass});
    for (const Vec3d& v : {state.centre, state.extent, state.velocity}) rows.insert(rows.end(), {v.x, v.y, v.z});
  }
  const std::vector<std::string> columns = {"piece [-]",    "particles [-]", "mass [kg]",    "centre_x [m]",     "centre_y [m]",     "centre_z [m]",
                                            "extent_x [m]", "extent_y [m]",  "extent_z [m]", "velocity_x [m/s]", "velocity_y [m/s]", "velocity_z [m/s]"};
  output::write_csv(folder.pieces() / (body.name + "_end.csv"), columns, rows);
}

output::Json piece_report(const PieceCount& count) {
  output::Json json = output::Json::object();
  json["pieces"] = count.pieces;
  json["single_particles"] = count.single_particles;
  json["largest [kg]"] = count.largest;
  json["second_largest [kg]"] = count.second_largest;
  json["above_1_percent"] = count.above_one_percent;
  json["outside_largest [kg]"] = count.outside_largest;
  return json;
}

}  // namespace perimpact
