// Signals that ask the program to end: SIGINT (Ctrl-C), SIGTERM and SIGHUP (the terminal is gone).
#pragma once

#include <csignal>

#include <atomic>

namespace accord {

// From now on such a signal ends the program at once, with a line on standard error and exit code
// ExitCode::kTimeout. A SIGHUP that is ignored (nohup) stays so. Call once, first thing in main().
void end_on_signals();

// What such a signal writes to standard output before it ends the program: what puts a terminal
// right. nullptr: nothing. Requires: a text that lives as long as the program.
void write_when_ended(const char* text);

// While one lives, the first signal only raises a flag, for a request that looks at it; another one
// ends the program. One at a time.
class CancelOnSignal {
 public:
  CancelOnSignal();
  ~CancelOnSignal();
  CancelOnSignal(const CancelOnSignal&) = delete;
  CancelOnSignal& operator=(const CancelOnSignal&) = delete;

  const std::atomic<bool>& cancelled() const;
};

// Whether a signal raised the flag, heeded or not.
bool cancelled_by_signal();

// While one lives, signals to this thread wait: for what must not be left half done.
class HeldSignals {
 public:
  HeldSignals();
  ~HeldSignals();
  HeldSignals(const HeldSignals&) = delete;
  HeldSignals& operator=(const HeldSignals&) = delete;

 private:
  sigset_t before_;
};

}  // namespace accord
