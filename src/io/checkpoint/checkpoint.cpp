#include "io/checkpoint/checkpoint.hpp"

#include <fmt/format.h>

#include <fstream>
#include <vector>

#include "base/error.hpp"
#include "io/checkpoint/arrays_writer.hpp"
#include "io/deck/difference.hpp"
#include "io/deck/named_files.hpp"
#include "io/deck/setup_to_text.hpp"
#include "perimpact/deck_model/setup_error.hpp"
#include "perimpact/simulation/state_hash.hpp"

namespace perimpact {

namespace {

constexpr const char* program = "perimpact " PERIMPACT_VERSION;

const std::filesystem::path& expect_there(const std::filesystem::path& path) {
  if (!std::filesystem::exists(path))
    throw fccda::InputError(fmt::format("there is no checkpoint {}, so there is nothing to resume; run without --resume.", path.string()));
  return path;
}

/// Keys that may differ on restart. Input files are compared by contents, not by path.
bool may_differ(std::string_view key) { return key == "output.folder" || key == "output.checkpoint_interval" || key.ends_with(".file"); }

std::string in_words(const std::string& value) { return value.empty() ? "not given" : value; }

}  // namespace

std::uint64_t fingerprint_at_start(Simulation& simulation) {
  StateHash hash;
  simulation.visit_state(hash);
  for (const std::filesystem::path& path : deck::named_files(deck::setup_to_text(simulation.setup()))) {
    std::ifstream file(path, std::ios::binary);
    if (!file) {  // a mesh defined in code; its name identifies its contents
      const std::string name = path.string();
      hash("mesh", std::span<const char>(name));
    }
    std::vector<char> bytes(std::size_t{1} << 20);
    while (file.read(bytes.data(), static_cast<std::streamsize>(bytes.size())) || file.gcount() > 0)
      hash("file", std::span<const char>(bytes.data(), static_cast<std::size_t>(file.gcount())));
  }
  return hash.value();
}

void write_checkpoint(const std::filesystem::path& path, Simulation& simulation, std::uint64_t at_start, Written written) {
  checkpoint::ArraysWriter file(path);
  file.text("setup", deck::setup_to_text(simulation.setup()));
  simulation.visit_state([&](std::string_view name, auto&& values) { file("state/" + std::string(name), values); });
  simulation.visit_record([&](std::string_view name, auto&& values) { file("record/" + std::string(name), values); });
  written.visit_state([&](std::string_view name, auto&& values) { file("written/" + std::string(name), values); });
  file.word("program", program);
  file.number("step", std::int64_t{simulation.clock().step});
  file.number("steps", std::int64_t{simulation.clock().steps});
  file.number("time [s]", simulation.clock().time());
  file.number("fingerprint_at_start", at_start);
  file.number("state_hash", simulation.state_hash());
  file.finish();
}

Checkpoint::Checkpoint(const std::filesystem::path& path) : path_(expect_there(path)), file_(path) {
  if (const std::string writer = file_.word("program"); writer != program)
    throw fccda::InputError(
        fmt::format("{} was written by {}, but this is {}, whose results may differ; resume with the original version, or start a new run without --resume.",
                    path_.string(), writer, program));
  step_ = static_cast<long>(file_.integer("step"));
  steps_ = static_cast<long>(file_.integer("steps"));
}

void Checkpoint::expect_deck(const Setup& setup) {
  const auto difference = deck::first_difference(file_.text("setup"), deck::setup_to_text(setup), may_differ);
  if (difference)
    throw SetupError(difference->key,
                     fmt::format("{} is {} here, but {} in the run of the checkpoint {}; resume with the same deck, or start a new run without --resume.",
                                 difference->key, in_words(difference->now), in_words(difference->before), path_.string()));
}

Written Checkpoint::restore(Simulation& simulation, std::uint64_t at_start) {
  if (at_start != file_.natural("fingerprint_at_start"))
    throw fccda::InputError(
        fmt::format("{} was written from a different initial state of the same deck: a file that the deck refers to has changed, or the program was rebuilt. "
                    "Restore the file, or start a new run without --resume.",
                    path_.string()));
  Written written(simulation.bodies().size(), simulation.impactors().size());
  simulation.visit_state([&](std::string_view name, auto&& values) { file_("state/" + std::string(name), values); });
  simulation.visit_record([&](std::string_view name, auto&& values) { file_("record/" + std::string(name), values); });
  written.visit_state([&](std::string_view name, auto&& values) { file_("written/" + std::string(name), values); });
  file_.expect_all_read();
  if (simulation.state_hash() != file_.natural("state_hash"))
    throw fccda::InputError(fmt::format("{} does not restore the state that was written; start a new run without --resume.", path_.string()));
  return written;
}

}  // namespace perimpact
