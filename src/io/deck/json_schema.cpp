#include "io/deck/json_schema.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "io/deck/json_text.hpp"
#include "io/deck/schema.hpp"
#include "io/deck/units.hpp"

namespace perimpact::deck {

using fccda::Range;

namespace {

/// A number with an optional unit; matched as text, because YAML 1.1 also reads 1e-7 as text.
constexpr std::string_view quantity_pattern = R"(^\s*[-+]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][-+]?[0-9]+)?(\s*[^\s0-9.,+-].*|\s+1/.*)?\s*$)";
constexpr std::string_view name_pattern = "^[A-Za-z0-9_-]+$";

/// The members of a JSON object, in the order given.
class Members {
 public:
  void add(std::string_view key, std::string_view value) { all_.push_back(fmt::format("{}: {}", json_string(key), value)); }
  void add_text(std::string_view key, std::string_view text) {
    if (!text.empty()) add(key, json_string(text));
  }
  std::string text() const { return fmt::format("{{{}}}", fmt::join(all_, ", ")); }
  bool empty() const { return all_.empty(); }

 private:
  std::vector<std::string> all_;
};

void add_range(Members& into, const Range& range) {
  if (range.low > -1e300) into.add(range.low_included ? "minimum" : "exclusiveMinimum", json(range.low));
  if (range.high < 1e300) into.add(range.high_included ? "maximum" : "exclusiveMaximum", json(range.high));
}

// Schema of a value of each field type. Keywords for numbers do not apply to text, nor `pattern` to numbers.
Members kind_of_value(double, const Range& range) {
  Members kind;
  kind.add("allOf", R"([{"$ref": "#/definitions/quantity"}])");  // draft-07 ignores keywords next to $ref
  add_range(kind, range);
  return kind;
}
Members kind_of_value(int, const Range& range) {
  Members kind;
  kind.add("type", R"("integer")");
  add_range(kind, range);
  return kind;
}
Members kind_of_value(bool, const Range&) {
  Members kind;
  kind.add("type", R"("boolean")");
  return kind;
}
Members kind_of_value(const std::string&, const Range&) {
  Members kind;
  kind.add("type", R"(["string", "number", "boolean"])");  // a YAML word, whatever its implicit type
  return kind;
}
Members kind_of_value(const Choice& choice, const Range&) {
  Members kind;
  kind.add("enum", json(std::vector<std::string>(choice.words.begin(), choice.words.end())));
  return kind;
}
Members kind_of_value(const Vec3d&, const Range& range) {
  Members kind;
  kind.add("type", R"("array")");
  kind.add("items", kind_of_value(0.0, range).text());
  kind.add("minItems", "3");
  kind.add("maxItems", "3");
  return kind;
}
template <class T>
Members kind_of_value(const std::vector<T>&, const Range& range) {
  Members kind;
  kind.add("type", R"("array")");
  kind.add("items", kind_of_value(T{}, range).text());
  return kind;
}
template <class T>
Members kind_of_value(const std::optional<T>&, const Range& range) {
  return kind_of_value(T{}, range);
}

template <class T>
std::string default_of(const T& value) {
  return json(value);
}
template <class T>
std::string default_of(const std::optional<T>&) {
  return "";
}
std::string default_of(const std::string& value) { return value.empty() ? "" : json(value); }

Members list_of_words(std::span<const std::string_view> words) {
  Members kind;
  kind.add("type", R"("array")");
  kind.add("items", fmt::format(R"({{"enum": {}}})", json(std::vector<std::string>(words.begin(), words.end()))));
  kind.add("uniqueItems", "true");
  return kind;
}

template <class T>
std::string described(const Field<T>& field, const T& defaults) {
  return std::visit(
      [&](auto member) {
        Members property = field.words.empty() ? kind_of_value(defaults.*member, field.range) : list_of_words(field.words);
        const bool has_unit = !field.unit.empty() && field.unit != "1";
        property.add_text("description", has_unit ? fmt::format("[{}] {} For example {}.", field.unit, field.sentence, kind_of(field.unit).example)
                                                  : std::string(field.sentence));
        if (const std::string value = default_of(defaults.*member); field.presence == Presence::optional && !value.empty()) property.add("default", value);
        return property.text();
      },
      field.member);
}

std::string that_has(const std::string& key) { return fmt::format(R"({{"required": [{}]}})", json_string(key)); }

/// One map of the deck; a walker of the schema.
class MapSchema {
 public:
  template <class T>
  void contents(T& defaults) {
    if constexpr (Described<T> && !std::is_empty_v<T>) {
      for (const Field<T>& field : T::fields()) add(std::string(field.name), described(field, defaults), field.presence);
    }
    sections(*this, defaults);
  }

  template <class T>
  void section(std::string_view key, T& defaults, Presence presence, std::string_view sentence) {
    MapSchema inner;
    inner.contents(defaults);
    add(std::string(key), inner.text(sentence), presence);
  }

  template <class T>
  void section(std::string_view key, std::optional<T>&, Presence presence, std::string_view sentence) {
    static T defaults;  // static: as in reference.cpp
    section(key, defaults, presence, sentence);
  }

  template <class T>
  void named(std::string_view key, std::vector<T>&, Presence presence, std::string_view sentence) {
    static T defaults;
    MapSchema element;
    element.contents(defaults);
    Members map;
    map.add("type", presence == Presence::required ? R"("object")" : R"(["object", "null"])");
    map.add_text("description", sentence);
    if (presence == Presence::required) map.add("minProperties", "1");
    map.add("propertyNames", fmt::format(R"({{"pattern": {}}})", json_string(name_pattern)));
    map.add("additionalProperties", element.text(""));
    add(std::string(key), map.text(), presence);
  }

  template <class Variant>
  void one_of(std::string_view key, Variant& variant, Presence presence, std::string_view sentence) {
    MapSchema inner;
    inner.alternatives(variant);
    add(std::string(key), inner.text(sentence), presence);
  }

  template <class Variant>
  void alternatives(Variant& variant) {
    constexpr bool may_be_absent = std::is_same_v<std::variant_alternative_t<0, Variant>, std::monostate>;
    std::vector<std::string> ways;
    for_each_alternative(variant, [&]<class T>(const T&) {
      static T defaults;
      const std::string name(T::name);
      ways.push_back(that_has(name));
      if (!is_written_flat<T>()) return section(T::name, defaults, Presence::optional, "");
      MapSchema flat;
      flat.contents(defaults);
      for (const auto& each : flat.properties_) {
        add(each.first, each.second, Presence::optional);
        if (each.first != name) needs_.emplace_back(each.first, name);
      }
    });
    if (may_be_absent) {
      ways.push_back(fmt::format(R"({{"not": {{"anyOf": [{}]}}}})", fmt::join(ways, ", ")));
    } else {
      needs_something_ = true;
    }
    rules_.push_back(fmt::format(R"({{"oneOf": [{}]}})", fmt::join(ways, ", ")));
  }

  template <class Variant>
  void by_word(std::string_view key, std::string_view selector, Variant& variant, std::string_view sentence) {
    MapSchema inner;
    Members which;
    which.add("enum", json(alternative_names(variant)));
    which.add_text("description", "Selects the alternative.");
    inner.add(std::string(selector), which.text(), Presence::required);
    for_each_alternative(variant, [&]<class T>(const T&) {
      static T defaults;
      MapSchema fields;
      fields.contents(defaults);
      std::vector<std::string> keys = {std::string(selector)};
      Members properties;
      for (const auto& each : fields.properties_) {
        keys.push_back(each.first);
        properties.add(each.first, each.second);
        inner.add(each.first, "true", Presence::optional);
      }
      inner.rules_.push_back(fmt::format(
          R"({{"if": {{"properties": {{{0}: {{"const": {1}}}}}, "required": [{0}]}}, "then": {{"properties": {2}, "propertyNames": {{"enum": {3}}}, )"
          R"("required": {4}}}}})",
          json_string(selector), json_string(T::name), properties.text(), json(keys), json(fields.required_)));
    });
    add(std::string(key), inner.text(sentence), Presence::required);
  }

  std::string text(std::string_view sentence) const {
    Members map;
    map.add("type", required_.empty() && !needs_something_ ? R"(["object", "null"])" : R"("object")");
    map.add_text("description", sentence);
    Members properties, dependencies;
    for (const auto& [key, property] : properties_) properties.add(key, property);
    map.add("properties", properties.text());
    map.add("additionalProperties", "false");
    if (!required_.empty()) map.add("required", json(required_));
    for (const auto& [key, needed] : needs_) dependencies.add(key, fmt::format("[{}]", json_string(needed)));
    if (!dependencies.empty()) map.add("dependencies", dependencies.text());
    if (!rules_.empty()) map.add("allOf", fmt::format("[{}]", fmt::join(rules_, ", ")));
    return map.text();
  }

 private:
  /// A key of several alternatives accepts the values of any of them.
  void add(const std::string& key, const std::string& property, Presence presence) {
    const auto known = std::find_if(properties_.begin(), properties_.end(), [&](const auto& each) { return each.first == key; });
    if (known == properties_.end()) {
      properties_.emplace_back(key, property);
    } else if (known->second != property) {
      known->second = fmt::format(R"({{"anyOf": [{}, {}]}})", known->second, property);
    }
    if (presence == Presence::required) required_.push_back(key);
  }

  std::vector<std::pair<std::string, std::string>> properties_;
  std::vector<std::string> required_;
  std::vector<std::pair<std::string, std::string>> needs_;  // a key, and the alternative that has it
  std::vector<std::string> rules_;
  bool needs_something_ = false;
};

/// One line per member and item; short values stay on one line.
std::string indented(std::string_view compact) {
  constexpr std::size_t width = 140;
  std::string out;
  std::size_t depth = 0;
  const auto new_line = [&] { out.append("\n").append(2 * depth, ' '); };
  std::vector<bool> is_open;  // for each enclosing bracket: over several lines?
  for (std::size_t at = 0; at < compact.size(); ++at) {
    const char c = compact[at];
    if (c == '"') {
      std::size_t end = at + 1;
      while (compact[end] != '"') end += compact[end] == '\\' ? 2 : 1;
      out += compact.substr(at, end + 1 - at);
      at = end;
    } else if (c == '{' || c == '[') {
      std::size_t end = at, level = 0;
      do {
        if (compact[end] == '"') {
          for (++end; compact[end] != '"'; ++end) end += compact[end] == '\\' ? 1 : 0;
        }
        level += compact[end] == '{' || compact[end] == '[' ? 1 : 0;
        level -= compact[end] == '}' || compact[end] == ']' ? 1 : 0;
        ++end;
      } while (level > 0);
      out += c;
      is_open.push_back(2 * depth + end - at > width);
      if (is_open.back()) ++depth, new_line();
    } else if (c == '}' || c == ']') {
      if (is_open.back()) --depth, new_line();
      is_open.pop_back();
      out += c;
    } else if (c == ',' && is_open.back()) {
      out += c;
      new_line();
      ++at;  // the space
    } else {
      out += c;
    }
  }
  return out;
}

}  // namespace

std::string json_schema() {
  Setup defaults;
  MapSchema deck;
  deck.contents(defaults);
  std::string whole = deck.text("Deck of perimpact. `perimpact check` also tests what a schema cannot express.");
  const std::string head = fmt::format(
      R"({{"$schema": "http://json-schema.org/draft-07/schema#", "title": "perimpact deck", "definitions": {{"quantity": {{"type": ["number", "string"], "pattern": {}}}}}, )",
      json_string(quantity_pattern));
  whole.replace(0, 1, head);
  return indented(whole) + "\n";
}

}  // namespace perimpact::deck
