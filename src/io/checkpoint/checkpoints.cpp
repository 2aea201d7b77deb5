#include "io/checkpoint/checkpoints.hpp"

#include <fmt/format.h>

#include <system_error>
#include <vector>

#include "base/error.hpp"
#include "perimpact/deck_model/setup_error.hpp"

namespace perimpact {

namespace fs = std::filesystem;

namespace {

constexpr int max_age = 100;  // of output.checkpoints_kept

fs::path aged(const fs::path& folder, int age) { return output::ResultsFolder::checkpoint_in(folder, age); }

/// Ages of the checkpoints that exist, the latest first.
std::vector<int> ages_in(const fs::path& folder) {
  std::vector<int> ages;
  std::error_code ignored;
  for (int age = 0; age < max_age; ++age)
    if (fs::exists(aged(folder, age), ignored)) ages.push_back(age);
  return ages;
}

/// Calls use(checkpoint, age) for the newest checkpoint for which it succeeds. An error in the deck is not one of the checkpoint.
template <class Use>
auto with_newest(const fs::path& folder, const Use& use) -> decltype(use(std::declval<Checkpoint&>(), 0, std::string())) {
  std::string fault;
  for (const int age : ages_in(folder)) {
    try {
      Checkpoint checkpoint(aged(folder, age));
      return use(checkpoint, age, fault);
    } catch (const SetupError&) {
      throw;
    } catch (const fccda::InputError& error) {
      if (fault.empty()) fault = error.what();
    }
  }
  if (fault.empty()) const Checkpoint none(aged(folder, 0));  // throws
  throw fccda::InputError(fault);
}

Reached reached(const Checkpoint& checkpoint) { return {checkpoint.step(), checkpoint.steps(), checkpoint.end()}; }

}  // namespace

bool has_checkpoint(const fs::path& folder) { return !ages_in(folder).empty(); }

Reached newest_checkpoint(const fs::path& folder) {
  return with_newest(folder, [](const Checkpoint& checkpoint, int, const std::string&) { return reached(checkpoint); });
}

Reached newest_checkpoint(const fs::path& folder, const Setup& setup) {
  return with_newest(folder, [&](Checkpoint& checkpoint, int, const std::string&) {
    checkpoint.expect_deck(setup);
    Reached all = reached(checkpoint);
    all.loads = checkpoint.loads(setup);
    return all;
  });
}

Checkpoints::Checkpoints(fs::path folder, Simulation& simulation)
    : folder_(std::move(folder)),
      every_(simulation.setup().output.checkpoint_interval),
      kept_(simulation.setup().output.checkpoints_kept),
      at_start_(fingerprint_at_start(simulation)) {}

Written Checkpoints::resume(Simulation& simulation) {
  return with_newest(folder_, [&](Checkpoint& from, int age, const std::string& fault) {
    from.expect_deck(simulation.setup());
    if (simulation.ranks().size() > 1) from.expect_intact(simulation.ranks());
    Written written = from.restore(simulation, at_start_);
    last_ = from.step();
    resumed_age_ = age;
    if (!fault.empty()) note_ = fmt::format("{} The run resumes from the older checkpoint {} (step {}).", fault, aged(folder_, age).string(), from.step());
    return written;
  });
}

void Checkpoints::after_step(Simulation& simulation, ResultsWriter& results) {
  const Clock& clock = simulation.clock();
  const auto now = std::chrono::steady_clock::now();
  const bool is_due = every_ > 0 && simulation.ranks().any(std::chrono::duration<double>(now - written_).count() >= every_);
  if ((is_due && !clock.is_finished()) || clock.step == clock.steps - 1) write(simulation, results);
}

void Checkpoints::write(Simulation& simulation, ResultsWriter& results) {
  if (last_ != simulation.clock().step) write_within_increment(simulation, results);
}

void Checkpoints::write_within_increment(Simulation& simulation, ResultsWriter& results) {
  const fs::path latest = aged(folder_, 0), next = kept_ > 1 ? output::ResultsFolder::next_checkpoint_in(folder_) : latest;
  write_checkpoint(next, simulation, at_start_, results.written());
  if (simulation.ranks().is_root()) rotate();
  resumed_age_ = 0;
  last_ = simulation.clock().step;
  written_ = std::chrono::steady_clock::now();
}

void Checkpoints::rotate() const {
  const fs::path latest = aged(folder_, 0);
  std::error_code ignored;
  if (kept_ == 1) {
    for (const int age : ages_in(folder_))
      if (age > 0) fs::remove(aged(folder_, age), ignored);
    return;
  }
  std::vector<int> intact;
  for (const int age : ages_in(folder_)) {
    if (age < resumed_age_ || static_cast<int>(intact.size()) == kept_ - 1)
      fs::remove(aged(folder_, age), ignored);
    else
      intact.push_back(age);
  }
  if (resumed_age_ == 0) {
    for (std::size_t k = intact.size(); k-- > 0;)
      if (intact[k] > 0) fs::rename(aged(folder_, intact[k]), aged(folder_, static_cast<int>(k) + 1), ignored);
    // a link, so that checkpoint.h5 exists at every moment; not every file system has links
    if (fs::create_hard_link(latest, aged(folder_, 1), ignored); ignored) fs::rename(latest, aged(folder_, 1), ignored);
  } else {
    for (std::size_t k = 0; k < intact.size(); ++k) fs::rename(aged(folder_, intact[k]), aged(folder_, static_cast<int>(k) + 1), ignored);
  }
  std::error_code error;
  fs::rename(output::ResultsFolder::next_checkpoint_in(folder_), latest, error);
  if (error) throw fccda::RunError(fmt::format("{} cannot be written: {}. Everything written before is intact.", latest.string(), error.message()));
}

}  // namespace perimpact
