/// What `perimpact` can do. Each command returns the exit code: 0, or 130 where Ctrl-C ended a run. Errors are thrown (main.cpp turns
/// InputError into exit code 2 and RunError into 3).
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace perimpact {

/// What the commands that read a deck have in common.
struct DeckArguments {
  std::filesystem::path deck;
  std::vector<std::string> set;    ///< key.path=value
  std::optional<std::string> out;  ///< overrides output.folder
  int threads = 0;                 ///< 0: all processors
};

struct RunArguments : DeckArguments {
  bool resume = false;  ///< go on from the checkpoint in the results folder
};

int run_command(const RunArguments& arguments);
int check_command(const DeckArguments& arguments);

enum class DescribeForm { text, markdown, schema };
struct DescribeArguments {
  std::string key;  ///< of which the text tells; empty: all
  DescribeForm form = DescribeForm::text;
};
int describe_command(const DescribeArguments& arguments);

struct NewArguments {
  std::string starter;         ///< plate, ship, propeller
  std::filesystem::path file;  ///< empty: <starter>.yaml
  bool force = false;          ///< write over files that are there
};
int new_command(const NewArguments& arguments);

struct MeshArguments {
  std::filesystem::path file;
  std::vector<std::string> parts;  ///< all where empty
  double scale = 1;
  std::string weld;           ///< distance, with a unit or in metres; empty: the usual one
  std::string spacing;        ///< with a unit, or in metres; empty: none to compare with
  std::filesystem::path out;  ///< where the surface goes as made fit; empty: nowhere
};
int mesh_command(const MeshArguments& arguments);

}  // namespace perimpact
