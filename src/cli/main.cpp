/// The command `perimpact`. CLI11 is slow to compile, so it is included nowhere else.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <new>
#include <system_error>

#include "base/error.hpp"
#include "cli/commands.hpp"
#include "cli/report_command.hpp"
#include "cli/shape_command.hpp"
#include "cli/statistics_command.hpp"

namespace {

using namespace perimpact;

void add_deck_arguments(CLI::App& command, DeckArguments& arguments) {
  command.add_option("deck", arguments.deck, "Deck (YAML)")->required();
  command.add_option("--out", arguments.out, "Folder of the results, in place of output.folder");
  command.add_option("--set", arguments.set, "Change a value of the deck: --set key.path=value (may be repeated)")->allow_extra_args(false);
  command.add_option("--threads", arguments.threads, "Number of threads; all processors where absent")->check(CLI::Range(1, 1024));
}

/// A sub-command for each shape, whose options are the keys of the deck.
void add_shapes(CLI::App& command, ShapeArguments& arguments, int& code) {
  command.require_subcommand(0, 1);
  command.add_flag("--list")->description("The shapes there are");
  for (const ShapeKind& kind : shape_kinds()) {
    CLI::App* shape = command.add_subcommand(kind.name, std::string(kind.sentence));
    shape->add_option("-o,--out", arguments.out, "Writes the surface: an .stl or .obj file");
    for (const ShapeOption& option : kind.options) {
      shape->add_option_function<std::string>(
          option.name, [&arguments, option](const std::string& text) { arguments.values.emplace_back(option, text); }, option.help);
    }
    shape->callback([&arguments, &code, name = kind.name] {
      arguments.shape = name;
      code = shape_command(arguments);
    });
  }
  command.callback([&code, &command] {
    if (command.get_subcommands().empty()) code = list_shapes();
  });
}

void add_statistics(CLI::App& command, StatisticsArguments& arguments) {
  command.add_option("folder", arguments.folder, "Folder of the results")->required();
  command.add_option("--from", arguments.from, "Leaves out what was before this time, such as 5 or \"20 ms\"");
  command.add_option("--to", arguments.to, "Leaves out what was after this time; --channel takes the last picture up to it");
  command
      .add_option("--columns", arguments.columns,
                  "Columns of history.csv in place of the loads: whole names or beginnings such as ship.force, with commas between")
      ->delimiter(',')
      ->allow_extra_args(false);
  command.add_option("--windows", arguments.windows, "Means and extremes over so many equal parts of the time too")->check(CLI::Range(1, 100000));
  command.add_option("--segment", arguments.segment, "Length of the spectrum's windows, a time; a power of two of rows is taken from it");
  command.add_option("--channel", arguments.channel.of, "Width of the channel in a broken sheet, of a body and along an axis: ice:x");
  command.add_option("--channel-from", arguments.channel.from, "Leaves out what is below this on the axis, a length");
  command.add_option("--channel-to", arguments.channel.to, "Leaves out what is above this on the axis, a length");
  command
      .add_option("--sheet", arguments.channel.sheet, "Fragments of this share of the body's particles at least are the sheet that remains beside the channel")
      ->capture_default_str();
}

void add_describe(CLI::App& command, DescribeArguments& arguments, int& code) {
  CLI::Option* key = command.add_option("key", arguments.key, "Key, like poissons_ratio or bodies.material");
  const auto form = [&](const char* name, DescribeForm which, const char* help) {
    return command
        .add_flag_callback(
            name, [&arguments, which] { arguments.form = which; }, help)
        ->excludes(key);
  };
  form("--markdown", DescribeForm::markdown, "The whole reference as a page (docs/guide/deck_reference.md)")
      ->excludes(form("--schema", DescribeForm::schema, "The whole reference as a JSON Schema, for editors (docs/guide/deck.schema.json)"));
  command.callback([&arguments, &code] { code = describe_command(arguments); });
}

void add_new(CLI::App& command, NewArguments& arguments, int& code) {
  command.add_option("what", arguments.starter, "plate, ship or propeller")->required();
  command.add_option("file", arguments.file, "Where the deck goes; plate.yaml and so on where absent");
  command.add_flag("--force", arguments.force, "Write over files that are there");
  command.callback([&arguments, &code] { code = new_command(arguments); });
}

void print_error(const std::string& sentence) { std::fprintf(stderr, "error: %s\n", sentence.c_str()); }

/// What CLI11 found wrong, as one sentence that says where to read on.
std::string usage_error(const CLI::App& app, const CLI::ParseError& error) {
  const auto commands = app.get_subcommands();
  if (!commands.empty()) return fmt::format("{}; perimpact {} --help says more.", error.what(), commands.front()->get_name());
  const auto rest = app.remaining();
  return rest.empty() ? "a command is needed; perimpact --help lists them." : fmt::format("{} is not a command; perimpact --help lists them.", rest.front());
}

/// What was printed can still get lost, where the output goes to a file on a full disk.
void expect_printed() {
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
    throw fccda::RunError(fmt::format("the output cannot be printed: {}. Make room, or print elsewhere.", std::strerror(errno)));
}

int run(int argc, char** argv) {
  CLI::App app{"perimpact: peridynamic bodies struck by rigid bodies of any shape"};
  app.require_subcommand(1);
  app.set_version_flag("--version", "perimpact " PERIMPACT_VERSION);
  int code = 0;

  RunArguments run_arguments;
  CLI::App* run = app.add_subcommand("run", "Run a deck");
  add_deck_arguments(*run, run_arguments);
  run->add_flag("--resume", run_arguments.resume, "Go on from the checkpoint in the folder of the results, with the same deck and --set");
  run->add_flag("--no-report", run_arguments.no_report, "Leave out report.html, which `perimpact report` writes too");
  run->callback([&] { code = run_command(run_arguments); });

  DeckArguments deck;
  CLI::App* check = app.add_subcommand("check", "Check a deck, say what would run, and write surfaces and regions as VTP");
  add_deck_arguments(*check, deck);
  check->callback([&] { code = check_command(deck); });

  DescribeArguments describe;
  add_describe(*app.add_subcommand("describe", "The deck reference, whole or of one key"), describe, code);

  NewArguments starter;
  add_new(*app.add_subcommand("new", "Write a small deck to start from, with comments, that runs in a minute or less"), starter, code);

  MeshArguments mesh;
  CLI::App* mesh_app = app.add_subcommand("mesh", "Report on a surface file: what it holds, what is wrong with it, whether it suits a spacing");
  mesh_app->add_option("file", mesh.file, "Surface file")->required();
  mesh_app->add_option("--part", mesh.parts, "Only this part of the file (may be repeated)")->allow_extra_args(false);
  mesh_app->add_option("--scale", mesh.scale, "Multiplies the coordinates, so that they become metres");
  mesh_app->add_option("--weld", mesh.weld, "Vertices nearer than this become one, such as \"0.1 mm\"");
  mesh_app->add_option("--spacing", mesh.spacing, "Spacing of the particles it shall strike, such as 0.5 or \"20 mm\"");
  mesh_app->add_option("--out", mesh.out, "Writes the surface as made fit: an .stl or .obj file");
  mesh_app->callback([&] { code = mesh_command(mesh); });

  ShapeArguments shape;
  add_shapes(*app.add_subcommand("shape", "Make a surface from its dimensions, report on it and write it: hull, propeller, cylinder, sphere, box"), shape,
             code);

  StatisticsArguments statistics;
  CLI::App* statistics_app = app.add_subcommand("statistics", "Statistics and spectrum of the forces of a run, and the width of a channel in broken ice");
  add_statistics(*statistics_app, statistics);
  statistics_app->callback([&] { code = statistics_command(statistics); });

  ReportArguments report;
  CLI::App* report_app = app.add_subcommand("report", "Show a run in one file for the browser, report.html: particles, impactors, curves, deck, checks");
  report_app->add_option("folder", report.folder, "Folder of the results")->required();
  report_app->add_option("--size", report.megabytes, "The most that the data may take [MB]; larger runs are thinned")
      ->check(CLI::Range(0.01, 500.0))
      ->capture_default_str();
  report_app->callback([&] { code = report_command(report); });

  CLI::App* version = app.add_subcommand("version", "Print the version");
  version->callback([] { fmt::print("perimpact {}\n", PERIMPACT_VERSION); });

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // --help, --version
    print_error(usage_error(app, error));
    return 2;
  }
  return code;
}

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // a file that grows to `ulimit -f` is then an error of writing like a full disk, not the end of the program
  try {
    const int code = run(argc, argv);
    expect_printed();
    return code;
  } catch (const fccda::InputError& error) {
    print_error(error.what());
    return 2;
  } catch (const fccda::RunError& error) {
    print_error(error.what());
    return 3;
  } catch (const std::system_error& error) {  // from fmt, where it cannot print
    print_error(fmt::format("the output cannot be printed: {}. Make room, or print elsewhere.", error.code().message()));
    return 3;
  } catch (const std::bad_alloc&) {
    print_error("there is not enough memory for this set-up; take a larger spacing or fewer panels.");
    return 3;
  }
}
