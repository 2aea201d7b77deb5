/// Lock of a results folder: `run.lock`, which names the process that writes there, so that two runs never mix their results.
///
/// The lock is the existence of the file. It appears complete in one step, as a hard link of a finished file: link() fails where the name exists,
/// on local and on network file systems, in every version of NFS. Locks of the operating system (flock, fcntl) end with their process, but on many
/// clusters they are not passed between nodes, or not supported.
///
/// SIGKILL and power failures leave the file behind. On the same kernel it is stale if its process is gone; a process number that another process
/// has got since is recognised by the start time, and another process namespace (container) by its number. After a restart of the machine it is
/// stale too. What a process on another machine does cannot be known, so that such a lock is never replaced, only deleted by the user.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>

namespace perimpact {

class FolderLock {
 public:
  /// Throws InputError where another run has the folder, or the file cannot be written. The folder must exist.
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();  ///< deletes the file
  FolderLock(FolderLock&& other) noexcept;
  FolderLock& operator=(FolderLock&&) = delete;

  /// A sentence about the stale lock that was replaced; empty if there was none.
  const std::string& note() const { return note_; }

  static std::filesystem::path file_in(const std::filesystem::path& folder) { return folder / "run.lock"; }

 private:
  std::filesystem::path file_;  // empty after a move
  std::string text_;            // of the file
  pid_t process_;               // a forked copy does not own the lock
  std::string note_;
};

}  // namespace perimpact
