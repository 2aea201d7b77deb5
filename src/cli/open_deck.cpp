#include "cli/open_deck.hpp"

#include <fmt/format.h>

#include <system_error>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "io/output/results_folder.hpp"
#include "io/results/defect_files.hpp"
#include "perimpact/impactor/surface_of.hpp"
#include "run/run_folder.hpp"

namespace perimpact {

namespace {

std::filesystem::path defect_file_of(const std::filesystem::path& folder, const std::string& impactor) { return folder / (impactor + "_defects.vtp"); }

}  // namespace

deck::Deck open_deck(const DeckArguments& arguments) {
  if (arguments.threads > 0) fccda::use_threads(arguments.threads);
  deck::Deck deck = deck::read_deck(arguments.deck, arguments.set);
  for (const std::string& warning : deck.warnings) fmt::print("warning: {}\n", warning);
  return deck;
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
    output::prepare_folder(folder.path);
    const std::filesystem::path file = defect_file_of(folder.path, error.impactor());
    write_defects(file, error.panels(), {&error.defect(), 1});
    if (folder.lists_files) output::list_file(folder.path, file.filename().string());
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
