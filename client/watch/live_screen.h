// A terminal's whole screen, drawn again and again in its place; what was on it before comes back.
// Used from one thread; one at a time.
#pragma once

#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

#include "client/watch/screen.h"

namespace accord {

bool stdout_is_a_terminal();
// The size of the terminal that standard output is; any width and height where it is none.
ScreenSize stdout_size();

class LiveScreen {
 public:
  // Requires: `terminal` is standard output, understands ANSI's and xterm's sequences, and outlives
  // this.
  explicit LiveScreen(std::ostream& terminal);
  // Puts the terminal right, and leaves the lines drawn last on it. Whoever is ended by a signal
  // (interrupt.h) puts it right, too.
  ~LiveScreen();
  LiveScreen(const LiveScreen&) = delete;
  LiveScreen& operator=(const LiveScreen&) = delete;

  // Requires: no line is wider than the terminal, and there are no more than it has.
  void draw(const std::vector<std::string>& lines);
  // As draw(), but nothing stays of it in the end.
  void draw_for_now(const std::vector<std::string>& lines);

 private:
  std::ostream& terminal_;
  std::vector<std::string> last_;
};

}  // namespace accord
