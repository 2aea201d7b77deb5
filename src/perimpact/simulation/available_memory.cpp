#include "perimpact/simulation/available_memory.hpp"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <optional>
#include <sstream>
#include <vector>

#include "base/parallel.hpp"

namespace perimpact {

namespace fs = std::filesystem;

namespace {

double page() { return static_cast<double>(sysconf(_SC_PAGESIZE)); }

/// The number in a file; empty for "max", and for a file that is missing.
std::optional<double> number_in(const fs::path& path) {
  std::ifstream file(path);
  double value;
  return file >> value ? std::optional(value) : std::nullopt;
}

/// [bytes] the number after a key at the beginning of a line; 0 without it.
double number_after(const fs::path& path, std::string_view key) {
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string name;
    double value;
    if (words >> name >> value && name == key) return value;
  }
  return 0;
}

/// [bytes] of this process.
struct Usage {
  double mapped = 0, resident = 0, data = 0;

  explicit Usage(const fs::path& root) {
    std::ifstream statm(root / "proc/self/statm");
    double pages[6] = {};
    for (double& one : pages) statm >> one;
    mapped = pages[0] * page(), resident = pages[1] * page(), data = pages[5] * page();
  }
};

AvailableMemory of_machine(const fs::path& root, const Usage& usage) {
  const fs::path info = root / "proc/meminfo";
  constexpr double kilobyte = 1024;
  double total = kilobyte * number_after(info, "MemTotal:"), available = kilobyte * number_after(info, "MemAvailable:");
  if (total == 0) total = static_cast<double>(sysconf(_SC_PHYS_PAGES)) * page();
  available = available > 0 ? available + usage.resident : total;
  return {available, fmt::format("only {:.3g} GB of the {:.3g} GB of this machine are available", available / 1e9, total / 1e9), "a machine with more memory"};
}

/// Files of one version of control groups.
struct Version {
  const char *folder, *limit, *usage, *inactive, *active;
};
constexpr Version version_2{"sys/fs/cgroup", "memory.max", "memory.current", "inactive_file", "active_file"};
constexpr Version version_1{"sys/fs/cgroup/memory", "memory.limit_in_bytes", "memory.usage_in_bytes", "total_inactive_file", "total_active_file"};

/// Adds the limits of a group and those above it. In a container the path may be that of the host; the groups that can be seen count.
void add_groups(const fs::path& root, const Version& version, const std::string& path, const Usage& usage, std::vector<AvailableMemory>& all) {
  const fs::path top = root / version.folder;
  fs::path group = fs::path(path).relative_path();
  while (true) {
    const fs::path at = group.empty() ? top : top / group;
    if (const auto limit = number_in(at / version.limit)) {
      const fs::path stat = at / "memory.stat";
      const double used = number_in(at / version.usage).value_or(usage.resident) - number_after(stat, version.inactive) - number_after(stat, version.active);
      const double bytes = std::min(*limit, *limit - used + usage.resident);
      all.push_back({bytes,
                     fmt::format("the control group of this process allows {:.3g} GB ({}), of which {:.3g} GB are available", *limit / 1e9,
                                 (at / version.limit).string(), std::max(bytes, 0.0) / 1e9),
                     "a higher limit"});
    }
    if (group.empty()) return;
    group = group.parent_path();
  }
}

void add_control_groups(const fs::path& root, const Usage& usage, std::vector<AvailableMemory>& all) {
  std::ifstream file(root / "proc/self/cgroup");
  for (std::string line; std::getline(file, line);) {  // number:controllers:path
    const std::size_t colon = line.find(':'), next = colon == std::string::npos ? colon : line.find(':', colon + 1);
    if (next == std::string::npos) continue;
    const std::string controllers = "," + line.substr(colon + 1, next - colon - 1) + ",", path = line.substr(next + 1);
    if (controllers == ",,")
      add_groups(root, version_2, path, usage, all);
    else if (controllers.find(",memory,") != std::string::npos)
      add_groups(root, version_1, path, usage, all);
  }
}

std::optional<double> limit_of(decltype(RLIMIT_AS) resource) {
  rlimit limit{};
  if (getrlimit(resource, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return {};
  return static_cast<double>(limit.rlim_cur);
}

/// The stacks and heaps of the threads count as mapped memory: they exist from the first parallel loop on.
void start_threads() {
  fccda::parallel_for(fccda::thread_count(), [](std::ptrdiff_t) {
    const std::vector<char> heap(64);
    [[maybe_unused]] volatile char read = heap[0];
  });
}

void add_limits(const fs::path& root, std::vector<AvailableMemory>& all) {
  const auto mapped = limit_of(RLIMIT_AS), data = limit_of(RLIMIT_DATA);
  if (!mapped && !data) return;
  start_threads();
  const Usage now(root);
  const auto add = [&](double limit, double used, const char* option) {
    const double bytes = limit - used + now.resident;
    all.push_back({bytes,
                   fmt::format("ulimit {} allows {:.3g} GB, of which libraries and threads leave {:.3g} GB", option, limit / 1e9, std::max(bytes, 0.0) / 1e9),
                   "a higher limit"});
  };
  if (mapped) add(*mapped, now.mapped, "-v");
  if (data) add(*data, now.data, "-d");
}

}  // namespace

AvailableMemory available_memory(const fs::path& root) {
  const Usage usage(root);
  std::vector<AvailableMemory> all = {of_machine(root, usage)};
  add_control_groups(root, usage, all);
  add_limits(root, all);
  return *std::min_element(all.begin(), all.end(), [](const AvailableMemory& a, const AvailableMemory& b) { return a.bytes < b.bytes; });
}

}  // namespace perimpact
