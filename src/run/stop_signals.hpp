/// Signals during a run: recorded while an object exists, and acted upon between steps.
///
///   SIGINT, SIGTERM, SIGHUP, SIGXCPU   the run shall end, with a checkpoint
///   SIGUSR1                            a checkpoint shall be written, and the run continue
///
/// Except SIGINT, signals that are ignored (nohup) or have a handler of the program (Python) are left to it.
#pragma once

namespace perimpact {

class StopSignals {
 public:
  enum class SecondInterrupt { recorded, ends_program };
  /// Objects may exist at the same time, created and destroyed one after another.
  explicit StopSignals(SecondInterrupt second);
  ~StopSignals();  ///< the last one restores the former actions
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;

  static int pending();           ///< the first signal to end, or 0
  static int take();              ///< the same; the record is cleared
  static bool save_is_pending();  ///< SIGUSR1
  static bool take_save_request();
};

}  // namespace perimpact
