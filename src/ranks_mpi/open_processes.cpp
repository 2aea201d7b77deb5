// The one function of the library.
#include "ranks_mpi/mpi_ranks.hpp"

extern "C" __attribute__((visibility("default"))) perimpact::Processes* perimpact_open_processes(int version) {
  return version == perimpact::processes_version ? new perimpact::MpiRanks : nullptr;
}
