// Particles from a CSV file.
#include "io/deck/point_list.hpp"

#include <doctest/doctest.h>

#include "base/error.hpp"
#include "fixtures/temporary_folder.hpp"
#include "fixtures/tolerance.hpp"

using namespace perimpact;

namespace {

deck::PointList list_of(const std::string& text) {
  const fixtures::TemporaryFolder folder;
  fixtures::put(folder / "cloud.csv", text);
  return deck::read_point_list(folder / "cloud.csv", "deck.yaml:5:1");
}

/// The complaint from the file's name on.
std::string complaint(const std::string& text) {
  try {
    list_of(text);
    return "";
  } catch (const fccda::InputError& error) {
    const std::string sentence = error.what();
    return sentence.substr(sentence.find("cloud.csv"));
  }
}

const std::string header = "x [m], y [m], z [m], volume [m3]\n";

}  // namespace

TEST_CASE("point list: rows are read in order, also without a final newline, with blank lines and a byte order mark") {
  const deck::PointList list = list_of("\xEF\xBB\xBF" + header + "0, 1, 2, 1e-9\n\n-3.5,+4,.5 , 2e-9\r\n1,1,1,3");
  CHECK(list.points == std::vector<fccda::Vec3d>{{0, 1, 2}, {-3.5, 4, 0.5}, {1, 1, 1}});
  CHECK(list.volumes == std::vector<double>{1e-9, 2e-9, 3});
}

TEST_CASE("point list: columns may be in any order and in other units") {
  const deck::PointList list = list_of("\"volume [mm3]\", z [cm], \"y [m]\", x [mm]\n7, 1, 2, 3\n");
  CHECK(norm(list.points[0] - fccda::Vec3d{0.003, 2, 0.01}) < 1e-15);  // rounding of the units
  CHECK(list.volumes[0] == fixtures::relative(7e-9, 1e-14));           // likewise
}

TEST_CASE("point list: errors are reported with their line") {
  CHECK(complaint("x, y, z, volume\n") ==
        "cloud.csv:1: the first line is \"x, y, z, volume\", but it must name the four columns with their units: \"x [m], y [m], z [m], volume [m3]\".");
  CHECK(complaint("x [m], y [m], x [m], volume [m3]\n").starts_with("cloud.csv:1: the first line is"));
  CHECK(complaint("x [m], y [m], volume [m3]\n").starts_with("cloud.csv:1: the first line is"));
  CHECK(complaint("x [m], y [s], z [m], volume [m3]\n").starts_with("cloud.csv:1: the unit of a column is [s], but "));
  CHECK(complaint(header) == "cloud.csv:1: there are no rows of numbers below the header line; add them.");
  CHECK(complaint(header + "0, 0, 0, 1\n0, 0, 1\n") == "cloud.csv:3: \"0, 0, 1\" is not four comma-separated numbers; correct the row.");
  CHECK(complaint(header + "0, 0, 0, 1, 2\n") == "cloud.csv:2: \"0, 0, 0, 1, 2\" is not four comma-separated numbers; correct the row.");
  CHECK(complaint(header + "0, nan, 0, 1\n") == "cloud.csv:2: \"0, nan, 0, 1\" is not four comma-separated numbers; correct the row.");
  CHECK(complaint(header + "0, 0, 0, 1\n0, 1, 0, 0\n") == "cloud.csv:3: the volume is 0 m3, but it must be above 0; correct or remove the row.");
  CHECK(complaint("x [km], y [m], z [m], volume [m3]\n1e306, 0, 0, 1\n") ==
        "cloud.csv:2: the row \"1e306, 0, 0, 1\" has a number that is too large in SI units; correct it.");
  CHECK(complaint(header + "0, 0, 0, -1e-9\n").starts_with("cloud.csv:2: the volume is -1e-09 m3"));
}

TEST_CASE("point list: a missing file is reported at its position in the deck") {
  CHECK_THROWS_WITH_AS(deck::read_point_list("/no/such/cloud.csv", "deck.yaml:5:1"),
                       "deck.yaml:5:1: there is no file /no/such/cloud.csv; relative names start at the deck's folder.", fccda::InputError);
}
