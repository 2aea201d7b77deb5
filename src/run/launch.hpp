/// Processes of one run that mpirun, srun or another launcher has started together: recognised by the environment, and connected by a library that is
/// opened only for them (perimpact/ranks/processes.hpp).
#pragma once

#include <functional>

#include "perimpact/ranks/ranks.hpp"

namespace perimpact {

/// The ranks of this run; alone() where a launcher has started one process or none. The first call connects the processes. `expected`: their number,
/// whatever the environment says; 0: as the environment says. Throws InputError where the library is not installed or does not connect that many.
Ranks& launched_ranks(int expected);

/// The number of threads with which the ranks of a machine share its processors, of those that the launcher lets each use; 0 where OMP_NUM_THREADS says.
/// Collective.
int threads_of_rank(Ranks& ranks);

/// Ends the run of all ranks, if there are any, without an error.
void close_ranks();

/// The end of a process that has failed. Calls print() if this process is alone or the root; on another rank if the root has not failed too within two
/// seconds. Then all ranks are ended.
void end_failed(int exit_code, const std::function<void()>& print);

}  // namespace perimpact
