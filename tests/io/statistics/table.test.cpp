#include "io/statistics/table.hpp"

#include <doctest/doctest.h>

#include "base/error.hpp"
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

TEST_CASE("table: numbers are read back bitwise, and names with commas and quotes unchanged") {
  const fixtures::TemporaryFolder folder;
  const std::vector<std::string> odd = {"time [s]", "a, \"b\".force_x [N]"};
  const std::vector<double> numbers = {0, 1.0 / 3, 1e-300, -2.5e17};
  output::write_csv(folder / "t.csv", odd, numbers);
  const Table table = read_table(folder / "t.csv");
  CHECK(table.names == odd);
  CHECK(table.rows() == 2);
  CHECK(table.columns == std::vector<std::vector<double>>{{0, 1e-300}, {1.0 / 3, -2.5e17}});
}

TEST_CASE("table: a missing or damaged file is refused with its line") {
  const fixtures::TemporaryFolder folder;
  const std::filesystem::path file = folder / "history.csv";
  CHECK(complaint(file) == file.string() + " does not exist; give a results folder written by `perimpact run`.");
  const auto message = [&](const std::string& text) {
    fixtures::put(file, text);
    return complaint(file);
  };
  const std::string place = file.string();
  CHECK(message("time [s],f [N]\n0,1\n1,\n") == place + ":3: this row has no number in column 2 (f [N]); use the file as written by the run.");
  CHECK(message("time [s],f [N]\n0\n") == place + ":2: this row has 1 numbers, but the first line names 2 columns; use the file as written by the run.");
  CHECK(message("time [s],f [N]\n0,1,2\n") == place + ":2: this row has text after its 2 numbers; use the file as written by the run.");
  CHECK(message("time [s],f [N]\n0,one\n").find(":2: this row has no number in column 2") != std::string::npos);
  CHECK(message("time [s],f [N]\n0,1\n").empty());
}

TEST_CASE("table: history.json determines the kind of a history column, whatever its name") {
  const fixtures::TemporaryFolder folder;
  const auto column = [](const char* name, const char* unit, const char* kind, const char* more = "") {
    return std::string("{\"name\": \"") + name + "\", \"unit\": \"" + unit + "\", \"kind\": \"" + kind + "\"" + more + "}";
  };
  const std::string time = column("time", "s", "instantaneous");
  const auto facts = [&](const std::vector<std::string>& columns) {
    std::string text = "{\"format\": 1, \"columns\": [";
    for (const std::string& one : columns) text += (text.back() == '[' ? "" : ", ") + one;
    fixtures::put(folder / "history.json", text + "]}\n");
  };
  fixtures::put(folder / "history.csv", "time [s],ship.water_force_z [N],ship.force_x [N],ship.bow [N m]\n0,0,0,0\n1,2,3,4\n");
  facts({time, column("ship.water_force_z", "N", "interval mean"), column("ship.force_x", "N", "instantaneous"),
         column("ship.bow", "N m", "cumulative", ", \"is_load\": true")});
  const Table table = read_history(folder.path());
  REQUIRE(table.facts.size() == 4);
  CHECK((!table.facts[0].is_mean && table.facts[1].is_mean && !table.facts[2].is_mean && !table.facts[3].is_mean));
  CHECK(columns_of_loads(table) == Numbers{3});

  const auto message = [&] {
    try {
      read_history(folder.path());
    } catch (const fccda::InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  const std::string place = (folder / "history.json").string();
  facts({time, column("ship.water_force_z", "N", "interval mean")});
  CHECK(message() == place + " does not describe the 4 columns of history.csv; use the file as written by the run.");
  facts({time, column("ship.water_force_z", "N", "mean"), time, time});
  CHECK(message() ==
        place +
            " gives ship.water_force_z [N] the kind \"mean\", which is not instantaneous, interval mean or cumulative; use the file as written by the run.");
  facts({time, column("ship.force_x", "N", "instantaneous"), time, time});
  CHECK(message() == place + " names a different column where history.csv has ship.water_force_z [N]; use the file as written by the run.");
  std::filesystem::remove(folder / "history.json");
  CHECK(message().starts_with(place + " does not exist; it describes the columns of history.csv."));
}

TEST_CASE("table: a column's heading consists of its quantity and its unit") {
  CHECK(quantity_of("ship.force_x [N]") == "ship.force_x");
  CHECK(unit_of("total.momentum_x [kg m/s]") == "kg m/s");
}

TEST_CASE("table: columns are selected by full names or by prefixes that end at a separator") {
  const Table table{"r/history.csv", names, {}, {}};
  CHECK(columns_named(table, {"ship.force_x"}) == Numbers{2});
  CHECK(columns_named(table, {"ship.force_x [N]"}) == Numbers{2});
  CHECK(columns_named(table, {"ship.force"}) == Numbers{2, 3});
  CHECK(columns_named(table, {"ship.bow", "ice.kinetic_energy"}) == Numbers{6, 7, 8, 9});
  CHECK(columns_named(table, {"ice.grip.work", "total"}) == Numbers{11, 12});
  const auto message = [&](const std::string& word) {
    try {
      columns_named(table, {word});
    } catch (const fccda::InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  CHECK(message("ship.forse_x") == "--columns: r/history.csv has no column ship.forse_x; did you mean ship.force_x?");
  CHECK(message("zzz") == "--columns: r/history.csv has no column zzz; its first line lists the columns.");
  CHECK(message("ship.for").find("has no column ship.for") != std::string::npos);
  CHECK(message("").find("has no column without a name") != std::string::npos);
}
