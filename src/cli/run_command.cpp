#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <string>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "cli/commands.hpp"
#include "cli/open_deck.hpp"
#include "cli/progress.hpp"
#include "cli/report_command.hpp"
#include "run/run_folder.hpp"
#include "run/run_loop.hpp"
#include "run/stop_signals.hpp"

namespace perimpact {

namespace {

void print_timers(const fccda::Timers& timers) {
  fmt::print("\n{:<20}{:>10}{:>9}\n", "where", "seconds", "share");
  for (const auto& row : timers.rows()) fmt::print("{:<20}{:>10.2f}{:>8.1f} %\n", row.name, row.seconds, 100 * row.seconds / timers.total());
}

/// A command-line word, quoted for the shell.
std::string quoted(const std::string& word) {
  if (!word.empty() && word.find_first_of(" \t\n\"'\\$`&|;<>()[]{}*?!#~") == std::string::npos) return word;
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

/// The command that resumes this run.
std::string resuming(const RunArguments& arguments) {
  std::string text = "perimpact run " + quoted(arguments.deck.string());
  if (arguments.out) text += " --out " + quoted(*arguments.out);
  for (const std::string& change : arguments.set) text += " --set " + quoted(change);
  return text + " --resume";
}

/// Performs the steps, with the progress line. The signal that ended the run, or 0.
int run_steps(Simulation& simulation, RunLoop& loop) {
  Progress progress(simulation);
  loop.run({.after_step =
                [&] {
                  progress.after_step(simulation);
                  return StopSignals::pending() == 0;
                },
            .in_increment =
                [&] {
                  progress.in_increment(simulation);
                  return StopSignals::pending() == 0;
                }});
  progress.finish(simulation);
  loop.interrupt();  // of a finished run, the results are closed
  return simulation.clock().is_finished() ? 0 : StopSignals::pending();
}

void print_start(const Simulation& simulation, const RunFolder& folder) {
  const Clock& clock = simulation.clock();
  fmt::print("{}\n{} threads, {} {} of {:.4g} s; results go to {}\n", simulation.setup().title, fccda::thread_count(), clock.steps,
             simulation.relaxation() ? "increments" : "steps", clock.dt, folder.path().string());
  if (folder.is_resumed()) fmt::print("Resumed at step {} (t = {:.4g} s).\n", clock.step, clock.time());
  for (const std::string& warning : simulation.warnings()) fmt::print("warning: {}\n", warning);
}

/// Runs the deck in the folder. The signal that ended the run, or 0.
int run_deck(const deck::Deck& deck, const RunFolder& folder, const RunArguments& arguments) {
  Simulation simulation(deck.setup);
  const StopSignals signals(StopSignals::SecondInterrupt::ends_program);
  RunLoop loop(simulation);
  loop.begin_results(folder);
  if (!loop.note().empty()) fmt::print("{}\n", loop.note());
  print_start(simulation, folder);
  int signal = 0;
  try {
    signal = run_steps(simulation, loop);
  } catch (const fccda::RunError&) {
    std::fputs("\n", stdout);
    if (!arguments.no_report) try_report(folder.path());
    throw;
  }
  print_timers(simulation.timers());
  for (const std::string& warning : simulation.closing_warnings()) fmt::print("\nwarning: {}\n", warning);
  const std::filesystem::path& path = folder.path();
  if (signal != 0) {
    fmt::print("\nInterrupted at t = {:.4g} s (step {} of {}). The results up to this step are in {}; resume with {}\n", simulation.clock().time(),
               simulation.clock().step, simulation.clock().steps, path.string(), folder.requests().resume);
    return signal;
  }
  fmt::print("\nResults: {}\n", std::filesystem::absolute(path).lexically_normal().string());
  fmt::print("  {}  time histories\n  {}  output frames, for ParaView\n  {}  summary of the run\n", (path / "history.csv").string(), (path / "frames").string(),
             (path / "run.json").string());
  return 0;
}

}  // namespace

int run_command(const RunArguments& arguments) {
  const deck::Deck deck = open_deck(arguments);
  const std::filesystem::path path = results_folder(arguments, deck.setup);
  return with_places(deck, {.path = path, .lists_files = true}, [&] {
    const EarlierRun earlier = arguments.resume ? EarlierRun::resume : arguments.force ? EarlierRun::replace : EarlierRun::keep;
    const RunFolder folder(path, earlier, {.resume = resuming(arguments), .replace = "--force", .folder = "choose another folder with --out"}, deck.setup);
    for (const std::string& note : folder.notes()) fmt::print("{}\n", note);
    if (folder.is_finished()) {
      fmt::print("The run in {} is finished (step {} of {}); there is nothing to resume.\n", path.string(), folder.steps(), folder.steps());
      return 0;
    }
    if (const int signal = run_deck(deck, folder, arguments)) return 128 + signal;
    if (!arguments.no_report) try_report(path);  // after the memory of the run is released
    return 0;
  });
}

}  // namespace perimpact
