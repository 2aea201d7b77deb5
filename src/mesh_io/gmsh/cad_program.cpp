#include "mesh_io/gmsh/cad_program.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string_view>
#include <system_error>

#include "base/error.hpp"

namespace fccda {
namespace {

/// The argument vector of execve: pointers to the strings and a terminating null pointer.
std::vector<char*> pointers(std::vector<std::string>& strings) {
  std::vector<char*> out;
  for (std::string& string : strings) out.push_back(string.data());
  out.push_back(nullptr);
  return out;
}

std::vector<std::string> environment_with(const std::vector<std::string>& variables) {
  std::vector<std::string> out = variables;
  const auto is_replaced = [&](std::string_view ours) {
    const std::string_view name = ours.substr(0, ours.find('=') + 1);
    return std::any_of(variables.begin(), variables.end(), [&](const std::string& one) { return one.starts_with(name); });
  };
  for (char** variable = environ; *variable != nullptr; ++variable)
    if (!is_replaced(*variable)) out.emplace_back(*variable);
  return out;
}

constexpr int keyboard_signals[] = {SIGINT, SIGQUIT};

/// Ignores keyboard interrupts in this process while a child runs, as system(3) does.
class DeafToKeyboard {
 public:
  DeafToKeyboard() {
    struct sigaction ignore {};
    ignore.sa_handler = SIG_IGN;
    for (std::size_t k = 0; k < std::size(keyboard_signals); ++k) sigaction(keyboard_signals[k], &ignore, &before_[k]);
  }
  ~DeafToKeyboard() {
    for (std::size_t k = 0; k < std::size(keyboard_signals); ++k) sigaction(keyboard_signals[k], &before_[k], nullptr);
  }
  DeafToKeyboard(const DeafToKeyboard&) = delete;
  DeafToKeyboard& operator=(const DeafToKeyboard&) = delete;

 private:
  struct sigaction before_[std::size(keyboard_signals)];
};

class Spawn {
 public:
  Spawn(const std::filesystem::path& folder, const std::filesystem::path& output) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions_, STDOUT_FILENO, output.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    posix_spawn_file_actions_adddup2(&actions_, STDOUT_FILENO, STDERR_FILENO);
    posix_spawn_file_actions_addchdir_np(&actions_, folder.c_str());
    sigset_t heard;
    sigemptyset(&heard);
    for (const int signal : keyboard_signals) sigaddset(&heard, signal);
    posix_spawnattr_init(&attributes_);
    posix_spawnattr_setsigdefault(&attributes_, &heard);
    posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETSIGDEF);
  }
  ~Spawn() {
    posix_spawn_file_actions_destroy(&actions_);
    posix_spawnattr_destroy(&attributes_);
  }
  Spawn(const Spawn&) = delete;
  Spawn& operator=(const Spawn&) = delete;

  /// 0 or an errno.
  int start(pid_t& child, char** words, char** environment) const { return posix_spawnp(&child, words[0], &actions_, &attributes_, words, environment); }

 private:
  posix_spawn_file_actions_t actions_;
  posix_spawnattr_t attributes_;
};

std::string end_of(const std::filesystem::path& path) {
  constexpr std::uintmax_t longest = 64 * 1024;
  std::error_code problem;
  const std::uintmax_t size = std::filesystem::file_size(path, problem);
  std::ifstream file(path, std::ios::binary);
  if (!problem && size > longest) file.seekg(static_cast<std::streamoff>(size - longest));
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

TemporaryFolder::TemporaryFolder() {
  std::error_code problem;
  const std::filesystem::path parent = std::filesystem::temp_directory_path(problem);
  std::string name = (parent / "fccda-XXXXXX").string();
  if (problem || mkdtemp(name.data()) == nullptr)
    throw RunError("cannot create a temporary folder in " + parent.string() + "; free disk space there or set TMPDIR to another folder.");
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::optional<ProgramEnd> run_program(const std::vector<std::string>& words, const TemporaryFolder& folder, const std::vector<std::string>& variables) {
  std::vector<std::string> arguments = words, environment = environment_with(variables);
  const std::filesystem::path output = folder / "output.txt";
  const Spawn spawn(folder.path(), output);
  int status = 0;
  {
    const DeafToKeyboard deaf;
    pid_t child = 0;
    const int problem = spawn.start(child, pointers(arguments).data(), pointers(environment).data());
    if (problem == ENOENT) return {};
    if (problem != 0) throw RunError("the program " + words[0] + " cannot be started: " + std::generic_category().message(problem) + ".");
    while (waitpid(child, &status, 0) < 0)
      if (errno != EINTR) throw RunError("waiting for the program " + words[0] + " failed: " + std::generic_category().message(errno) + ".");
  }
  ProgramEnd end;
  if (WIFSIGNALED(status)) end.signal = WTERMSIG(status);
  if (WIFEXITED(status)) end.exit_code = WEXITSTATUS(status);
  end.output = end_of(output);
  return end;
}

}  // namespace fccda
