#include "cli/open_deck.hpp"

#include <fmt/format.h>

#include <span>
#include <string>
#include <string_view>
#include <system_error>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "io/output/results_folder.hpp"
#include "io/results/defect_files.hpp"
#include "perimpact/impactor/surface_of.hpp"
#include "run/setup_signals.hpp"

namespace perimpact {

namespace {

std::filesystem::path defect_file_of(const std::filesystem::path& folder, const std::string& impactor) { return folder / (impactor + "_defects.vtp"); }

}  // namespace

deck::Deck open_deck(const DeckArguments& arguments, Messages& messages) {
  if (arguments.threads > 0) fccda::use_threads(arguments.threads);
  deck::Deck deck = deck::read_deck(arguments.deck, arguments.set);
  for (const std::string& warning : deck.warnings) messages.warn(warning);
  return deck;
}

Simulation set_up(const deck::Deck& deck, Messages& messages, const RunFolder* folder, Ranks& ranks, const Processor& processor) {
  const SetupSignals signals(messages.last_words("Interrupted during the set-up; no results were written."), ranks.is_root() ? folder : nullptr);
  return Simulation(
      deck.setup, [&](std::string_view stage, std::string_view of) { messages.stage(stage, of); }, ranks,
      folder ? folder->loads() : std::span<const MeasuredLoad>(), processor);
}

std::filesystem::path results_folder(const DeckArguments& arguments, const Setup& setup) {
  if (arguments.out && arguments.out->empty())
    throw fccda::InputError("--out is empty; use --out . for the current folder, or omit it to use output.folder of the deck.");
  return arguments.out ? results_path(*arguments.out, "--out") : results_path(setup.output.folder, "output.folder");
}

void rethrow_with_place(const deck::Deck& deck, const DefectFolder& folder) {
  try {
    throw;
  } catch (const DefectiveSurface& error) {
    const std::filesystem::path file = defect_file_of(folder.path, error.impactor());
    if (folder.is_written) {
      output::prepare_folder(folder.path);
      write_defects(file, error.panels(), {&error.defect(), 1});
    }
    const std::string listed = file.filename().string();
    if (folder.is_written && folder.lists_files) output::list_files(folder.path, std::span(&listed, 1));
    throw fccda::InputError(fmt::format("{}: {} These panels are in {}, for ParaView.", deck.places.of(error.key()), error.what(), file.string()));
  } catch (const SetupError& error) {
    throw fccda::InputError(deck.places.of(error.key()) + ": " + error.what());
  }
}

void remove_defect_files(const Simulation& simulation, const std::filesystem::path& folder) {
  for (const Impactor& impactor : simulation.impactors()) {
    std::error_code ignored;  // a file that cannot be removed is harmless
    std::filesystem::remove(defect_file_of(folder, impactor.name()), ignored);
  }
}

}  // namespace perimpact
