#include "run/run_loop.hpp"

#include <fmt/format.h>

#include <new>
#include <utility>

#include "run/stop_signals.hpp"

namespace perimpact {

namespace {

/// Fragments in contact need more memory than the intact body (docs/guide/cluster.md).
fccda::RunError out_of_memory(long step) {
  return fccda::RunError(fmt::format("After step {} there is not enough memory; use a machine with more of it, or a larger spacing.", step));
}

}  // namespace

using std::chrono::steady_clock;

void RunLoop::begin_results(const RunFolder& folder) {
  resume_ = folder.requests().resume;
  checkpoints_.emplace(folder.path(), simulation_);
  if (!folder.is_resumed()) {
    results_.emplace(simulation_, folder.path());
    checkpoints_->after_step(simulation_, *results_);  // in a run of one step, this is the state before the last
    return;
  }
  Written written = checkpoints_->resume(simulation_);
  results_.emplace(simulation_, folder.path(), std::move(written));
  note_ = checkpoints_->note();
}

double RunLoop::seconds() const { return seconds_before_ + (begin_ ? std::chrono::duration<double>(steady_clock::now() - *begin_).count() : 0); }

void RunLoop::run(const Watch& watch) {
  struct Period {
    explicit Period(RunLoop& of) : loop(of) { loop.begin_ = steady_clock::now(); }
    ~Period() {
      loop.seconds_before_ = loop.seconds();
      loop.begin_.reset();
    }
    RunLoop& loop;
  } const period(*this);

  bool is_paused = false;
  Ranks& ranks = simulation_.ranks();  // which receive signals and look at clocks at different times, but pause and write together
  const Watch watched{.after_step = watch.after_step, .in_increment = [&] {
                        is_paused = ranks.any(!watch.in_increment());
                        return !is_paused && !ranks.any(StopSignals::save_is_pending());
                      }};
  while (!is_paused && !simulation_.clock().is_finished()) {
    const long before = simulation_.clock().step;
    step(watched);
    if (ranks.any(StopSignals::take_save_request())) save();
    if (simulation_.clock().step > before) is_paused = ranks.any(!watch.after_step());
  }
  if (!results_ || !simulation_.clock().is_finished()) return;
  write([&] { results_->finish(simulation_, Outcome::finished, "", seconds()); });
  results_.reset();
}

Traffic RunLoop::collectives_in_step(const OutputSetup& setup) {
  Traffic traffic;
  const int questions = setup.checkpoint_interval > 0 ? 3 : 2;  // SIGUSR1, pause, checkpoint
  for (int k = 0; k < questions; ++k) traffic += reduction_of(1);
  return traffic;
}

void RunLoop::step(const Watch& watch) {
  const long before = simulation_.clock().step;
  try {
    simulation_.step([&](const Relaxed&) { return watch.in_increment(); });
  } catch (const fccda::RunError& error) {
    fail(error, false);
  } catch (const std::bad_alloc&) {
    fail(out_of_memory(before), true);
  }
  is_within_increment_ = simulation_.clock().step == before;
  if (is_within_increment_ || !results_) return;
  write([&] {
    results_->after_step(simulation_);
    checkpoints_->after_step(simulation_, *results_);
  });
}

void RunLoop::save() {
  if (!results_) return;
  write([&] {
    if (is_within_increment_)
      checkpoints_->write_within_increment(simulation_, *results_);
    else
      checkpoints_->write(simulation_, *results_);
  });
}

void RunLoop::interrupt() {
  if (!results_) return;
  save();
  write([&] { results_->finish(simulation_, Outcome::interrupted, "", seconds()); });
  results_.reset();
}

template <class Write>
void RunLoop::write(const Write& write_files) {
  try {
    write_files();
  } catch (const fccda::RunError& error) {
    fail(error, true);
  } catch (const std::bad_alloc&) {
    fail(out_of_memory(simulation_.clock().step), true);
  }
}

void RunLoop::fail(const fccda::RunError& error, bool can_be_resumed) {
  if (!results_) throw error;
  std::string sentence = error.what();
  if (const auto last = checkpoints_->last())
    sentence += fmt::format(" The last checkpoint is at step {}{}", *last, can_be_resumed ? "; resume from it with " + resume_ : ".");
  try {  // of several ranks perhaps only this one has failed: then nothing can be gathered, and the results remain as they are
    if (simulation_.ranks().size() == 1) results_->finish(simulation_, Outcome::failed, sentence, seconds());
  } catch (const std::exception&) {  // the files, or the memory that they take, are what lacks
    // nothing more can be written; the first error is the one to report
  }
  results_.reset();
  throw fccda::RunError(sentence);
}

}  // namespace perimpact
