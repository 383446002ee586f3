// Shows on one line of a terminal how far a request is. Used from one thread.
#pragma once

#include <chrono>
#include <cstddef>

#include "client/engine/planner.h"

namespace accord {

class ProgressLine {
 public:
  // Shows nothing unless standard error is a terminal.
  explicit ProgressLine(std::size_t robots);
  ~ProgressLine();  // clears the line
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  bool visible() const { return visible_; }
  void show(const Progress& progress);

 private:
  bool visible_;
  std::size_t robots_;
  std::chrono::steady_clock::time_point begin_;
};

}  // namespace accord
