#include "cli/open_deck.hpp"

#include "fccda/core/error.hpp"
#include "fccda/core/parallel.hpp"
#include "perimpact/setup/setup_error.hpp"

namespace perimpact {

deck::Deck open_deck(const DeckArguments& arguments) {
  if (arguments.threads > 0) fccda::use_threads(arguments.threads);
  return deck::read_deck(arguments.deck, arguments.set);
}

std::filesystem::path results_folder(const DeckArguments& arguments, const Setup& setup) {
  if (arguments.out && arguments.out->empty())
    throw fccda::InputError("--out is empty, which names no folder; write --out . for this one, or leave it out for output.folder of the deck.");
  return arguments.out.value_or(setup.output.folder);
}

void rethrow_with_place(const deck::Deck& deck) {
  try {
    throw;
  } catch (const SetupError& error) {
    throw fccda::InputError(deck.places.of(error.key()) + ": " + error.what());
  }
}

}  // namespace perimpact
