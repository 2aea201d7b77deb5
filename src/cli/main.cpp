/// The command `perimpact`. CLI11 is slow to compile, so it is included nowhere else.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <new>

#include "cli/commands.hpp"
#include "fccda/core/error.hpp"

namespace {

using namespace perimpact;

void add_deck_arguments(CLI::App& command, DeckArguments& arguments) {
  command.add_option("deck", arguments.deck, "Deck (YAML)")->required();
  command.add_option("--out", arguments.out, "Folder of the results, in place of output.folder");
  command.add_option("--set", arguments.set, "Change a value of the deck: --set key.path=value (may be repeated)")->allow_extra_args(false);
  command.add_option("--threads", arguments.threads, "Number of threads; all processors where absent")->check(CLI::Range(1, 1024));
}

int run(int argc, char** argv) {
  CLI::App app{"perimpact: peridynamic bodies struck by rigid bodies of any shape"};
  app.require_subcommand(1);
  int code = 0;

  DeckArguments deck;
  CLI::App* run = app.add_subcommand("run", "Run a deck");
  add_deck_arguments(*run, deck);
  run->callback([&] { code = run_command(deck); });

  CLI::App* check = app.add_subcommand("check", "Check a deck, say what would run, and write surfaces and regions as VTP");
  add_deck_arguments(*check, deck);
  check->callback([&] { code = check_command(deck); });

  std::string key;
  CLI::App* describe = app.add_subcommand("describe", "The deck reference, whole or of one key");
  describe->add_option("key", key, "Key, like poissons_ratio or bodies.material");
  bool markdown = false;
  describe->add_flag("--markdown", markdown, "The whole reference as a page (docs/guide/deck_reference.md)");
  describe->callback([&] { code = describe_command(key, markdown); });

  MeshArguments mesh;
  CLI::App* mesh_app = app.add_subcommand("mesh", "Report on a surface file (STL, OBJ)");
  mesh_app->add_option("file", mesh.file, "Surface file")->required();
  mesh_app->add_option("--scale", mesh.scale, "Multiplies the coordinates, so that they become metres")->check(CLI::PositiveNumber);
  mesh_app->callback([&] { code = mesh_command(mesh); });

  CLI::App* version = app.add_subcommand("version", "Print the version");
  version->callback([] { fmt::print("perimpact {}\n", PERIMPACT_VERSION); });

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    const int shown = app.exit(error);
    return shown == 0 ? 0 : 2;
  }
  return code;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const fccda::InputError& error) {
    fmt::print(stderr, "error: {}\n", error.what());
    return 2;
  } catch (const fccda::RunError& error) {
    fmt::print(stderr, "error: {}\n", error.what());
    return 3;
  } catch (const std::bad_alloc&) {
    fmt::print(stderr, "error: there is not enough memory for this set-up; take a larger spacing (perimpact check says how much it needs).\n");
    return 3;
  }
}
