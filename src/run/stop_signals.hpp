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
  /// What becomes of SIGINT: recorded; recorded, and the second ends the program; or left as it is.
  enum class Interrupts { recorded, second_ends_program, left };
  /// Objects may exist at the same time, the later ones destroyed first.
  explicit StopSignals(Interrupts interrupts);
  ~StopSignals();  ///< the last one of a signal restores its former action
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;

  static int pending();           ///< the first signal to end, or 0
  static int take();              ///< the same; the record is cleared
  static bool save_is_pending();  ///< SIGUSR1
  static bool take_save_request();

 private:
  bool concerns(int signal) const;
  Interrupts interrupts_;
};

}  // namespace perimpact
