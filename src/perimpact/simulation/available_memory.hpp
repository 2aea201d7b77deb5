/// Memory that this process may use: the least of what the machine has available, and of the limits of its control groups and of ulimit. The system
/// grants allocations beyond the first two and ends the program later, without a message.
#pragma once

#include <filesystem>
#include <string>

namespace perimpact {

struct AvailableMemory {
  double bytes;        ///< of this process, including what it uses already
  std::string reason;  ///< "only 3.2 GB of the 16 GB of this machine are available"
  std::string remedy;  ///< "a machine with more memory"
};

/// `root`: of the file system, for tests. Reads proc/meminfo, proc/self and sys/fs/cgroup, of control groups version 2 (memory.max of the group and those
/// above it) and 1 (memory.limit_in_bytes). Page cache that can be reclaimed counts as available. RLIMIT_AS and RLIMIT_DATA are those of the process.
AvailableMemory available_memory(const std::filesystem::path& root = "/");

}  // namespace perimpact
