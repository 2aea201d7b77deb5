#include "run/folder_lock.hpp"

#include <fcntl.h>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstring>
#include <ctime>
#include <fstream>
#include <iterator>
#include <optional>
#include <sstream>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "io/output/file.hpp"

namespace perimpact {

namespace fs = std::filesystem;

namespace {

std::string first_line_of(const char* file) {
  std::string line;
  std::getline(std::ifstream(file) >> std::ws, line);
  return line;
}

/// State and start time of a process, in clock ticks since the machine started, from /proc.
struct Process {
  char state;
  std::string start;
};
std::optional<Process> process_of(pid_t pid) {
  const std::string text = first_line_of(fmt::format("/proc/{}/stat", pid).c_str());
  const std::size_t name_end = text.rfind(')');  // the name may contain anything
  if (name_end == std::string::npos) return std::nullopt;
  std::istringstream fields(text.substr(name_end + 1));
  std::vector<std::string> words{std::istream_iterator<std::string>(fields), {}};
  constexpr std::size_t start = 19;  // field 22 of the file, of which the first two are the number and the name
  if (words.size() <= start) return std::nullopt;
  return Process{words[0][0], words[start]};
}

/// What a lock file says.
struct Owner {
  std::string host, machine, boot, names, start, since;
  pid_t pid = 0;

  bool is_complete() const { return pid > 0 && !host.empty() && !since.empty(); }
  std::string in_words() const { return fmt::format("process {} on host {}, since {}", pid, host, since); }
};

std::string name_of_host() {
  char name[256] = "";
  ::gethostname(name, sizeof name - 1);
  return *name ? name : "unknown";
}

Owner myself() {
  const std::optional<Process> process = process_of(::getpid());
  std::error_code ignored;
  const std::time_t now = std::time(nullptr);
  return {.host = name_of_host(),
          .machine = first_line_of("/etc/machine-id"),
          .boot = first_line_of("/proc/sys/kernel/random/boot_id"),
          .names = fs::read_symlink("/proc/self/ns/pid", ignored).string(),
          .start = process ? process->start : "",
          .since = fmt::format("{:%Y-%m-%d %H:%M:%S} UTC", fmt::gmtime(now)),
          .pid = ::getpid()};
}

std::string text_of(const Owner& owner) {
  return fmt::format(
      "# A run writes into this folder; see the guide, restart.md.\nhost: {}\npid: {}\nsince: {}\nprocess_start: {}\npid_namespace: {}\nboot: {}\n"
      "machine: {}\n",
      owner.host, owner.pid, owner.since, owner.start, owner.names, owner.boot, owner.machine);
}

/// Empty if the file does not exist.
std::optional<std::string> contents_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return std::nullopt;
  return std::string{std::istreambuf_iterator<char>(stream), {}};
}

Owner read_owner(const std::string& text) {
  Owner owner;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with('#') || colon == std::string::npos) continue;
    const std::string key = line.substr(0, colon), value = line.substr(colon + 2);
    if (key == "host") owner.host = value;
    if (key == "machine") owner.machine = value;
    if (key == "boot") owner.boot = value;
    if (key == "pid_namespace") owner.names = value;
    if (key == "process_start") owner.start = value;
    if (key == "since") owner.since = value;
    if (key == "pid") std::from_chars(value.data(), value.data() + value.size(), owner.pid);
  }
  return owner;
}

enum class Life { runs, ended, unknown };

Life life_of(const Owner& owner, const Owner& me) {
  const bool same_kernel = !me.boot.empty() && owner.boot == me.boot;
  if (!same_kernel) {
    const bool restarted = owner.host == me.host && !me.machine.empty() && owner.machine == me.machine && !owner.boot.empty() && !me.boot.empty();
    return restarted ? Life::ended : Life::unknown;
  }
  if (owner.names != me.names) return Life::unknown;
  if (::kill(owner.pid, 0) != 0 && errno == ESRCH) return Life::ended;
  const std::optional<Process> process = process_of(owner.pid);
  if (!process) return Life::runs;  // of a user whose processes are hidden
  const bool has_ended = process->state == 'Z' || process->state == 'X';
  return has_ended || process->start != owner.start ? Life::ended : Life::runs;
}

