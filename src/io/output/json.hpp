/// JSON for run.json: members in insertion order, numbers that read back to the same double, indentation of two spaces.
///
///   Json run = Json::object();
///   run["title"] = setup.title;
///   run["timers"]["contact"] = 0.31;      // [s]; objects are created on access
///   write_whole_file(path, run.text());
#pragma once

#include <concepts>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "base/contract.hpp"

namespace perimpact::output {

/// A JSON value. JSON has no not-a-number and infinities, which are written as null.
class Json {
 public:
  Json() = default;  ///< null
  Json(bool value) : value_(value) {}
  template <std::integral Integer>
  Json(Integer value) : value_(static_cast<std::int64_t>(value)) {
    EXPECTS(std::in_range<std::int64_t>(value));
  }
  Json(double value) : value_(value) {}
  Json(std::string value) : value_(std::move(value)) {}
  Json(std::string_view value) : value_(std::string(value)) {}
  Json(const char* value) : value_(std::string(value)) {}
  template <class T>
  Json(const std::vector<T>& values) : Json(array()) {
    for (const T& value : values) push_back(value);
  }

  static Json object() { return Json(Value(Members{})); }
  static Json array() { return Json(Value(Elements{})); }
  /// Text that is already JSON; its lines are indented.
  static Json verbatim(std::string json) {
    while (json.ends_with('\n')) json.pop_back();
    return Json(Value(Verbatim{std::move(json)}));
  }

  /// The member of that name, appended where there is none. Null becomes an object.
  /// The reference is valid until the next member is added.
  Json& operator[](std::string_view name);

  void push_back(Json element);  ///< null becomes an array

  void append(const Json& object);  ///< its members; null becomes an object

  std::string text() const;  ///< ends in a new line
  std::string line() const;  ///< in one line, which ends in a new line

 private:
  using Elements = std::vector<Json>;
  using Members = std::vector<std::pair<std::string, Json>>;
  struct Verbatim {
    std::string text;
  };
  using Value = std::variant<std::monostate, bool, std::int64_t, double, std::string, Elements, Members, Verbatim>;

  explicit Json(Value value) : value_(std::move(value)) {}
  void add_to(std::string& text, std::optional<int> level) const;  // without a level on one line

  Value value_;
};

}  // namespace perimpact::output
