#include <fmt/format.h>

#include <csignal>
#include <filesystem>
#include <optional>
#include <string>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "cli/commands.hpp"
#include "cli/open_deck.hpp"
#include "cli/progress.hpp"
#include "cli/report_command.hpp"
#include "cli/row.hpp"
#include "cli/setup_text.hpp"
#include "io/output/results_folder.hpp"
#include "perimpact/simulation/ranks_report.hpp"
#include "run/launch.hpp"
#include "run/processor.hpp"
#include "run/run_folder.hpp"
#include "run/run_loop.hpp"
#include "run/stop_signals.hpp"

namespace perimpact {

using output::Json;
using output::ResultsFolder;

namespace {

/// Set-up is one row; run.json has its stages.
std::string timers_text(const Simulation& simulation) {
  const double set_up = simulation.set_up_timers().total(), total = set_up + simulation.timers().total();
  const auto timer = [&](std::string_view name, double seconds) { return fmt::format("{:<20}{:>10.2f}{:>8.1f} %\n", name, seconds, 100 * seconds / total); };
  std::string text = fmt::format("\n{:<20}{:>10}{:>9}\n", "where", "seconds", "share") + timer("set-up", set_up);
  for (const auto& row : simulation.timers().rows()) text += timer(row.name, row.seconds);
  return text;
}

/// What the ranks have sent, and how evenly they have computed. Empty for one. Collective.
std::string ranks_text(const Simulation& simulation) {
  if (simulation.ranks().size() == 1) return "";
  const RanksReport report = report_of_ranks(simulation);
  return fmt::format(
      "\n{} ranks: the slowest took {:.2f} times the mean time in the phases of force; {:.3g} MB sent in {} messages, {} reductions, {:.2f} s of waiting\n",
      simulation.ranks().size(), report.imbalance(), static_cast<double>(report.all.bytes) / 1e6, report.all.messages, simulation.traffic_of_steps().reductions,
      report.all.seconds);
}

/// "1 thread", "2 ranks with 4 threads each", or "NVIDIA H100, 4 threads".
std::string processors_text(const Simulation& simulation) {
  const Ranks& ranks = simulation.ranks();
  const std::string threads = counted(fccda::thread_count(), "thread");
  if (const std::string device = simulation.device_name(); !device.empty()) return fmt::format("{}, {}", device, threads);
  return ranks.size() == 1 ? threads : fmt::format("{} ranks with {} each", ranks.size(), threads);
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
  if (arguments.threads > 0) text += fmt::format(" --threads {}", arguments.threads);
  if (arguments.device != RunArguments().device) text += " --device " + arguments.device;
  if (!arguments.messages.log.empty()) text += " --log " + quoted(arguments.messages.log.string());
  if (arguments.no_report) text += " --no-report";
  return text + " --resume";
}

/// The signal to end that any rank has received, or 0. Collective.
int pending_signal(const Simulation& simulation) { return static_cast<int>(simulation.ranks().max(StopSignals::pending())); }

/// Performs the steps, with the progress line. The signal that ended the run, or 0.
int run_steps(Simulation& simulation, RunLoop& loop, Messages& messages) {
  Progress progress(simulation, messages);
  bool has_warned = false;
  const auto warn_of_windows = [&] {  // once and at once, since the rest of the run may be in vain
    if (has_warned) return;
    for (const MovingWindow& window : simulation.moving_windows())
      for (const std::string& sentence : window.warnings()) {
        messages.warn(fmt::format("At t = {:.4g} s: {}", simulation.clock().time(), sentence));
        has_warned = true;
      }
  };
  loop.run({.after_step =
                [&] {
                  progress.after_step(simulation);
                  warn_of_windows();
                  return StopSignals::pending() == 0;
                },
            .in_increment =
                [&] {
                  progress.in_increment(simulation);
                  return StopSignals::pending() == 0;
                }});
  progress.finish(simulation);
  loop.interrupt();  // of a finished run, the results are closed
  return simulation.clock().is_finished() ? 0 : pending_signal(simulation);
}

void print_start(const Simulation& simulation, const RunFolder& folder, Messages& messages) {
  const Clock& clock = simulation.clock();
  Json members = Json::object();
  members["schema"] = messages_schema;
  members["program"] = "perimpact " PERIMPACT_VERSION;
  members["title"] = simulation.setup().title;
  members["folder"] = folder.path().string();
  members["threads"] = fccda::thread_count();
  if (const int ranks = simulation.ranks().size(); ranks > 1) members["ranks"] = ranks;
  if (const std::string device = simulation.device_name(); !device.empty()) members["device"] = device;
  members[simulation.relaxation() ? "increments" : "steps"] = clock.steps;
  members[simulation.relaxation() ? "increment [s]" : "step [s]"] = clock.dt;
  if (folder.is_resumed()) members["resumed_at"] = clock.step;
  messages.print("start", members,
                 fmt::format("{}, {} {} of {:.4g} s; results go to {}\n", processors_text(simulation), clock.steps,
                             simulation.relaxation() ? "increments" : "steps", clock.dt, folder.path().string()));
  if (folder.is_resumed()) messages.print(fmt::format("Resumed at step {} (t = {:.4g} s).\n", clock.step, clock.time()));
  if (messages.is_verbose()) messages.print(setup_text(simulation));
  for (const std::string& warning : simulation.warnings()) messages.warn(warning);
}

/// The end of a run that is finished, or ended by a signal.
void print_end(const Simulation& simulation, const RunFolder& folder, int signal, Messages& messages) {
  const Clock& clock = simulation.clock();
  messages.print(timers_text(simulation) + ranks_text(simulation));
  for (const std::string& warning : simulation.closing_warnings()) messages.warn(warning);
  const std::filesystem::path& path = folder.path();
  Json members = Json::object();
  members["outcome"] = signal == 0 ? "finished" : "interrupted";
  members["time [s]"] = clock.time();
  members[simulation.relaxation() ? "increment" : "step"] = clock.step;
  if (signal != 0) members["resume"] = folder.requests().resume;
  messages.print("end", members,
                 signal == 0 ? fmt::format("\nResults: {}\n  {}  time histories\n  {}  output frames, for ParaView\n  {}  summary of the run\n",
                                           std::filesystem::absolute(path).lexically_normal().string(), (path / "history.csv").string(),
                                           (path / "frames").string(), (path / "run.json").string())
                             : fmt::format("\nInterrupted at t = {:.4g} s (step {} of {}). The results up to this step are in {}; resume with {}\n",
                                           clock.time(), clock.step, clock.steps, path.string(), folder.requests().resume));
}

/// Runs the deck in the folder; signals are recorded from the end of the set-up. The signal that ended the run, or 0.
int run_deck(const deck::Deck& deck, const RunFolder& folder, const RunArguments& arguments, std::optional<StopSignals>& signals, Messages& messages,
             Ranks& ranks, const Processor& processor) {
  Simulation simulation = set_up(deck, messages, &folder, ranks, processor);
  signals.emplace(StopSignals::Interrupts::second_ends_program);
  RunLoop loop(simulation);
  messages.stage("first output frame");
  loop.begin_results(folder);
  if (!loop.note().empty()) messages.note(loop.note());
  print_start(simulation, folder, messages);
  int signal = 0;
  try {
    signal = run_steps(simulation, loop, messages);
  } catch (const fccda::RunError& error) {
    messages.end_progress();
    Json members = Json::object();
    members["outcome"] = "failed";
    members["text"] = error.what();
    messages.print("end", members, "");
    if (!arguments.no_report && ranks.size() == 1) try_report(folder.path(), messages);  // others wait for the end of a failed rank
    throw;
  }
  print_end(simulation, folder, signal, messages);
  return signal;
}

/// The arguments of this rank: only the root prints and reports, and threads share the processors of a machine.
RunArguments arguments_of(Ranks& ranks, RunArguments arguments) {
  if (ranks.size() == 1) return arguments;
  const int threads = threads_of_rank(ranks);
  if (arguments.threads == 0) arguments.threads = threads;
  arguments.messages.has_terminal = false;
  if (ranks.is_root()) return arguments;
  arguments.messages.log.clear();
  arguments.no_report = true;
  return arguments;
}

}  // namespace

int run_command(const RunArguments& given) {
  std::signal(SIGPIPE, SIG_IGN);  // a run does not depend on who reads its messages
  Ranks& ranks = launched_ranks(given.ranks);
  const RunArguments arguments = arguments_of(ranks, given);
  const auto form = arguments.progress == "json" ? Messages::Form::json_lines : Messages::Form::text;
  Messages messages(arguments.messages, ranks.is_root() ? form : Messages::Form::none);
  return logged(messages, [&] {
    const Processor processor = opened_processor(arguments.device);  // before anything that takes time
    const deck::Deck deck = open_deck(arguments, messages);
    const std::filesystem::path path = results_folder(arguments, deck.setup);
    return with_places(deck, {.path = path, .lists_files = true, .is_written = ranks.is_root()}, [&] {
      const EarlierRun earlier = arguments.resume ? EarlierRun::resume : arguments.force ? EarlierRun::replace : EarlierRun::keep;
      std::optional<StopSignals> signals;  // outlives the lock of the folder: while the report of a finished run is written, a signal leaves no lock behind
      const RunFolder folder(path, earlier, {.resume = resuming(arguments), .replace = "--force", .folder = "choose another folder with --out"}, deck.setup,
                             ranks);
      for (const std::string& note : folder.notes()) messages.note(note);
      if (folder.is_finished()) {
        messages.note(fmt::format("The run in {} is finished (step {} of {}); there is nothing to resume.", path.string(), folder.steps(), folder.steps()));
        // absent where the run was killed before it was written
        if (!arguments.no_report && !std::filesystem::exists(ResultsFolder::report_in(path))) try_report(path, messages);
        return 0;
      }
      messages.print(deck.setup.title + '\n');
      if (const int signal = run_deck(deck, folder, arguments, signals, messages, ranks, processor)) return 128 + signal;
      if (!arguments.no_report) try_report(path, messages);  // after the memory of the run is released
      return 0;
    });
  });
}

}  // namespace perimpact
