#include "io/statistics/table.hpp"

#include <doctest/doctest.h>

#include "fccda/core/error.hpp"
#include "fixtures/temporary_folder.hpp"
#include "io/output/csv.hpp"

using namespace perimpact;
using Numbers = std::vector<std::size_t>;

namespace {

const std::vector<std::string> names = {"time [s]",
                                        "ship.position_x [m]",
                                        "ship.force_x [N]",
                                        "ship.force_y [N]",
                                        "ship.moment_x [N m]",
                                        "ship.contacts [-]",
                                        "ship.bow.force_x [N]",
                                        "ship.bow.moment_x [N m]",
                                        "ship.bow.torque [N m]",
                                        "ice.kinetic_energy [J]",
                                        "ice.grip.force_x [N]",
                                        "ice.grip.work [J]",
                                        "total.momentum_x [kg m/s]"};

std::string complaint(const std::filesystem::path& file) {
  try {
    read_table(file);
  } catch (const fccda::InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("table: what was written is read back to the bit, names with commas and quotes too") {
  const fixtures::TemporaryFolder folder;
  const std::vector<std::string> odd = {"time [s]", "a, \"b\".force_x [N]"};
  const std::vector<double> numbers = {0, 1.0 / 3, 1e-300, -2.5e17};
  output::write_csv(folder / "t.csv", odd, numbers);
  const Table table = read_table(folder / "t.csv");
  CHECK(table.names == odd);
  CHECK(table.rows() == 2);
  CHECK(table.columns == std::vector<std::vector<double>>{{0, 1e-300}, {1.0 / 3, -2.5e17}});
}

TEST_CASE("table: a file that is not there or not whole is refused with its line") {
  const fixtures::TemporaryFolder folder;
  const std::filesystem::path file = folder / "history.csv";
  CHECK(complaint(file) == file.string() + " is not there; name a folder that `perimpact run` has written its results into.");
  const auto said = [&](const std::string& text) {
    fixtures::put(file, text);
    return complaint(file);
  };
  const std::string place = file.string();
  CHECK(said("time [s],f [N]\n0,1\n1,\n") == place + ":3: this row has no number in column 2 (f [N]); take the file as the run wrote it.");
  CHECK(said("time [s],f [N]\n0\n") == place + ":2: this row holds 1 numbers, but the first line names 2 columns; take the file as the run wrote it.");
  CHECK(said("time [s],f [N]\n0,1,2\n") == place + ":2: this row goes on behind its 2 numbers; take the file as the run wrote it.");
  CHECK(said("time [s],f [N]\n0,one\n").find(":2: this row has no number in column 2") != std::string::npos);
  CHECK(said("time [s],f [N]\n0,1\n").empty());
}

TEST_CASE("table: forces, moments and torques are means, momentum and all else are not") {
  const std::vector<std::string> means = {"ship.force_x [N]", "ship.moment_x [N m]", "ship.bow.torque [N m]", "ice.grip.force_x [N]"};
  for (const std::string& name : means) CHECK(is_mean(name));
  for (const char* name : {"total.momentum_x [kg m/s]", "ship.position_x [m]", "ice.grip.work [J]", "time [s]"}) CHECK_FALSE(is_mean(name));
  CHECK(quantity_of("ship.force_x [N]") == "ship.force_x");
  CHECK(unit_of("total.momentum_x [kg m/s]") == "kg m/s");
}

TEST_CASE("table: loads are the forces on impactors, and forces and torques of their gauges, but not of boundaries") {
  CHECK(columns_of_loads({"history.csv", names, {}}) == Numbers{2, 3, 6, 8});
}

TEST_CASE("table: columns are chosen by whole names or by beginnings that end at a joint") {
  const Table table{"r/history.csv", names, {}};
  CHECK(columns_named(table, {"ship.force_x"}) == Numbers{2});
  CHECK(columns_named(table, {"ship.force_x [N]"}) == Numbers{2});
  CHECK(columns_named(table, {"ship.force"}) == Numbers{2, 3});
  CHECK(columns_named(table, {"ship.bow", "ice.kinetic_energy"}) == Numbers{6, 7, 8, 9});
  CHECK(columns_named(table, {"ice.grip.work", "total"}) == Numbers{11, 12});
  const auto said = [&](const std::string& word) {
    try {
      columns_named(table, {word});
    } catch (const fccda::InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  CHECK(said("ship.forse_x") == "--columns: r/history.csv has no column ship.forse_x; did you mean ship.force_x?");
  CHECK(said("zzz") == "--columns: r/history.csv has no column zzz; its first line names those that there are.");
  CHECK(said("ship.for").find("has no column ship.for") != std::string::npos);
  CHECK(said("").find("has no column without a name") != std::string::npos);
}
