#include "run/launch.hpp"

#include <dlfcn.h>
#include <fmt/format.h>
#include <sched.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "perimpact/ranks/counting_ranks.hpp"
#include "perimpact/ranks/processes.hpp"
#include "run/plugin.hpp"

namespace perimpact {

namespace fs = std::filesystem;

namespace {

constexpr const char* library_name = "libperimpact_ranks.so";
constexpr double time_of_root = 2;  // [s] for the root to report the error of all

std::unique_ptr<Processes> processes;
std::optional<CountingRanks> counting;  // of these

std::optional<int> number_in_environment(const char* name) {
  const char* const text = std::getenv(name);
  int number = 0;
  if (!text || std::from_chars(text, text + std::strlen(text), number).ec != std::errc{}) return std::nullopt;
  return number;
}

struct Launched {
  int rank = 0, size = 1;
};

/// What the launcher says. A batch job has the variables of Slurm also without srun; PMIX_RANK shows that a launcher has started this process.
Launched launched() {
  constexpr std::array<std::array<const char*, 2>, 2> names{{{"OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE"}, {"PMI_RANK", "PMI_SIZE"}}};
  for (const auto& [rank_name, size_name] : names) {
    const std::optional<int> rank = number_in_environment(rank_name), size = number_in_environment(size_name);
    if (rank && size) return {*rank, *size};
  }
  const std::optional<int> rank = number_in_environment("PMIX_RANK"), size = number_in_environment("SLURM_STEP_NUM_TASKS");
  return rank && size ? Launched{*rank, *size} : Launched{};
}

std::unique_ptr<Processes> connect(int size) {
  const fs::path file = plugin_file(library_name, "PERIMPACT_RANKS_LIBRARY");
  if (file.empty())
    throw fccda::InputError(
        fmt::format("a run of {} processes needs {}, which is not installed; install the package perimpact-mpi, or libopenmpi-dev and openmpi-bin before a "
                    "build from source. Without mpirun a run has one process.",
                    size, library_name));
  void* const library = ::dlopen(file.c_str(), RTLD_NOW | RTLD_GLOBAL);  // global: for the components that MPI opens itself
  if (!library)
    throw fccda::InputError(
        fmt::format("a run of {} processes needs {}, which cannot be opened ({}); install the package openmpi-bin.", size, library_name, ::dlerror()));
  const auto open = reinterpret_cast<OpenProcesses*>(::dlsym(library, open_processes_name));
  std::unique_ptr<Processes> connected(open ? open(processes_version) : nullptr);
  if (!connected)
    throw fccda::InputError(fmt::format("{} is not of the version of this program; install perimpact and perimpact-mpi together.", file.string()));
  return connected;
}

}  // namespace

Ranks& launched_ranks(int expected) {
  if (processes) return *counting;
  const int size = expected > 0 ? expected : launched().size;
  if (size == 1) return alone();
  processes = connect(size);
  counting.emplace(*processes);
  if (processes->size() == size) return *counting;
  const int connected = processes->size();
  close_ranks();
  throw fccda::InputError(
      expected > 0 ? fmt::format("--ranks {}: the number of processes started together is {}; use mpirun -n {} perimpact run …", expected, connected, expected)
                   : fmt::format("of the {} processes that were started together, MPI connects {}; start them with the mpirun of Open MPI.", size, connected));
}

int threads_of_rank(Ranks& ranks) {
  struct Place {
    std::array<char, 256> host{};
    cpu_set_t processors{};
  } own;
  ::gethostname(own.host.data(), own.host.size() - 1);
  ::sched_getaffinity(0, sizeof own.processors, &own.processors);
  cpu_set_t all{};
  int here = 0;
  for (const Place& place : ranks.join_all(std::span<const Place>(&own, 1)))
    if (place.host == own.host) {
      CPU_OR(&all, &all, &place.processors);
      ++here;
    }
  if (std::getenv("OMP_NUM_THREADS")) return 0;
  return std::clamp(CPU_COUNT(&all) / here, 1, std::max(1, CPU_COUNT(&own.processors)));
}

void close_ranks() {
  counting.reset();
  processes.reset();
}

void end_failed(int exit_code, const std::function<void()>& print) {
  const bool is_root = processes ? processes->is_root() : launched().rank == 0;
  if (is_root) print();
  if (processes) {
    if (processes->all_arrive(time_of_root)) return close_ranks();
    if (!is_root) print();
    processes->end_all(exit_code);
  }
  if (is_root) return;
  std::this_thread::sleep_for(std::chrono::duration<double>(time_of_root));  // the launcher ends this process once the root has ended
  print();
}

}  // namespace perimpact
