#include "run/setup_signals.hpp"

#include <unistd.h>

#include <array>
#include <csignal>
#include <cstddef>

namespace perimpact {

namespace {

constexpr std::array handled{SIGINT, SIGTERM, SIGHUP, SIGXCPU};

// what the handler reads; it may not allocate
std::string last_sentence, lock_file;
std::array<struct sigaction, handled.size()> former;

extern "C" void end_set_up(int signal) {
  if (!lock_file.empty()) ::unlink(lock_file.c_str());
  if (!last_sentence.empty()) [[maybe_unused]]
    const ssize_t written = ::write(STDOUT_FILENO, last_sentence.data(), last_sentence.size());
  ::_exit(128 + signal);
}

bool is_default(const struct sigaction& action) { return (action.sa_flags & SA_SIGINFO) == 0 && action.sa_handler == SIG_DFL; }

}  // namespace

SetupSignals::SetupSignals(const std::string& sentence, const RunFolder* folder) {
  last_sentence = sentence;
  lock_file = folder ? FolderLock::file_in(folder->path()).string() : "";
  struct sigaction ending {};
  ending.sa_handler = end_set_up;
  for (std::size_t k = 0; k < handled.size(); ++k) {
    sigaction(handled[k], nullptr, &former[k]);
    if (is_default(former[k])) sigaction(handled[k], &ending, nullptr);
  }
}

SetupSignals::~SetupSignals() {
  for (std::size_t k = 0; k < handled.size(); ++k)
    if (is_default(former[k])) sigaction(handled[k], &former[k], nullptr);
}

}  // namespace perimpact