[[noreturn]] void refuse(const fs::path& folder, const fs::path& lock, const Owner& owner, Life life, const Owner& me) {
  if (!owner.is_complete())
    throw fccda::InputError(fmt::format("{} does not say which run has the folder {}. If no run is writing there, delete that file: rm '{}'.", lock.string(),
                                        folder.string(), lock.string()));
  if (life == Life::runs)
    throw fccda::InputError(fmt::format("another run is writing into the folder {}: {}{}. Wait until it has ended, or choose another folder.", folder.string(),
                                        owner.in_words(), owner.pid == me.pid ? " (this process)" : ""));
  throw fccda::InputError(
      fmt::format("another run has the folder {}: {}. Whether it still runs cannot be determined from here ({}); if it has ended, delete its lock: rm '{}'.",
                  folder.string(), owner.in_words(), owner.boot == me.boot ? "another container" : "host " + me.host, lock.string()));
}

/// The finished file that becomes the lock.
class Draft {
 public:
  Draft(const fs::path& folder, const std::string& text) : path_(folder / fmt::format(".run.lock.{}.{}", name_of_host(), ::getpid())) {
    ::unlink(path_.c_str());  // of a killed process with this number: another name of its lock
    std::ofstream file(path_, std::ios::binary);
    file << text << std::flush;
    if (file) return;
    const std::string reason = std::strerror(errno);
    ::unlink(path_.c_str());
    throw fccda::InputError(fmt::format("results cannot be written to the folder {}: {}. Choose another one with --out, or with output.folder in the deck.",
                                        folder.string(), reason));
  }
  ~Draft() { ::unlink(path_.c_str()); }
  Draft(const Draft&) = delete;
  Draft& operator=(const Draft&) = delete;

  const fs::path& path() const { return path_; }
  bool is_linked() const {
    struct stat status {};
    return ::stat(path_.c_str(), &status) == 0 && status.st_nlink == 2;
  }

 private:
  fs::path path_;
};

/// Creates the lock; false if it exists.
bool create(const Draft& draft, const fs::path& lock, const std::string& text) {
  if (::link(draft.path().c_str(), lock.c_str()) == 0 || draft.is_linked()) return true;  // NFS may report an error although the link was made
  if (errno == EEXIST) return false;
  // a file system without links
  const output::Descriptor file(::open(lock.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
  if (!file.is_open() && errno == EEXIST) return false;
  if (file.is_open() && ::write(file.number(), text.data(), text.size()) == static_cast<ssize_t>(text.size())) return true;
  const int reason = errno;
  if (file.is_open()) ::unlink(lock.c_str());  // it would keep others out
  throw fccda::InputError(
      fmt::format("{} cannot be written: {}. Choose another folder with --out, or with output.folder in the deck.", lock.string(), std::strerror(reason)));
}

/// Puts the draft in the place of a stale lock; false if another process was first. That is decided by flock, which all processes of this kernel
/// share; processes of other machines do not replace this lock.
bool replace(const Draft& draft, const fs::path& lock, const std::string& stale) {
  const output::Descriptor file(::open(lock.c_str(), O_RDONLY | O_CLOEXEC));
  if (!file.is_open()) return false;
  if (::flock(file.number(), LOCK_EX) != 0)
    throw fccda::InputError(fmt::format("{} is the lock of a run that has ended, but this file system cannot replace it safely ({}); delete it: rm '{}'.",
                                        lock.string(), std::strerror(errno), lock.string()));
  struct stat opened {
  }, present{};
  const bool is_same = ::fstat(file.number(), &opened) == 0 && ::stat(lock.c_str(), &present) == 0 && opened.st_ino == present.st_ino;
  return is_same && contents_of(lock) == stale && ::rename(draft.path().c_str(), lock.c_str()) == 0;
}

}  // namespace

FolderLock::FolderLock(const fs::path& folder) : file_(file_in(folder)), process_(::getpid()) {
  const Owner me = myself();
  text_ = text_of(me);
  const Draft draft(folder, text_);
  while (!create(draft, file_, text_)) {
    const std::optional<std::string> text = contents_of(file_);
    if (!text) continue;  // released meanwhile
    const Owner owner = read_owner(*text);
    const Life life = owner.is_complete() ? life_of(owner, me) : Life::unknown;
    if (life != Life::ended) refuse(folder, file_, owner, life, me);
    if (!replace(draft, file_, *text)) continue;
    note_ = fmt::format("The lock of a run that has ended ({}) was removed from the folder {}.", owner.in_words(), folder.string());
    return;
  }
}

FolderLock::FolderLock(FolderLock&& other) noexcept
    : file_(std::exchange(other.file_, {})), text_(std::move(other.text_)), process_(other.process_), note_(std::move(other.note_)) {}

FolderLock::~FolderLock() {
  if (!file_.empty() && process_ == ::getpid() && contents_of(file_) == text_) ::unlink(file_.c_str());
}

}  // namespace perimpact
