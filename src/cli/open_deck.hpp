/// Opens the deck of a command; errors carry their position in the deck.
#pragma once

#include "cli/commands.hpp"
#include "io/deck/deck.hpp"
#include "perimpact/simulation/simulation.hpp"
#include "run/run_folder.hpp"

namespace perimpact {

/// Reads the deck with its overrides and sets the number of threads.
deck::Deck open_deck(const DeckArguments& arguments, Messages& messages);

/// The simulation of the deck; stages of the set-up are messages. A signal meanwhile ends the program, with a sentence; the folder, if any, is unlocked then.
Simulation set_up(const deck::Deck& deck, Messages& messages, const RunFolder* folder = nullptr, Ranks& ranks = alone(), const Processor& processor = {});

/// --out, or output.folder of the deck. Throws InputError if --out is empty.
std::filesystem::path results_folder(const DeckArguments& arguments, const Setup& setup);

/// Where the panels of a defective surface are written: to a results folder, which lists its files, or another one.
struct DefectFolder {
  const std::filesystem::path& path;
  bool lists_files = false;
  bool is_written = true;  ///< by this process, which is the root
};

/// Rethrows the current exception, a SetupError as an InputError with file, line and column. For a defective impactor surface, the
/// panels are written into `folder` and the message names the file.
[[noreturn]] void rethrow_with_place(const deck::Deck& deck, const DefectFolder& folder);

/// Removes defect files of earlier attempts from `folder`.
void remove_defect_files(const Simulation& simulation, const std::filesystem::path& folder);

/// Calls f() and adds positions to its SetupErrors.
template <class F>
auto with_places(const deck::Deck& deck, const DefectFolder& folder, const F& f) {
  try {
    return f();
  } catch (...) {
    rethrow_with_place(deck, folder);
  }
}

}  // namespace perimpact
