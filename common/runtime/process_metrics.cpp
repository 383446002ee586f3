#include "common/runtime/process_metrics.h"

#include <sys/resource.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

namespace accord {
namespace {

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

double cpu_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

double resident_bytes() {
  std::ifstream file("/proc/self/statm");
  double size = 0, resident = 0;  // pages
  file >> size >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE));
}

double open_files() {
  std::error_code error;
  const std::filesystem::directory_iterator files("/proc/self/fd", error);
  return static_cast<double>(std::distance(files, std::filesystem::directory_iterator()));
}

double most_open_files() {
  rlimit limit{};
  getrlimit(RLIMIT_NOFILE, &limit);
  return static_cast<double>(limit.rlim_cur);
}

}  // namespace

void add_process_metrics(Metrics& metrics, const std::string& version) {
  metrics.gauge("accord_build_info", "1, with the program's version", {{"version", version}})
      .set(1);
  // Of this call, which is a process's first.
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  metrics.gauge("process_start_time_seconds", "When the process was started, in s since 1970")
      .set(std::chrono::duration<double>(now).count());
  metrics.gauge("process_max_fds", "Files that the process may have open").set(most_open_files());
  auto cpu = metrics.counter("process_cpu_seconds_total", "Processor time that the process took");
  auto memory = metrics.gauge("process_resident_memory_bytes", "Memory that the process holds");
  auto files = metrics.gauge("process_open_fds", "Files that the process has open");
  metrics.before_collection([cpu, memory, files]() mutable {
    cpu.raise_to(cpu_seconds());
    memory.set(resident_bytes());
    files.set(open_files());
  });
}

}  // namespace accord
