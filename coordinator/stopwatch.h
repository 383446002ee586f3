// Wall-clock time since it was made. For statistics only: no decision depends on it.
#pragma once

#include <chrono>

namespace accord {

class Stopwatch {
 public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  }

 private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

}  // namespace accord
