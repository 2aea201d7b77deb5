#include "io/output/json.hpp"

#include <doctest/doctest.h>

#include <cstdlib>
#include <limits>

using perimpact::output::Json;

TEST_CASE("json: members keep the order in which they were first named") {
  Json run = Json::object();
  run["title"] = "plate";
  run["steps"] = 2000;
  run["timers"]["contact"] = 0.25;
  run["timers"]["forces"] = 61.5;
  run["title"] = "plate impact";
  CHECK(run.text() ==
        "{\n"
        "  \"title\": \"plate impact\",\n"
        "  \"steps\": 2000,\n"
        "  \"timers\": {\n"
        "    \"contact\": 0.25,\n"
        "    \"forces\": 61.5\n"
        "  }\n"
        "}\n");
}

TEST_CASE("json: plain arrays are on one line, arrays of objects are not") {
  Json run;
  run["velocity"] = std::vector<double>{0, -32, 0};
  run["warnings"] = Json::array();
  run["bodies"].push_back(Json::object());
  run["bodies"].push_back(true);
  CHECK(run.text() == "{\n  \"velocity\": [0, -32, 0],\n  \"warnings\": [],\n  \"bodies\": [\n    {},\n    true\n  ]\n}\n");
}

TEST_CASE("json: a number reads back to the same double, and values that are not finite are null") {
  for (const double value : {0.1, 1.0 / 3, 6.02214076e23, -5e-324, 1.7976931348623157e308}) CHECK(std::strtod(Json(value).text().c_str(), nullptr) == value);
  CHECK(Json(std::numeric_limits<double>::quiet_NaN()).text() == "null\n");
  CHECK(Json(-std::numeric_limits<double>::infinity()).text() == "null\n");
  CHECK(Json(std::numeric_limits<std::int64_t>::min()).text() == "-9223372036854775808\n");
}

TEST_CASE("json: quotes, backslashes and control characters are escaped, other characters are unchanged") {
  CHECK(Json("C:\\ice \"Δ = 1\"\n\t\x01").text() == "\"C:\\\\ice \\\"Δ = 1\\\"\\n\\u0009\\u0001\"\n");
}

TEST_CASE("json: line() has the same values on one line, and append() adds the members of another object") {
  Json event = Json::object();
  event["event"] = "end";
  Json members = Json::object();
  members["time [s]"] = 0.5;
  members["bodies"]["plate"]["parts"].push_back(Json::object());
  members["setup"] = Json::verbatim("{\n  \"a\": 1\n}\n");
  members["text"] = "two\nlines";
  event.append(members);
  CHECK(event.line() ==
        "{\"event\": \"end\", \"time [s]\": 0.5, \"bodies\": {\"plate\": {\"parts\": [{}]}}, \"setup\": {   \"a\": 1 }, \"text\": \"two\\nlines\"}\n");
}
