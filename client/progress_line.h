// Shows on one line of a terminal how far a request is. Used from one thread.
#pragma once

#include <chrono>
#include <cstddef>
#include <iosfwd>

#include "client/engine/planner.h"

namespace accord {

bool stderr_is_a_terminal();

class ProgressLine {
 public:
  // Requires: `terminal` understands ANSI's "erase to the end of the line", and outlives this.
  ProgressLine(std::ostream& terminal, std::size_t robots);
  ~ProgressLine();  // clears the line; writes nothing where nothing was shown
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void show(const Progress& progress);

 private:
  std::ostream& terminal_;
  std::size_t robots_;
  bool shown_ = false;
  std::chrono::steady_clock::time_point begin_;
};

}  // namespace accord
