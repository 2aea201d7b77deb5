/// Reads one value of a deck as the type of its field. Throws InputError at the value's position if its type or unit does not match or it
/// is out of range.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/parameter.hpp"
#include "io/deck/yaml_node.hpp"

namespace perimpact::deck {

/// Constraints on a value: a row of the field table, without its struct.
struct Rule {
  std::string_view name;
  std::string_view unit;
  fccda::Range range;
  std::string_view sentence;
};

/// "above 0", "from 2 to 6", "above -1 and below 0.5"; "any number" where all are allowed.
std::string in_words(const fccda::Range& range);
/// The same in degrees, of a range in radians: "from -30 to 60 deg".
std::string in_degrees(const fccda::Range& range);

void read_value(const YamlNode& node, const Rule& rule, double& into);
void read_value(const YamlNode& node, const Rule& rule, std::optional<double>& into);
void read_value(const YamlNode& node, const Rule& rule, int& into);
void read_value(const YamlNode& node, const Rule& rule, std::optional<int>& into);
void read_value(const YamlNode& node, const Rule& rule, bool& into);
void read_value(const YamlNode& node, const Rule& rule, std::string& into);
void read_value(const YamlNode& node, const Rule& rule, fccda::Vec3d& into);
void read_value(const YamlNode& node, const Rule& rule, std::optional<fccda::Vec3d>& into);
void read_value(const YamlNode& node, const Rule& rule, std::vector<double>& into);
void read_value(const YamlNode& node, const Rule& rule, std::vector<std::string>& into);
void read_value(const YamlNode& node, const Rule& rule, std::vector<fccda::Vec3d>& into);
void read_value(const YamlNode& node, const Rule& rule, fccda::Choice& into);

}  // namespace perimpact::deck
