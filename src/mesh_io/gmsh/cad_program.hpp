/// Another program, run in a temporary folder.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace fccda {

/// A new folder that only its owner may enter, removed with all that is in it.
class TemporaryFolder {
 public:
  TemporaryFolder();  ///< throws RunError where none can be made
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
  int signal = 0;      ///< that ended the program; 0: none did
  std::string output;  ///< the last 64 kB of what it wrote to both of its streams
};

/// Runs `words[0]`, looked up on PATH, with the other words as its arguments and `folder` as its working directory, and waits for its end.
/// Nothing where there is no such program. It has no input. While it runs, an interrupt from the keyboard reaches it alone, so that
/// the caller can clean up; `signal` tells. `variables`: set in its environment besides ours, as NAME=value. Throws RunError where it is there but cannot
/// be started or waited for.
std::optional<ProgramEnd> run_program(const std::vector<std::string>& words, const TemporaryFolder& folder, const std::vector<std::string>& variables);

}  // namespace fccda
