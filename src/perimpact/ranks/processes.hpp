/// Ranks that are processes, and how a program opens the library that connects them.
///
/// libperimpact_ranks.so (src/ranks_mpi) is opened at run time and only for a run of several processes, so that a program without MPI needs none.
#pragma once

#include "perimpact/ranks/ranks.hpp"

namespace perimpact {

/// Destroyed on all ranks together, at the end of a run that has not failed.
class Processes : public Ranks {
 public:
  /// True once all ranks have called this; false if that takes longer than `seconds`. Call it once.
  virtual bool all_arrive(double seconds) = 0;
  /// Ends the processes of all ranks at once, with this exit code.
  [[noreturn]] virtual void end_all(int exit_code) noexcept = 0;

  void abort() noexcept override { end_all(3); }
};

/// Version of Processes and of its base: of the program and the library, which must agree.
constexpr int processes_version = 2;

/// The function by which the library connects the processes that were started together. Returns a new object, or nullptr if the library has another
/// version. To be called once, by the thread that will make all calls.
using OpenProcesses = Processes*(int version);
constexpr const char* open_processes_name = "perimpact_open_processes";

}  // namespace perimpact
