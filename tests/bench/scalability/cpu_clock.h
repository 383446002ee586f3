// The processor time that this thread has used: what work costs, whatever else the machine does.
#pragma once

#include <ctime>

namespace accord::bench {

// s
inline double cpu_seconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace accord::bench
