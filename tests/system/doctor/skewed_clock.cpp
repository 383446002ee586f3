// Preloaded (LD_PRELOAD), it puts a process's clock ahead by CLOCK_AHEAD seconds: the time of day,
// not the time that passes.
#include <sys/syscall.h>
#include <unistd.h>

#include <cstdlib>
#include <ctime>

extern "C" int clock_gettime(clockid_t clock, timespec* out) noexcept {
  const long code = syscall(SYS_clock_gettime, clock, out);
  const char* ahead = std::getenv("CLOCK_AHEAD");
  if (code == 0 && clock == CLOCK_REALTIME && ahead != nullptr) out->tv_sec += std::atol(ahead);
  return static_cast<int>(code);
}
