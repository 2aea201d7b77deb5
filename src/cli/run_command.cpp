#include <fmt/format.h>

#include <csignal>
#include <cstdio>

#include "cli/commands.hpp"
#include "cli/open_deck.hpp"
#include "cli/progress.hpp"
#include "fccda/core/error.hpp"
#include "fccda/core/parallel.hpp"
#include "io/results/results_writer.hpp"

namespace perimpact {

namespace {

volatile std::sig_atomic_t stop_signal = 0;

extern "C" void remember_signal(int signal) { stop_signal = signal; }

void print_timers(const fccda::Timers& timers) {
  fmt::print("\n{:<12}{:>10}{:>9}\n", "where", "seconds", "share");
  for (const auto& row : timers.rows()) fmt::print("{:<12}{:>10.2f}{:>8.1f} %\n", row.name, row.seconds, 100 * row.seconds / timers.total());
}

}  // namespace

int run_command(const DeckArguments& arguments) {
  const deck::Deck deck = open_deck(arguments);
  const std::filesystem::path folder = results_folder(arguments, deck.setup);
  output::prepare_folder(folder);

  return with_places(deck, folder, [&] {
    Simulation simulation(deck.setup);
    std::signal(SIGINT, remember_signal);
    std::signal(SIGTERM, remember_signal);
    ResultsWriter results(simulation, folder);
    remove_pictures_of_defects(simulation, folder);
    fmt::print("{}\n{} threads, {} steps of {:.4g} s; results go to {}\n", deck.setup.title, fccda::thread_count(), simulation.clock().steps,
               simulation.clock().dt, folder.string());
    for (const std::string& warning : simulation.warnings()) fmt::print("warning: {}\n", warning);

    Progress progress;
    try {
      while (!simulation.clock().is_finished() && stop_signal == 0) {
        simulation.step();
        results.after_step(simulation);
        progress.after_step(simulation);
      }
      progress.finish(simulation);
      results.finish(simulation, stop_signal == 0 ? Outcome::finished : Outcome::interrupted, "", progress.seconds());
    } catch (const fccda::RunError& error) {
      std::fputs("\n", stdout);
      try {
        results.finish(simulation, Outcome::failed, error.what(), progress.seconds());
      } catch (const fccda::RunError&) {
        // nothing more can be written; the first error is the one to report
      }
      throw;
    }

    print_timers(simulation.timers());
    for (const std::string& warning : simulation.closing_warnings()) fmt::print("\nwarning: {}\n", warning);
    if (stop_signal != 0) {
      fmt::print("\nInterrupted at t = {:.4g} s (step {} of {}). What was computed is in {}.\n", simulation.clock().time(), simulation.clock().step,
                 simulation.clock().steps, folder.string());
      return 128 + static_cast<int>(stop_signal);
    }
    fmt::print("\nResults: {}\n", std::filesystem::absolute(folder).lexically_normal().string());
    fmt::print("  {}  the curves\n  {}  the pictures, for ParaView\n  {}  what was run\n", (folder / "history.csv").string(), (folder / "frames").string(),
               (folder / "run.json").string());
    return 0;
  });
}

}  // namespace perimpact
