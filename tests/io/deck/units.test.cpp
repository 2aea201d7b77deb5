#include "io/deck/units.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <thread>
#include <vector>

#include "fixtures/tolerance.hpp"
#include "io/deck/reference.hpp"

using perimpact::deck::to_si;

namespace {
double si(std::string_view text, std::string_view unit) {
  const auto converted = to_si(text, unit);
  CHECK_MESSAGE(converted.complaint == "", text);
  return converted.value;
}
std::string complaint(std::string_view text, std::string_view unit) { return to_si(text, unit).complaint; }
}  // namespace

TEST_CASE("units: powers of ten give the same double as the plain number") {
  CHECK(si("0.1 us", "s") == 0.1e-6);
  CHECK(si("0.1 µs", "s") == 0.1e-6);
  CHECK(si("200 us", "s") == 200e-6);
  CHECK(si("9 mm", "m") == 0.009);
  CHECK(si("1.1e1 mm", "m") == 0.011);
  CHECK(si("2.5E+3 km", "m") == 2.5e6);
  CHECK(si("191 GPa", "Pa") == 191e9);
  CHECK(si("0.917 g/cm3", "kg/m3") == 917);
  CHECK(si("8000 kg/m^3", "kg/m3") == 8000);
  CHECK(si("32 m/s", "m/s") == 32);
  CHECK(si("2 t", "kg") == 2000);
  CHECK(si("35 g cm2", "kg m2") == 35e-7);
  CHECK(si("0.5 1/s", "1/s") == 0.5);
  CHECK(si("2 1/ms", "1/s") == 2000);
  CHECK(si("3 Hz", "1/s") == 3);
  CHECK(si("981 cm/s2", "m/s2") == 9.81);
}

TEST_CASE("units: zero is zero with any exponent and unit") {
  for (const char* text : {"0 km", "0e2147483647 km", "0e-2147483648 mm", "-0.0e99999 km"}) {
    CAPTURE(text);
    CHECK(si(text, "m") == 0);
  }
}

TEST_CASE("units: plain numbers are SI, whatever the sign, decimal point or spacing") {
  CHECK(si("0.25", "1") == 0.25);
  CHECK(si("-32", "m/s") == -32);
  CHECK(si("+.5", "m") == 0.5);
  CHECK(si("191GPa", "Pa") == 191e9);
  CHECK(si("  5 mm ", "m") == 0.005);
  CHECK(si("25 %", "1") == 0.25);
}

TEST_CASE("units: kn is the knot, kN the kilonewton, and angles are converted to radians") {
  // the factors are exact by definition; 1e-15 forgives the rounding of the factor in UDUNITS and of the product
  CHECK(si("3 kn", "m/s") == fixtures::relative(3 * 1852.0 / 3600, 1e-15));
  CHECK(si("5 kN", "N") == 5000);
  CHECK(complaint("5 kn", "N") == "that is a velocity; write a force, for example 5 kN");
  CHECK(si("30 rpm", "rad/s") == fixtures::relative(std::numbers::pi, 1e-15));
  CHECK(si("90 deg/s", "rad/s") == fixtures::relative(std::numbers::pi / 2, 1e-15));
  CHECK(si("45 deg", "rad") == fixtures::relative(std::numbers::pi / 4, 1e-15));
}

TEST_CASE("units: the unit of every deck key is known") {
  for (const perimpact::deck::Entry& entry : perimpact::deck::reference()) {
    const std::size_t open = entry.form.find('['), close = entry.form.find(']');
    if (open == std::string::npos || close == std::string::npos) continue;
    const std::string unit = entry.form.substr(open + 1, close - open - 1);
    const auto kinds = perimpact::deck::unit_kinds();
    CHECK_MESSAGE(std::any_of(kinds.begin(), kinds.end(), [&](const perimpact::deck::UnitKind& kind) { return kind.unit == unit; }), entry.path, " [", unit,
                  "]");
  }
  CHECK(si("9.81 m/s2", "m/s2") == 9.81);
  CHECK(si("30 1/min", "1/s") == fixtures::relative(0.5, 1e-15));
  CHECK(complaint("3 1/2 s", "s") == "1/2 s is not a unit; write a time, for example 0.1 us");  // not 1.5 s
}

TEST_CASE("units: cycles and angles are not confused") {
  CHECK(complaint("3 Hz", "rad/s") ==
        "Hz counts cycles, not angle, and is not converted; write an angular velocity in rad/s, deg/s or rpm, for example 30 rpm");
  CHECK(complaint("3 1/s", "rad/s") != "");
  CHECK(complaint("30 rpm", "Hz") == "rpm counts angle, not cycles, and is not converted; write a frequency in Hz, for example 3 Hz");
  CHECK(complaint("3 deg", "1") != "");
  CHECK(complaint("3 rad", "1") != "");
}

TEST_CASE("units: another dimension is refused with the required one") {
  CHECK(complaint("5 kg", "m") == "that is a mass; write a length, for example 9 mm");
  CHECK(complaint("5 m", "s") == "that is a length; write a time, for example 0.1 us");
  CHECK(complaint("5 Hz", "s") == "that is a frequency; write a time, for example 0.1 us");  // UDUNITS would make it 0.2 s
  CHECK(complaint("5 A", "m") == "that is in A; write a length, for example 9 mm");
  CHECK(complaint("3 mm", "1") == "it is a pure number and has no unit; write a number, for example 0.25");
  CHECK(complaint("5 m @ 3", "m") != "");       // a shifted origin
  CHECK(complaint("5 degC", "m") != "");        // another
  CHECK(complaint("5 lg(re 1 m)", "m") != "");  // a logarithm
}

TEST_CASE("units: invalid numbers and units are refused") {
  CHECK(complaint("thick", "m") == "that is not a number; write a length, for example 9 mm");
  for (const char* text : {"", " ", "mm", "--5", "+-5", "nan", "inf", "-inf m", "infinity", "0x", ". m", "e5"}) CHECK_MESSAGE(complaint(text, "m") != "", text);
  CHECK(complaint("5 mn", "m") == "mn is not a unit; write a length, for example 9 mm");
  CHECK(complaint("1,5 m", "m") == ",5 m is not a unit; write a length, for example 9 mm");
  CHECK(complaint("2 3 m", "m") != "");  // UDUNITS would multiply
  CHECK(complaint("2 1/2 m", "m") != "");
  CHECK(complaint("5 m/", "m") != "");
  CHECK(complaint("1e999 m", "m") == "the number is outside the range of double precision; use one between 1e-300 and 1e300");
  CHECK(complaint("5 " + std::string(100'000, '('), "m") != "");
}

TEST_CASE("units: UDUNITS knows every unit of the tables, and its example is valid") {
  for (const auto& kind : perimpact::deck::unit_kinds()) {
    CHECK_MESSAGE(complaint(kind.example, kind.unit) == "", kind.what);
    CHECK_MESSAGE(si("1 " + std::string(kind.unit == "1" ? "" : kind.unit), kind.unit) == 1, kind.what);
  }
}

TEST_CASE("units: conversion is thread-safe") {
  std::vector<std::thread> threads;
  std::vector<int> wrong(4, 0);
  for (std::size_t t = 0; t < wrong.size(); ++t)
    threads.emplace_back([&wrong, t] {
      for (int i = 0; i < 500; ++i) wrong[t] += to_si("9 mm", "m").value != 0.009;
    });
  for (std::thread& thread : threads) thread.join();
  CHECK(wrong == std::vector<int>(4, 0));
}
