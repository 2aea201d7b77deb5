/// Signals before the first step, when nothing of the run is written: they end the program at once, with a sentence and without the lock of the
/// results folder. Set-up cannot be resumed, so that there is nothing to wait for.
///
/// SIGINT, SIGTERM, SIGHUP and SIGXCPU; those that are ignored (nohup) or have a handler of the program (Python) are left to it.
#pragma once

#include <string>

#include "run/run_folder.hpp"

namespace perimpact {

class SetupSignals {
 public:
  /// `sentence` is printed to standard output as it is; nothing if empty. At most one object at a time, while there is no StopSignals.
  explicit SetupSignals(const std::string& sentence, const RunFolder* folder = nullptr);
  ~SetupSignals();  ///< restores the former actions
  SetupSignals(const SetupSignals&) = delete;
  SetupSignals& operator=(const SetupSignals&) = delete;
};

}  // namespace perimpact
