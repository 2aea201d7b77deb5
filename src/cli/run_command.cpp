#include <fmt/format.h>

#include <csignal>
#include <cstdio>
#include <optional>
#include <string>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "cli/commands.hpp"
#include "cli/open_deck.hpp"
#include "cli/progress.hpp"
#include "cli/report_command.hpp"
#include "io/checkpoint/checkpoints.hpp"
#include "io/results/results_writer.hpp"

namespace perimpact {

namespace {

volatile std::sig_atomic_t stop_signal = 0;

extern "C" void remember_signal(int signal) { stop_signal = signal; }

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

/// Sentence about the last checkpoint after an error, with the command to resume if the error was not one of the simulation.
std::string about_last(const Checkpoints& checkpoints, const std::string& command) {
  if (!checkpoints.last()) return "";
  return fmt::format(" The last checkpoint is at step {}{}", *checkpoints.last(), command.empty() ? "." : "; resume from it with " + command);
}

/// Reports an unfinished run whose checkpoint is replaced.
void print_unfinished(const std::filesystem::path& path) {
  if (!std::filesystem::exists(path)) return;
  try {
    const Checkpoint earlier(path);
    if (!earlier.is_finished())
      fmt::print("The unfinished run in {} (step {} of {}) is replaced; --resume would have continued it.\n", path.parent_path().string(), earlier.step(),
                 earlier.steps());
  } catch (const fccda::InputError&) {
    // not resumable
  }
}

}  // namespace

int run_command(const RunArguments& arguments) {
  const deck::Deck deck = open_deck(arguments);
  const std::filesystem::path folder = results_folder(arguments, deck.setup);
  const std::filesystem::path checkpoint = output::ResultsFolder::checkpoint_in(folder);

  bool is_finished = false;
  const int code = with_places(deck, folder, [&] {
    std::optional<Checkpoint> earlier;
    if (arguments.resume) {
      earlier.emplace(checkpoint).expect_deck(deck.setup);
      if (earlier->is_finished() && std::filesystem::exists(folder / "run.json")) {
        fmt::print("The run in {} is finished (step {} of {}); there is nothing to resume.\n", folder.string(), earlier->step(), earlier->steps());
        return 0;
      }
    }
    output::prepare_folder(folder);
    Simulation simulation(deck.setup);
    std::signal(SIGINT, remember_signal);
    std::signal(SIGTERM, remember_signal);
    Checkpoints checkpoints(checkpoint, simulation);
    if (!earlier) print_unfinished(checkpoint);
    ResultsWriter results = earlier ? ResultsWriter(simulation, folder, checkpoints.resume(*earlier, simulation)) : ResultsWriter(simulation, folder);
    earlier.reset();  // closes the file, which the next checkpoint replaces
    remove_defect_files(simulation, folder);
    fmt::print("{}\n{} threads, {} {} of {:.4g} s; results go to {}\n", deck.setup.title, fccda::thread_count(), simulation.clock().steps,
               simulation.relaxation() ? "increments" : "steps", simulation.clock().dt, folder.string());
    if (arguments.resume) fmt::print("Resumed at step {} (t = {:.4g} s).\n", simulation.clock().step, simulation.clock().time());
    for (const std::string& warning : simulation.warnings()) fmt::print("warning: {}\n", warning);

    Progress progress(simulation);
    std::string command;
    try {
      while (!simulation.clock().is_finished() && stop_signal == 0) {
        command = "";
        const long step = simulation.clock().step;
        simulation.step([&](const Relaxed&) {
          progress.in_increment(simulation);
          return stop_signal == 0;
        });
        if (simulation.clock().step == step) break;  // interrupted within an increment
        command = resuming(arguments);
        results.after_step(simulation);
        checkpoints.after_step(simulation, results);
        progress.after_step(simulation);
      }
      progress.finish(simulation);
      checkpoints.write(simulation, results);
      results.finish(simulation, simulation.clock().is_finished() ? Outcome::finished : Outcome::interrupted, "", progress.seconds());
    } catch (const fccda::RunError& error) {
      std::fputs("\n", stdout);
      const std::string sentence = error.what() + about_last(checkpoints, command);
      try {
        results.finish(simulation, Outcome::failed, sentence, progress.seconds());
        if (!arguments.no_report) try_report(folder);
      } catch (const fccda::RunError&) {
        // nothing more can be written; the first error is the one to report
      }
      throw fccda::RunError(sentence);
    }

    print_timers(simulation.timers());
    for (const std::string& warning : simulation.closing_warnings()) fmt::print("\nwarning: {}\n", warning);
    if (!simulation.clock().is_finished()) {
      fmt::print("\nInterrupted at t = {:.4g} s (step {} of {}). The results up to this step are in {}; resume with {}\n", simulation.clock().time(),
                 simulation.clock().step, simulation.clock().steps, folder.string(), resuming(arguments));
      return 128 + static_cast<int>(stop_signal);
    }
    fmt::print("\nResults: {}\n", std::filesystem::absolute(folder).lexically_normal().string());
    fmt::print("  {}  time histories\n  {}  output frames, for ParaView\n  {}  summary of the run\n", (folder / "history.csv").string(),
               (folder / "frames").string(), (folder / "run.json").string());
    is_finished = true;
    return 0;
  });
  if (is_finished && !arguments.no_report) try_report(folder);  // after the memory of the run is released
  return code;
}

}  // namespace perimpact
