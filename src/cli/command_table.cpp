#include "cli/command_table.hpp"

#include <fmt/format.h>

#include "base/error.hpp"
#include "cli/completion.hpp"
#include "cli/manual.hpp"
#include "cli/starters.hpp"
#include "run/processor.hpp"

namespace perimpact {

namespace {

using Options = std::vector<Option>;

Options operator+(Options first, Options second) {
  first.insert(first.end(), std::make_move_iterator(second.begin()), std::make_move_iterator(second.end()));
  return first;
}

Options deck_options(DeckArguments& arguments) {
  return {
      {.name = "deck", .help = "Deck (YAML)", .target = &arguments.deck, .completion = Completion::files, .is_required = true},
      {.name = "--out",
       .value = "FOLDER",
       .help = "Folder of the results, in place of output.folder",
       .target = &arguments.out,
       .completion = Completion::folders},
      {.name = "--set", .value = "KEY=VALUE", .help = "Change a value of the deck: --set key.path=value (may be repeated)", .target = &arguments.set},
      {.name = "--threads", .value = "N", .help = "Number of threads; all processors by default", .target = &arguments.threads, .range = {{1, 1024}}},
      {.name = "--quiet", .help = "Print warnings and errors only", .target = &arguments.messages.quiet},
      {.name = "--verbose",
       .help = "Also print a summary of bodies, impactors and time step before a run",
       .target = &arguments.messages.verbose,
       .excludes = {"--quiet"}},
      {.name = "--log",
       .value = "FILE",
       .help = "Append all messages to this file too, also with --quiet",
       .target = &arguments.messages.log,
       .completion = Completion::files},
  };
}

Command run_of(RunArguments& arguments) {
  return {.name = "run",
          .help = "Run a deck",
          .options = deck_options(arguments) +
                     Options{
                         {.name = "--resume",
                          .help = "Restart from the checkpoint in the results folder, with the same deck and --set, or a later time.end",
                          .target = &arguments.resume},
                         {.name = "--force", .help = "Replace the run in the results folder", .target = &arguments.force, .excludes = {"--resume"}},
                         {.name = "--no-report", .help = "Omit report.html, which `perimpact report` can write later", .target = &arguments.no_report},
                         {.name = "--progress",
                          .value = "FORM",
                          .help = "line: a line with the progress; json: all messages as JSON, one object a line",
                          .target = &arguments.progress,
                          .words = {"line", "json"}},
                         {.name = "--ranks",
                          .value = "N",
                          .help = "Number of processes that mpirun starts; recognised by default. 1: a run of its own, also within mpirun",
                          .target = &arguments.ranks,
                          .range = {{1, 1000000}}},
                         {.name = "--device",
                          .value = "DEVICE",
                          .help = "What computes the forces between particles. cpu: the processor; cuda: the first GPU (experimental). For tests: cpu-scalar, "
                                  "one particle at a time; emulated: a GPU emulated by the processor",
                          .target = &arguments.device,
                          .words = {device_words.begin(), device_words.end()}},
                     },
          .run = [&arguments] { return run_command(arguments); }};
}

Command check_of(CheckArguments& arguments) {
  return {.name = "check",
          .help = "Check a deck, summarise the set-up, and write surfaces and contact bounds as VTP",
          .options = deck_options(arguments) +
                     Options{{.name = "--json", .help = "Print the summary as one JSON object", .target = &arguments.json},
                             {.name = "--ranks",
                              .value = "N",
                              .help = "Forecast a run of so many processes, without building the bodies: shares, memory, messages, duration of a step",
                              .target = &arguments.ranks,
                              .range = {{1, 1000000}}},
                             {.name = "--latency",
                              .value = "SECONDS",
                              .help = "With --ranks: time of a message without content",
                              .target = &arguments.network.latency,
                              .range = {{0, 1}}},
                             {.name = "--bandwidth",
                              .value = "BYTES",
                              .help = "With --ranks: bytes that a rank sends in a second",
                              .target = &arguments.network.bandwidth,
                              .range = {{1, 1e15}}}},
          .run = [&arguments] { return check_command(arguments); }};
}

Command describe_of(DescribeArguments& arguments) {
  return {.name = "describe",
          .help = "Print the deck reference, or the part of one key",
          .options = {{.name = "key", .help = "Key, such as poissons_ratio or bodies.material", .target = &arguments.key},
                      {.name = "--markdown",
                       .value = "FOLDER",
                       .help = "Write the whole reference as Markdown pages to this folder (docs/guide/deck)",
                       .target = &arguments.pages,
                       .completion = Completion::folders,
                       .excludes = {"key"}},
                      {.name = "--schema",
                       .help = "The whole reference as a JSON Schema, for editors (docs/guide/deck.schema.json)",
                       .target = &arguments.is_schema,
                       .excludes = {"key", "--markdown"}}},
          .run = [&arguments] { return describe_command(arguments); }};
}

Command new_of(NewArguments& arguments) {
  std::vector<std::string> names;
  for (const Starter& each : starters()) names.emplace_back(each.name);
  return {
      .name = "new",
      .help = "Write a small commented deck that runs in a minute or less",
      .options = {{.name = "kind",
                   .help = fmt::format("Kind of the deck: {}", fmt::join(names, ", ")),
                   .target = &arguments.starter,
                   .words = names,
                   .is_required = true},
                  {.name = "file", .help = "Path of the new deck; plate.yaml and so on by default", .target = &arguments.file, .completion = Completion::files},
                  {.name = "--force", .help = "Overwrite existing files", .target = &arguments.force}},
      .run = [&arguments] { return new_command(arguments); }};
}

Command mesh_of(MeshArguments& arguments) {
  return {.name = "mesh",
          .help = "Inspect a surface file: contents, defects, suitability for a particle spacing",
          .options = {{.name = "file", .help = "Surface file", .target = &arguments.file, .completion = Completion::files, .is_required = true},
                      {.name = "--part", .value = "NAME", .help = "Only this part of the file (may be repeated)", .target = &arguments.parts},
                      {.name = "--scale", .value = "FACTOR", .help = "Factor that converts the coordinates to metres", .target = &arguments.scale},
                      {.name = "--weld",
                       .value = "LENGTH",
                       .help = "Welding tolerance: vertices closer than this are merged, such as \"0.1 mm\"",
                       .target = &arguments.weld},
                      {.name = "--spacing",
                       .value = "LENGTH",
                       .help = "Particle spacing of the bodies in contact with it, such as 0.5 or \"20 mm\"",
                       .target = &arguments.spacing},
                      {.name = "--out",
                       .value = "FILE",
                       .help = "Output file of the repaired surface: .stl or .obj",
                       .target = &arguments.out,
                       .completion = Completion::files}},
          .run = [&arguments] { return mesh_command(arguments); }};
}

/// One command for each shape, with the keys of the deck as options.
Command shape_of(Arguments& all) {
  ShapeArguments& arguments = all.shape;
  Command shape{.name = "shape",
                .help = "Generate a surface from its dimensions, report on it and write it: hull, propeller, cylinder, sphere, box",
                .options = {{.name = "--list", .help = "List the shapes", .target = &all.lists_shapes}},
                .run = list_shapes};
  for (const ShapeKind& kind : shape_kinds()) {
    Command& one = shape.commands.emplace_back(Command{.name = kind.name,
                                                       .help = std::string(kind.sentence),
                                                       .options = {{.name = "-o,--out",
                                                                    .value = "FILE",
                                                                    .help = "Output file of the surface: .stl or .obj",
                                                                    .target = &arguments.out,
                                                                    .completion = Completion::files}},
                                                       .run = [&arguments, name = kind.name] {
                                                         arguments.shape = name;
                                                         return shape_command(arguments);
                                                       }});
    for (const ShapeOption& option : kind.options)
      one.options.push_back({.name = option.name, .value = "VALUE", .help = option.help, .target = [&arguments, option](const std::string& text) {
                               arguments.values.emplace_back(option, text);
                             }});
  }
  return shape;
}

Command statistics_of(StatisticsArguments& arguments) {
  return {.name = "statistics",
          .help = "Statistics and spectrum of the forces of a run, and the width of a channel in broken ice",
          .options = {{.name = "folder", .help = "Folder of the results", .target = &arguments.folder, .completion = Completion::folders, .is_required = true},
                      {.name = "--from", .value = "TIME", .help = "Start time, such as 5 or \"20 ms\"; earlier rows are ignored", .target = &arguments.from},
                      {.name = "--to",
                       .value = "TIME",
                       .help = "End time; later rows are ignored, and --channel uses the last frame up to it",
                       .target = &arguments.to},
                      {.name = "--columns",
                       .value = "NAMES",
                       .help = "Columns of history.csv in place of the loads: comma-separated names or prefixes such as ship.force",
                       .target = &arguments.columns,
                       .splits_at_commas = true},
                      {.name = "--windows",
                       .value = "N",
                       .help = "Also mean and extremes over this many equal parts of the time",
                       .target = &arguments.windows,
                       .range = {{1, 100000}}},
                      {.name = "--segment",
                       .value = "TIME",
                       .help = "Length of the spectrum's windows, a time; rounded down to a power of two of rows",
                       .target = &arguments.segment},
                      {.name = "--channel",
                       .value = "BODY:AXIS",
                       .help = "Width of the channel in a broken sheet of a body along an axis: ice:x",
                       .target = &arguments.channel.of},
                      {.name = "--channel-from", .value = "LENGTH", .help = "Lower end on the axis, a length", .target = &arguments.channel.from},
                      {.name = "--channel-to", .value = "LENGTH", .help = "Upper end on the axis, a length", .target = &arguments.channel.to},
                      {.name = "--sheet",
                       .value = "SHARE",
                       .help = "Fragments with at least this share of the body's particles belong to the remaining sheet along the channel",
                       .target = &arguments.channel.sheet}},
          .run = [&arguments] { return statistics_command(arguments); }};
}

Command report_of(ReportArguments& arguments) {
  return {.name = "report",
          .help = "Write a run as one file for the browser, report.html: particles, impactors, curves, deck, checks",
          .options = {{.name = "folder", .help = "Folder of the results", .target = &arguments.folder, .completion = Completion::folders, .is_required = true},
                      {.name = "--size",
                       .value = "MB",
                       .help = "Maximum size of the data [MB]; larger runs are thinned",
                       .target = &arguments.megabytes,
                       .range = {{0.01, 500.0}}}},
          .run = [&arguments] { return report_command(arguments); }};
}

int print_version() {
  fmt::print("perimpact {}\n", PERIMPACT_VERSION);
  return 0;
}

}  // namespace

Command command_table(Arguments& arguments) {
  Command program{.name = "perimpact",
                  .help = "perimpact: peridynamic bodies in contact with rigid bodies of any shape",
                  .options = {{.name = "--version", .help = "Print the version", .target = &arguments.is_version}},
                  .run = [&arguments] {
                    if (!arguments.is_version) throw fccda::InputError("a command is needed; perimpact --help lists them.");
                    return print_version();
                  }};
  program.commands = {run_of(arguments.run),   check_of(arguments.check), describe_of(arguments.describe),     new_of(arguments.starter),
                      mesh_of(arguments.mesh), shape_of(arguments),       statistics_of(arguments.statistics), report_of(arguments.report)};
  program.commands.push_back({.name = "completion",
                              .help = "Print the completion script of a shell",
                              .options = {{.name = "shell",
                                           .help = fmt::format("Name of the shell: {}", fmt::join(shells(), ", ")),
                                           .target = &arguments.shell,
                                           .words = shells(),
                                           .is_required = true}},
                              .run = [&arguments] {
                                Arguments unused;
                                fmt::print("{}", completion_script(command_table(unused), arguments.shell));
                                return 0;
                              }});
  program.commands.push_back({.name = "manual",
                              .help = "Print the manual page of all commands (troff)",
                              .options = {{.name = "--markdown", .help = "As a Markdown page (docs/guide/command_line.md)", .target = &arguments.is_markdown}},
                              .run = [&arguments] {
                                Arguments unused;
                                const Command table = command_table(unused);
                                fmt::print("{}", arguments.is_markdown ? manual_markdown(table) : manual_page(table));
                                return 0;
                              }});
  program.commands.push_back({.name = "version", .help = "Print the version", .run = print_version});
  return program;
}

}  // namespace perimpact
