#include "io/deck/value.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "io/deck/did_you_mean.hpp"
#include "io/deck/expanded_path.hpp"
#include "io/deck/units.hpp"

namespace perimpact::deck {

using fccda::Choice;
using fccda::Range;
using fccda::Vec3d;

namespace {

[[noreturn]] void refuse_value(const YamlNode& node, const Rule& rule, std::string_view but) {
  if (node.kind == YamlNode::Kind::nothing) refuse(node.place, fmt::format("{} has no value; write one, or leave the key out. {}", rule.name, rule.sentence));
  refuse(node.place, fmt::format("{} is {}, but {}", rule.name, node.in_words(), but));
}

/// A number converted to SI, without the range check.
double number(const YamlNode& node, const Rule& rule) {
  const UnitKind& kind = kind_of(rule.unit);
  if (node.kind != YamlNode::Kind::word) refuse_value(node, rule, fmt::format("{} is needed, for example {}.", kind.what, kind.example));
  const Converted converted = to_si(node.text, rule.unit);
  if (!converted.complaint.empty()) refuse_value(node, rule, converted.complaint + ".");
  return converted.value;
}

void refuse_unless_in_range(const YamlNode& node, const Rule& rule, double value) {
  if (rule.range.contains(value)) return;
  const auto allowed = [&] {
    if (rule.unit == "rad")
      return node.text.find("deg") != std::string::npos ? in_degrees(rule.range) : in_words(rule.range) + " rad; write degrees with their unit, as in 30 deg";
    return in_words(rule.range) + (rule.unit == "degC" ? " degC" : "");  // not what is usual with other units, such as kelvin
  };
  refuse_value(node, rule, fmt::format("it must be {}. {}", allowed(), rule.sentence));
}

const std::string& word(const YamlNode& node, const Rule& rule, std::string_view expected) {
  if (node.kind != YamlNode::Kind::word) refuse_value(node, rule, fmt::format("{} is needed. {}", expected, rule.sentence));
  return node.text;
}

std::span<const YamlNode> list(const YamlNode& node, const Rule& rule, std::string_view example) {
  if (node.kind != YamlNode::Kind::list) refuse_value(node, rule, fmt::format("a list is needed, such as {}. {}", example, rule.sentence));
  return node.items;
}

}  // namespace

std::string in_degrees(const Range& range) {
  // bounds are given in radians to four digits
  const auto degrees = [](double radians) { return std::isfinite(radians) ? std::round(radians * 180 / std::numbers::pi * 100) / 100 : radians; };
  return in_words({degrees(range.low), degrees(range.high), range.low_included, range.high_included}) + " deg";
}

std::string in_words(const Range& range) {
  const bool has_low = std::isfinite(range.low), has_high = std::isfinite(range.high);
  if (!has_low && !has_high) return "any number";
  if (has_low && has_high && range.low_included && range.high_included) return fmt::format("from {} to {}", range.low, range.high);
  const std::string low = fmt::format(fmt::runtime(range.low_included ? "at least {}" : "above {}"), range.low);
  const std::string high = fmt::format(fmt::runtime(range.high_included ? "at most {}" : "below {}"), range.high);
  return has_low && has_high ? low + " and " + high : has_low ? low : high;
}

void read_value(const YamlNode& node, const Rule& rule, double& into) {
  into = number(node, rule);
  refuse_unless_in_range(node, rule, into);
}

void read_value(const YamlNode& node, const Rule& rule, std::optional<double>& into) { read_value(node, rule, into.emplace()); }

void read_value(const YamlNode& node, const Rule& rule, int& into) {
  const double value = number(node, rule);
  if (value != std::floor(value) || std::fabs(value) > std::numeric_limits<int>::max())
    refuse_value(node, rule, fmt::format("a whole number is needed. {}", rule.sentence));
  refuse_unless_in_range(node, rule, value);
  into = static_cast<int>(value);
}

void read_value(const YamlNode& node, const Rule& rule, std::optional<int>& into) { read_value(node, rule, into.emplace()); }

void read_value(const YamlNode& node, const Rule& rule, bool& into) {
  const std::string& text = word(node, rule, "true or false");
  if (text != "true" && text != "false") refuse_value(node, rule, fmt::format("true or false is needed. {}", rule.sentence));
  into = text == "true";
}

void read_value(const YamlNode& node, const Rule& rule, std::string& into) {
  into = word(node, rule, "text");
  if (rule.name == "file" || rule.name == "folder") into = expanded_path(into, node.place);
}

void read_value(const YamlNode& node, const Rule& rule, Vec3d& into) {
  if (node.kind != YamlNode::Kind::list) refuse_value(node, rule, fmt::format("three numbers are needed: [x, y, z]. {}", rule.sentence));
  if (node.items.size() != 3)
    refuse(node.place, fmt::format("{} has {} numbers, but three are needed: [x, y, z]. {}", rule.name, node.items.size(), rule.sentence));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::string name = fmt::format("{} of {}", "xyz"[axis], rule.name);
    read_value(node.items[axis], {name, rule.unit, rule.range, rule.sentence}, into[axis]);
  }
}

void read_value(const YamlNode& node, const Rule& rule, std::optional<Vec3d>& into) { read_value(node, rule, into.emplace()); }

void read_value(const YamlNode& node, const Rule& rule, std::vector<double>& into) {
  into.clear();
  for (const YamlNode& item : list(node, rule, fmt::format("[{0}, {0}]", kind_of(rule.unit).example))) read_value(item, rule, into.emplace_back());
}

void read_value(const YamlNode& node, const Rule& rule, std::vector<std::string>& into) {
  into.clear();
  for (const YamlNode& item : list(node, rule, "[a, b]")) read_value(item, rule, into.emplace_back());
}

void read_value(const YamlNode& node, const Rule& rule, std::vector<Vec3d>& into) {
  into.clear();
  const std::span<const YamlNode> points = list(node, rule, "[[0, 0, 0], [1, 0, 0], [1, 1, 0]]");
  for (std::size_t k = 0; k < points.size(); ++k) {
    const std::string name = fmt::format("point {} of {}", k + 1, rule.name);
    read_value(points[k], {name, rule.unit, rule.range, rule.sentence}, into.emplace_back());
  }
}

void read_value(const YamlNode& node, const Rule& rule, Choice& into) {
  const std::vector<std::string> words(into.words.begin(), into.words.end());
  const std::string& text = word(node, rule, fmt::format("one of {}", fmt::join(words, ", ")));
  for (std::size_t index = 0; index < words.size(); ++index) {
    if (words[index] == text) {
      into.index = static_cast<int>(index);
      return;
    }
  }
  const std::string_view nearest = nearest_word(text, words);
  refuse_value(node, rule, fmt::format("it must be one of {}{}", fmt::join(words, ", "), nearest.empty() ? "." : fmt::format("; did you mean {}?", nearest)));
}

}  // namespace perimpact::deck
