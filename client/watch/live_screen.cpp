#include "client/watch/live_screen.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <csignal>

#include <ostream>

#include "client/interrupt.h"

namespace accord {
namespace {

// The other screen, which has no lines to scroll back to; no cursor; no wrapping of lines.
constexpr const char* kEnter = "\033[?1049h\033[?25l\033[?7l";
constexpr const char* kLeave = "\033[?7h\033[?25h\033[?1049l";
constexpr const char* kHome = "\033[H";
constexpr const char* kClearLine = "\033[K";
constexpr const char* kClearBelow = "\033[J";

// Raised by the signal that continues a program that was stopped (Ctrl-Z): the shell has had the
// terminal meanwhile.
std::atomic<bool> continued = false;

extern "C" void on_stop(int) {
  [[maybe_unused]] const ssize_t written =
      write(STDOUT_FILENO, kLeave, std::char_traits<char>::length(kLeave));
  raise(SIGSTOP);
}
extern "C" void on_continue(int) {
  continued = true;
}

void handle(int signal, void (*handler)(int)) {
  struct sigaction action = {};
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART;
  sigaction(signal, &action, nullptr);
}

}  // namespace

bool stdout_is_a_terminal() {
  return isatty(STDOUT_FILENO) != 0;
}

ScreenSize stdout_size() {
  winsize size = {};
  if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0 || size.ws_row == 0)
    return {};
  return {size.ws_col, size.ws_row};
}

LiveScreen::LiveScreen(std::ostream& terminal) : terminal_(terminal) {
  write_when_ended(kLeave);
  handle(SIGTSTP, on_stop);
  handle(SIGCONT, on_continue);
  terminal_ << kEnter << std::flush;
}

LiveScreen::~LiveScreen() {
  terminal_ << kLeave;
  for (const std::string& line : last_) terminal_ << line << "\n";
  terminal_ << std::flush;
  write_when_ended(nullptr);
  handle(SIGTSTP, SIG_DFL);
  handle(SIGCONT, SIG_DFL);
}

void LiveScreen::draw(const std::vector<std::string>& lines) {
  draw_for_now(lines);
  last_ = lines;
}

// One write, and nothing is cleared before it is drawn over: it does not flicker.
void LiveScreen::draw_for_now(const std::vector<std::string>& lines) {
  std::string out = continued.exchange(false) ? kEnter : "";
  out += kHome;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (i > 0) out += "\r\n";
    out += lines[i] + kClearLine;
  }
  out += kClearBelow;
  terminal_ << out << std::flush;
}

}  // namespace accord
