/// The command `perimpact`. Only this file includes CLI11, which is slow to compile.
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
  command.add_option("--threads", arguments.threads, "Number of threads; all processors by default")->check(CLI::Range(1, 1024));
}

/// One subcommand per shape, with the deck keys as options.
void add_shapes(CLI::App& command, ShapeArguments& arguments, int& code) {
  command.require_subcommand(0, 1);
  command.add_flag("--list")->description("Lists the available shapes");
  for (const ShapeKind& kind : shape_kinds()) {
    CLI::App* shape = command.add_subcommand(kind.name, std::string(kind.sentence));
    shape->add_option("-o,--out", arguments.out, "Output file of the surface: .stl or .obj");
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
  command.add_option("--from", arguments.from, "Start time, such as 5 or \"20 ms\"; earlier rows are ignored");
  command.add_option("--to", arguments.to, "End time; later rows are ignored, and --channel uses the last frame up to it");
  command.add_option("--columns", arguments.columns, "Columns of history.csv in place of the loads: comma-separated names or prefixes such as ship.force")
      ->delimiter(',')
      ->allow_extra_args(false);
  command.add_option("--windows", arguments.windows, "Also mean and extremes over this many equal parts of the time")->check(CLI::Range(1, 100000));
  command.add_option("--segment", arguments.segment, "Length of the spectrum's windows, a time; rounded down to a power of two of rows");
  command.add_option("--channel", arguments.channel.of, "Width of the channel in a broken sheet of a body along an axis: ice:x");
  command.add_option("--channel-from", arguments.channel.from, "Lower end on the axis, a length");
  command.add_option("--channel-to", arguments.channel.to, "Upper end on the axis, a length");
  command
      .add_option("--sheet", arguments.channel.sheet, "Fragments with at least this share of the body's particles belong to the intact sheet along the channel")
      ->capture_default_str();
}

void add_describe(CLI::App& command, DescribeArguments& arguments, int& code) {
  CLI::Option* key = command.add_option("key", arguments.key, "Key, such as poissons_ratio or bodies.material");
  CLI::Option* markdown = command.add_option_function<std::string>(
      "--markdown",
      [&arguments](const std::string& folder) {
        arguments.form = DescribeForm::markdown;
        arguments.folder = folder;
      },
      "Write the whole reference as Markdown pages to this folder (docs/guide/deck)");
  CLI::Option* schema = command.add_flag_callback(
      "--schema", [&arguments] { arguments.form = DescribeForm::schema; }, "The whole reference as a JSON Schema, for editors (docs/guide/deck.schema.json)");
  markdown->excludes(key)->excludes(schema);
  schema->excludes(key);
  command.callback([&arguments, &code] { code = describe_command(arguments); });
}

void add_new(CLI::App& command, NewArguments& arguments, int& code) {
  command.add_option("what", arguments.starter, "plate, ship or propeller")->required();
  command.add_option("file", arguments.file, "Path of the new deck; plate.yaml and so on by default");
  command.add_flag("--force", arguments.force, "Overwrite existing files");
  command.callback([&arguments, &code] { code = new_command(arguments); });
}

void print_error(const std::string& sentence) { std::fprintf(stderr, "error: %s\n", sentence.c_str()); }

/// Error of CLI11 as one sentence with the relevant help command.
std::string usage_error(const CLI::App& app, const CLI::ParseError& error) {
  const auto commands = app.get_subcommands();
  if (!commands.empty()) return fmt::format("{}; perimpact {} --help lists the options.", error.what(), commands.front()->get_name());
  const auto rest = app.remaining();
  return rest.empty() ? "a command is needed; perimpact --help lists them." : fmt::format("{} is not a command; perimpact --help lists them.", rest.front());
}

/// Detects output lost on a full disk.
void expect_printed() {
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
    throw fccda::RunError(fmt::format("the output cannot be printed: {}. Free disk space, or redirect it elsewhere.", std::strerror(errno)));
}

int run(int argc, char** argv) {
  CLI::App app{"perimpact: peridynamic bodies in contact with rigid bodies of any shape"};
  app.require_subcommand(1);
  app.set_version_flag("--version", "perimpact " PERIMPACT_VERSION);
  int code = 0;

  RunArguments run_arguments;
  CLI::App* run = app.add_subcommand("run", "Run a deck");
  add_deck_arguments(*run, run_arguments);
  CLI::Option* resume =
      run->add_flag("--resume", run_arguments.resume, "Restart from the checkpoint in the results folder, with the same deck and --set, or a later time.end");
  run->add_flag("--force", run_arguments.force, "Replace the run in the results folder")->excludes(resume);
  run->add_flag("--no-report", run_arguments.no_report, "Omit report.html, which `perimpact report` can write later");
  run->callback([&] { code = run_command(run_arguments); });

  DeckArguments deck;
  CLI::App* check = app.add_subcommand("check", "Check a deck, summarise the set-up, and write surfaces and contact bounds as VTP");
  add_deck_arguments(*check, deck);
  check->callback([&] { code = check_command(deck); });

  DescribeArguments describe;
  add_describe(*app.add_subcommand("describe", "Print the deck reference, or the part of one key"), describe, code);

  NewArguments starter;
  add_new(*app.add_subcommand("new", "Write a small commented deck that runs in a minute or less"), starter, code);

  MeshArguments mesh;
  CLI::App* mesh_app = app.add_subcommand("mesh", "Inspect a surface file: contents, defects, suitability for a particle spacing");
  mesh_app->add_option("file", mesh.file, "Surface file")->required();
  mesh_app->add_option("--part", mesh.parts, "Only this part of the file (may be repeated)")->allow_extra_args(false);
  mesh_app->add_option("--scale", mesh.scale, "Factor that converts the coordinates to metres");
  mesh_app->add_option("--weld", mesh.weld, "Welding tolerance: vertices closer than this are merged, such as \"0.1 mm\"");
  mesh_app->add_option("--spacing", mesh.spacing, "Particle spacing of the bodies in contact with it, such as 0.5 or \"20 mm\"");
  mesh_app->add_option("--out", mesh.out, "Output file of the repaired surface: .stl or .obj");
  mesh_app->callback([&] { code = mesh_command(mesh); });

  ShapeArguments shape;
  add_shapes(*app.add_subcommand("shape", "Generate a surface from its dimensions, report on it and write it: hull, propeller, cylinder, sphere, box"), shape,
             code);

  StatisticsArguments statistics;
  CLI::App* statistics_app = app.add_subcommand("statistics", "Statistics and spectrum of the forces of a run, and the width of a channel in broken ice");
  add_statistics(*statistics_app, statistics);
  statistics_app->callback([&] { code = statistics_command(statistics); });

  ReportArguments report;
  CLI::App* report_app = app.add_subcommand("report", "Write a run as one file for the browser, report.html: particles, impactors, curves, deck, checks");
  report_app->add_option("folder", report.folder, "Folder of the results")->required();
  report_app->add_option("--size", report.megabytes, "Maximum size of the data [MB]; larger runs are thinned")
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
  std::signal(SIGXFSZ, SIG_IGN);  // reaching `ulimit -f` then is a write error like a full disk, instead of ending the program
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
  } catch (const std::system_error& error) {  // from fmt on a failed print
    print_error(fmt::format("the output cannot be printed: {}. Free disk space, or redirect it elsewhere.", error.code().message()));
    return 3;
  } catch (const std::bad_alloc&) {
    print_error("there is not enough memory for this set-up; use a larger spacing or fewer panels.");
    return 3;
  }
}
