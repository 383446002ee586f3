// Shows how far a request is, on one line of a terminal. Used from one thread.
#pragma once

#include <chrono>
#include <cstddef>
#include <iosfwd>
#include <string>

#include "client/engine/planner.h"
#include "common/model/request_state.h"

namespace accord {

bool stderr_is_a_terminal();

// In a few words, such as
// "43 %, conflicts: 12 found, 3 resolutions, round 2, sum of costs 81.4 s".
std::string in_words(const RequestState& state);

class ProgressLine {
 public:
  // Requires: `terminal` understands ANSI's "erase to the end of the line", and outlives this.
  ProgressLine(std::ostream& terminal, std::size_t robots);
  ~ProgressLine();  // clears the line; writes nothing where nothing was shown
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void show(const Progress& progress);
  void show(const RequestState& state);

 private:
  void show(const std::string& words);

  std::ostream& terminal_;
  std::size_t robots_;
  bool shown_ = false;
  double per_cent_ = 0;  // never falls
  std::chrono::steady_clock::time_point begin_;
};

}  // namespace accord
