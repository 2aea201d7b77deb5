#include "perimpact/simulation/available_memory.hpp"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "fixtures/temporary_folder.hpp"
#include "fixtures/tolerance.hpp"

using namespace perimpact;

namespace fs = std::filesystem;

namespace {

/// A file system in which the machine has 64 GB, of which 40 GB are available, and the process has 1e8 bytes resident (in pages of this machine).
struct Machine {
  fixtures::TemporaryFolder folder;

  Machine() {
    write("proc/meminfo", "MemTotal: 62500000 kB\nMemFree: 1 kB\nMemAvailable: 39062500 kB\n");
    write("proc/self/statm", "0 0 0 0 0 0 0\n");
  }
  void write(const std::string& path, const std::string& text) const {
    fs::create_directories((folder.path() / path).parent_path());
    std::ofstream(folder.path() / path) << text;
  }
  AvailableMemory available() const { return available_memory(folder.path()); }
};

}  // namespace

TEST_CASE("available memory: without limits it is what the machine has available") {
  const AvailableMemory found = Machine().available();
  CHECK(found.bytes == fixtures::relative(40e9, 1e-12));
  CHECK(found.reason == "only 40 GB of the 64 GB of this machine are available");
}

TEST_CASE("available memory: the limit of a control group of version 2 counts, and that of a group above it, less what other processes use") {
  Machine machine;
  machine.write("proc/self/cgroup", "0::/jobs/night\n");
  machine.write("sys/fs/cgroup/jobs/night/memory.max", "max\n");
  machine.write("sys/fs/cgroup/jobs/memory.max", "3000000000\n");
  machine.write("sys/fs/cgroup/jobs/memory.current", "1500000000\n");
  machine.write("sys/fs/cgroup/jobs/memory.stat", "anon 1\ninactive_file 400000000\nactive_file 100000000\n");  // cache, which can be reclaimed
  const AvailableMemory found = machine.available();
  CHECK(found.bytes == fixtures::relative(2e9, 1e-12));
  CHECK(found.reason == "the control group of this process allows 3 GB (" + (machine.folder.path() / "sys/fs/cgroup/jobs/memory.max").string() +
                            "), of which 2 GB are available");
  machine.write("sys/fs/cgroup/jobs/night/memory.max", "300000000\n");
  CHECK(machine.available().bytes == fixtures::relative(3e8, 1e-12));
}

TEST_CASE("available memory: the limit of a control group of version 1 counts, also where only the top group is visible in a container") {
  Machine machine;
  machine.write("proc/self/cgroup", "9:name=systemd:/\n4:cpu,memory:/docker/1a2b\n0::/\n");
  machine.write("sys/fs/cgroup/memory/memory.limit_in_bytes", "300000000\n");
  machine.write("sys/fs/cgroup/memory/memory.usage_in_bytes", "50000000\n");
  CHECK(machine.available().bytes == fixtures::relative(2.5e8, 1e-12));
  machine.write("sys/fs/cgroup/memory/memory.limit_in_bytes", "9223372036854771712\n");  // none
  CHECK(machine.available().bytes == fixtures::relative(40e9, 1e-12));
}

TEST_CASE("available memory: this machine has some") { CHECK(available_memory().bytes > 1e8); }
