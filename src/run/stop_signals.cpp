#include "run/stop_signals.hpp"

#include <array>
#include <csignal>
#include <cstddef>

namespace perimpact {

namespace {

constexpr std::array handled{SIGINT, SIGTERM, SIGHUP, SIGXCPU, SIGUSR1};

volatile std::sig_atomic_t stop_signal = 0, save_request = 0, second_ends = 0;
std::array<int, handled.size()> objects{};  // of each signal
std::array<struct sigaction, handled.size()> former;

extern "C" void record_signal(int signal) {
  if (signal == SIGUSR1) {
    save_request = 1;
  } else if (stop_signal == 0) {
    stop_signal = signal;
  } else if (signal == SIGINT && second_ends != 0) {
    std::signal(SIGINT, SIG_DFL);
    std::raise(SIGINT);  // delivered when this handler returns
  }
}

bool is_ours(int signal, const struct sigaction& action) { return signal == SIGINT || ((action.sa_flags & SA_SIGINFO) == 0 && action.sa_handler == SIG_DFL); }

}  // namespace

bool StopSignals::concerns(int signal) const { return signal != SIGINT || interrupts_ != Interrupts::left; }

StopSignals::StopSignals(Interrupts interrupts) : interrupts_(interrupts) {
  struct sigaction recording {};
  recording.sa_handler = record_signal;
  recording.sa_flags = SA_RESTART;
  for (std::size_t k = 0; k < handled.size(); ++k) {
    if (!concerns(handled[k]) || objects[k]++ > 0) continue;
    if (handled[k] == SIGINT) second_ends = interrupts == Interrupts::second_ends_program;
    sigaction(handled[k], nullptr, &former[k]);
    if (is_ours(handled[k], former[k])) sigaction(handled[k], &recording, nullptr);
  }
}

StopSignals::~StopSignals() {
  for (std::size_t k = 0; k < handled.size(); ++k)
    if (concerns(handled[k]) && --objects[k] == 0 && is_ours(handled[k], former[k])) sigaction(handled[k], &former[k], nullptr);
}

int StopSignals::pending() { return stop_signal; }

int StopSignals::take() {
  const int signal = stop_signal;
  stop_signal = 0;
  return signal;
}

bool StopSignals::save_is_pending() { return save_request != 0; }

bool StopSignals::take_save_request() {
  const bool is_pending = save_request != 0;
  save_request = 0;
  return is_pending;
}

}  // namespace perimpact
