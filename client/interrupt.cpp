#include "client/interrupt.h"

#include <unistd.h>

#include <array>
#include <cstring>
#include <string_view>

#include "client/exit_code.h"

namespace accord {
namespace {

constexpr std::array kSignals{SIGINT, SIGTERM, SIGHUP};

// Lock-free, so a signal handler may use them.
std::atomic<bool> someone_looks = false;
std::atomic<bool> raised = false;
std::atomic<bool> on_terminal = false;  // whose line may hold progress or an echoed ^C
std::atomic<const char*> last_words = nullptr;
static_assert(std::atomic<bool>::is_always_lock_free);
static_assert(std::atomic<const char*>::is_always_lock_free);

std::string_view message_of(int signal) {
  switch (signal) {
    case SIGINT:
      return "\ncancelled: ended by SIGINT\n";
    case SIGTERM:
      return "\ncancelled: ended by SIGTERM\n";
    default:
      return "\ncancelled: ended by SIGHUP\n";
  }
}

// Only what POSIX allows in a signal handler: no streams, no destructors.
extern "C" void on_signal(int signal) {
  if (someone_looks && !raised.exchange(true)) return;
  if (const char* text = last_words; text != nullptr) {
    [[maybe_unused]] const ssize_t put_right = write(STDOUT_FILENO, text, strlen(text));
  }
  std::string_view message = message_of(signal);
  if (!on_terminal) message.remove_prefix(1);
  // Where standard error is gone as well, nothing is left to tell.
  [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, message.data(), message.size());
  _exit(static_cast<int>(ExitCode::kTimeout));
}

bool is_ignored(int signal) {
  struct sigaction now = {};
  sigaction(signal, nullptr, &now);
  return now.sa_handler == SIG_IGN;
}

}  // namespace

void end_on_signals() {
  on_terminal = isatty(STDERR_FILENO) != 0;
  struct sigaction action = {};
  action.sa_handler = on_signal;
  action.sa_flags = SA_RESTART;  // or a write that a signal interrupts would count as failed
  for (const int signal : kSignals) {
    // nohup means it. Of the others, shells make jobs in the background ignore SIGINT, where it
    // can only come from somebody who wants this program to end.
    if (signal == SIGHUP && is_ignored(signal)) continue;
    sigaction(signal, &action, nullptr);
  }
}

void write_when_ended(const char* text) {
  last_words = text;
}

CancelOnSignal::CancelOnSignal() {
  raised = false;
  someone_looks = true;
}

CancelOnSignal::~CancelOnSignal() {
  someone_looks = false;
}

const std::atomic<bool>& CancelOnSignal::cancelled() const {
  return raised;
}

bool cancelled_by_signal() {
  return raised;
}

HeldSignals::HeldSignals() {
  sigset_t held;
  sigemptyset(&held);
  for (const int signal : kSignals) sigaddset(&held, signal);
  pthread_sigmask(SIG_BLOCK, &held, &before_);
}

HeldSignals::~HeldSignals() {
  pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

}  // namespace accord
