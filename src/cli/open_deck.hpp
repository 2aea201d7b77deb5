/// From the arguments of a command to a simulation, with every complaint carrying its place in the deck.
#pragma once

#include "cli/commands.hpp"
#include "io/deck/deck.hpp"
#include "perimpact/simulation/simulation.hpp"

namespace perimpact {

/// Reads the deck with its overrides and sets the number of threads.
deck::Deck open_deck(const DeckArguments& arguments);

/// --out, or output.folder of the deck. Throws InputError where --out is empty.
std::filesystem::path results_folder(const DeckArguments& arguments, const Setup& setup);

/// Throws the exception that is being handled again, a SetupError as an InputError that begins with file, line and column. Where an
/// impactor's surface has defects, a picture of the panels goes into `folder`, and the sentence says so.
[[noreturn]] void rethrow_with_place(const deck::Deck& deck, const std::filesystem::path& folder);

/// Those that an earlier try of the deck left in `folder`: now that there is a simulation, the surfaces have none.
void remove_defect_files(const Simulation& simulation, const std::filesystem::path& folder);

/// Calls f() with its SetupErrors placed so.
template <class F>
auto with_places(const deck::Deck& deck, const std::filesystem::path& folder, const F& f) {
  try {
    return f();
  } catch (...) {
    rethrow_with_place(deck, folder);
  }
}

}  // namespace perimpact
