/// `perimpact shape`: surfaces that perimpact makes by itself, as files.
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
};

struct ShapeKind {
  std::string name;
  std::string_view sentence;
  std::vector<ShapeOption> options;
};

/// All surfaces of a deck but that in a file, with the options that the deck reference lists for them.
const std::vector<ShapeKind>& shape_kinds();

struct ShapeArguments {
  std::string shape;
  std::vector<std::pair<ShapeOption, std::string>> values;  ///< as given
  std::filesystem::path out;                                ///< empty: nothing is written
};

/// Makes the shape, says what it is and writes it. Exit code 0; throws InputError.
int shape_command(const ShapeArguments& arguments);

/// The shapes with their sentences.
int list_shapes();

}  // namespace perimpact
