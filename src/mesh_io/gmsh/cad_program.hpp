/// Runs an external program in a temporary folder.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace fccda {

/// A temporary folder accessible to its owner only, removed with its contents on destruction.
class TemporaryFolder {
 public:
  TemporaryFolder();  ///< throws RunError where it cannot be created
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

struct ProgramEnd {
  int exit_code = 0;
  int signal = 0;      ///< that terminated the program; 0: none
  std::string output;  ///< the last 64 kB of its standard output and standard error
};

/// Runs `words[0]`, found on PATH, with the other words as arguments and `folder` as working directory, and waits for it to end.
/// Returns nothing where the program does not exist. Its standard input is empty. While it runs, a keyboard interrupt reaches only the
/// program, so that the caller can clean up; ProgramEnd::signal reports it. `variables`: additional environment variables, as NAME=value.
/// Throws RunError where the program exists but cannot be started or waited for.
std::optional<ProgramEnd> run_program(const std::vector<std::string>& words, const TemporaryFolder& folder, const std::vector<std::string>& variables);

}  // namespace fccda
