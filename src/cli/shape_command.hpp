/// `perimpact shape`: writes generated surfaces to files.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace perimpact {

/// One option of a shape: a key of its map in the deck.
struct ShapeOption {
  std::string key;   ///< stem_angle, sections.radius
  std::string name;  ///< --stem-angle, --sections-radius
  std::string help;
  std::string required;  ///< its form, "number [m]", if the shape needs it; empty if not
};

struct ShapeKind {
  std::string name;
  std::string_view sentence;
  std::vector<ShapeOption> options;
};

/// All generated surfaces, with options from the deck reference.
const std::vector<ShapeKind>& shape_kinds();

struct ShapeArguments {
  std::string shape;
  std::vector<std::pair<ShapeOption, std::string>> values;  ///< as given
  std::filesystem::path out;                                ///< empty: no output file
};

/// Generates the shape, reports on it and writes it. Exit code 0; throws InputError.
int shape_command(const ShapeArguments& arguments);

/// Lists the shapes with their descriptions.
int list_shapes();

}  // namespace perimpact
