/// Commands of `perimpact`. Each returns the exit code: 0, or 128 and the number of the signal that ended a run. Errors are thrown (main.cpp turns InputError
/// into exit code 2 and RunError into 3).
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cli/messages.hpp"
#include "perimpact/ranks/network.hpp"

namespace perimpact {

/// Arguments common to commands that read a deck.
struct DeckArguments {
  std::filesystem::path deck;
  std::vector<std::string> set;    ///< key.path=value
  std::optional<std::string> out;  ///< overrides output.folder
  int threads = 0;                 ///< 0: all processors
  MessageArguments messages;
};

struct RunArguments : DeckArguments {
  bool resume = false;  ///< restart from the checkpoint in the results folder
  bool force = false;   ///< replace the run in the results folder
  bool no_report = false;
  std::string progress = "line";  ///< or json
  int ranks = 0;                  ///< processes that a launcher has started together; 0: as its environment says
  std::string device = "cpu";     ///< one of device_words
};

struct CheckArguments : DeckArguments {
  bool json = false;
  int ranks = 0;    ///< of the run that is forecast; 0: one process
  Network network;  ///< between these
};

int run_command(const RunArguments& arguments);
int check_command(const CheckArguments& arguments);

struct DescribeArguments {
  std::string key;              ///< to describe; empty: all
  std::filesystem::path pages;  ///< folder of the Markdown pages; empty: none
  bool is_schema = false;
};
int describe_command(const DescribeArguments& arguments);

struct NewArguments {
  std::string starter;         ///< plate, ship, propeller
  std::filesystem::path file;  ///< empty: <starter>.yaml
  bool force = false;          ///< overwrite existing files
};
int new_command(const NewArguments& arguments);

struct MeshArguments {
  std::filesystem::path file;
  std::vector<std::string> parts;  ///< all where empty
  double scale = 1;
  std::string weld;           ///< tolerance, with a unit or in metres; empty: the default
  std::string spacing;        ///< with a unit or in metres; empty: no comparison
  std::filesystem::path out;  ///< output file of the repaired surface; empty: none
};
int mesh_command(const MeshArguments& arguments);

}  // namespace perimpact
