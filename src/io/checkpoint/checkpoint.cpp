#include "io/checkpoint/checkpoint.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <vector>

#include "base/error.hpp"
#include "io/checkpoint/arrays_writer.hpp"
#include "io/deck/difference.hpp"
#include "io/deck/named_files.hpp"
#include "io/deck/setup_to_text.hpp"
#include "io/results/results_writer.hpp"
#include "perimpact/deck_model/setup_error.hpp"
#include "perimpact/simulation/ranks_report.hpp"
#include "perimpact/simulation/state_hash.hpp"

namespace perimpact {

namespace {

constexpr const char* program = "perimpact " PERIMPACT_VERSION;

const std::filesystem::path& expect_there(const std::filesystem::path& path) {
  if (std::filesystem::is_regular_file(path.parent_path()))
    throw fccda::InputError(fmt::format("{} is a file, but the folder of a run is needed to resume it.", path.parent_path().string()));
  if (!std::filesystem::exists(path))
    throw fccda::InputError(fmt::format("there is no checkpoint {}, so there is nothing to resume; run without --resume.", path.string()));
  return path;
}

/// Keys that may differ on restart. Input files are compared by contents, not by path. A run can be prolonged: what these keys of time and output
/// result in is compared when the simulation is built (expect_same_steps).
bool may_differ(std::string_view key) {
  constexpr std::string_view keys[] = {"output.folder", "output.checkpoint_interval", "output.checkpoints_kept", "output.frames", "time.end",
                                       "time.step",     "time.relax.increments",      "output.history_interval"};
  return std::ranges::find(keys, key) != std::end(keys) || key.ends_with(".file");
}

std::string load_name(const std::string& body) { return "loads/" + body; }

std::string in_words(const std::string& value) { return value.empty() ? "not given" : value; }

}  // namespace

std::uint64_t fingerprint_at_start(Simulation& simulation) {
  StateHash hash;
  hash("state", std::span<const std::uint64_t>(std::array{simulation.state_hash()}));
  const std::vector<std::filesystem::path> files = deck::named_files(deck::setup_to_text(simulation.setup()));
  for (std::size_t number = 0; number < files.size(); ++number) {
    std::ifstream file(files[number], std::ios::binary);
    if (!file) {  // a mesh defined in code; its name identifies its contents
      const std::string name = files[number].string();
      hash.add(fmt::format("mesh {}", number), 0, std::span<const char>(name));
    }
    std::vector<char> bytes(std::size_t{1} << 20);
    std::uint64_t read = 0;
    while (file.read(bytes.data(), static_cast<std::streamsize>(bytes.size())) || file.gcount() > 0) {
      const auto count = static_cast<std::size_t>(file.gcount());
      hash.add(fmt::format("file {}", number), read, std::span<const char>(bytes.data(), count));
      read += count;
    }
  }
  return hash.value();
}

void write_checkpoint(const std::filesystem::path& path, Simulation& simulation, std::uint64_t at_start, Written written) {
  const std::uint64_t state_hash = simulation.state_hash();
  const std::vector<MeasuredLoad> loads = measured_loads(simulation);
  if (!simulation.ranks().is_root()) {
    simulation.visit_whole_state([](std::string_view, auto&&) {});
    simulation.visit_whole_record([](std::string_view, auto&&) {});
    return;
  }
  checkpoint::ArraysWriter file(path);
  file.text("setup", deck::setup_to_text(simulation.setup()));
  simulation.visit_whole_state([&](std::string_view name, auto&& values) { file("state/" + std::string(name), values); });
  simulation.visit_whole_record([&](std::string_view name, auto&& values) { file("record/" + std::string(name), values); });
  written.visit_state([&](std::string_view name, auto&& values) { file("written/" + std::string(name), values); });
  for (std::size_t b = 0; b < loads.size(); ++b) {
    std::vector<double> numbers = numbers_of(loads[b]);
    file(load_name(simulation.bodies()[b].name), numbers);
  }
  file.word("program", program);
  file.number("step", std::int64_t{simulation.clock().step});
  file.number("steps", std::int64_t{simulation.clock().steps});
  file.number("time [s]", simulation.clock().time());
  file.number("time.end [s]", simulation.setup().time.end);
  file.number("step size [s]", simulation.clock().dt);
  file.number("steps per row", std::int64_t{simulation.monitors().interval()});
  file.number("fingerprint_at_start", at_start);
  file.number("state_hash", state_hash);
  file.finish();
}

Checkpoint::Checkpoint(const std::filesystem::path& path) : path_(expect_there(path)), file_(path) {
  if (const std::string writer = file_.word("program"); writer != program)
    throw fccda::InputError(
        fmt::format("{} was written by {}, but this is {}, whose results may differ; resume with the original version, or start a new run without --resume.",
                    path_.string(), writer, program));
  step_ = static_cast<long>(file_.integer("step"));
  steps_ = static_cast<long>(file_.integer("steps"));
  end_ = file_.number("time.end [s]");
}

void Checkpoint::expect_deck(const Setup& setup) {
  const auto difference = deck::first_difference(file_.text("setup"), deck::setup_to_text(setup), may_differ);
  if (difference)
    throw SetupError(difference->key,
                     fmt::format("{} is {} here, but {} in the run of the checkpoint {}; resume with the same deck, or start a new run without --resume.",
                                 difference->key, in_words(difference->now), in_words(difference->before), path_.string()));
  if (setup.time.end < end_)
    throw SetupError("time.end", fmt::format("time.end is {} here, but {} in the run of the checkpoint {}; a run can be prolonged, but not shortened. Resume "
                                             "with at least the end of that run, or start a new run without --resume.",
                                             setup.time.end, end_, path_.string()));
}

void Checkpoint::expect_same_steps(const Simulation& simulation) {
  const Setup& setup = simulation.setup();
  const Clock& clock = simulation.clock();
  const double dt = file_.number("step size [s]");
  if (setup.time.relax && clock.dt != dt)
    throw SetupError("time.relax",
                     fmt::format("an increment is {} s here, but {} s in the run of the checkpoint {}; resume with --set time.relax.increments={}.", clock.dt,
                                 dt, path_.string(), std::lround(setup.time.end / dt)));
  if (clock.dt != dt)
    throw SetupError("time", fmt::format("the time step is {} s here, but {} s in the run of the checkpoint {}; resume with --set time.step={}.", clock.dt, dt,
                                         path_.string(), dt));
  const long per_row = static_cast<long>(file_.integer("steps per row"));
  if (simulation.monitors().interval() != per_row)
    throw SetupError("output", fmt::format("history.csv has a row every {} steps here, but every {} in the run of the checkpoint {}; resume with --set "
                                           "output.history_interval={}.",
                                           simulation.monitors().interval(), per_row, path_.string(), static_cast<double>(per_row) * dt));
}

std::vector<MeasuredLoad> Checkpoint::loads(const Setup& setup) {
  std::vector<MeasuredLoad> loads;
  for (const BodySetup& body : setup.bodies) {
    std::vector<double> numbers;
    file_(load_name(body.name), numbers);
    loads.push_back(load_of(numbers));
  }
  return loads;
}

void Checkpoint::expect_intact(Ranks& ranks) {
  std::string fault;
  if (ranks.is_root()) {
    try {
      file_.expect_intact();
    } catch (const fccda::InputError& error) {
      fault = error.what();
    }
  }
  if (ranks.any(!fault.empty())) throw fccda::InputError(ranks.is_root() ? fault : path_.string() + " is damaged.");
}

Written Checkpoint::restore(Simulation& simulation, std::uint64_t at_start) {
  expect_same_steps(simulation);
  if (at_start != file_.natural("fingerprint_at_start"))
    throw fccda::InputError(
        fmt::format("{} was written from a different initial state of the same deck: a file that the deck refers to has changed, or the program was rebuilt. "
                    "Restore the file, or start a new run without --resume.",
                    path_.string()));
  Written written(simulation.bodies().size(), simulation.impactors().size());
  simulation.take_whole_state([&](std::string_view name, auto&& values) { file_("state/" + std::string(name), values); });
  simulation.take_whole_record([&](std::string_view name, auto&& values) { file_("record/" + std::string(name), values); });
  written.visit_state([&](std::string_view name, auto&& values) { file_("written/" + std::string(name), values); });
  loads(simulation.setup());  // used by the ranks when they divided the bodies
  if (simulation.ranks().is_root()) file_.expect_all_read();
  if (simulation.state_hash() != file_.natural("state_hash"))
    throw fccda::InputError(fmt::format("{} does not restore the state that was written; start a new run without --resume.", path_.string()));
  return written;
}

}  // namespace perimpact
