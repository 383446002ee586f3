// A fixed set of threads that carry out numbered jobs. Which thread takes which job is left to
// chance; nothing that comes out may depend on it.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace accord {

class WorkPool {
 public:
  // The calling thread works too: `threads` - 1 more are started, or as many as the system gives.
  // Requires: threads > 0.
  explicit WorkPool(unsigned threads);
  ~WorkPool();
  WorkPool(const WorkPool&) = delete;
  WorkPool& operator=(const WorkPool&) = delete;

  // Calls job(0) to job(count - 1), each once, and returns when all have returned. Jobs throw only
  // where memory runs out: no more are begun then, and the first exception is thrown here when all
  // that had begun have ended. Not reentrant.
  void run(std::size_t count, const std::function<void(std::size_t)>& job);

 private:
  void serve();
  void take_jobs();

  std::mutex mutex_;
  std::condition_variable start_, done_;
  const std::function<void(std::size_t)>* job_ = nullptr;
  std::size_t count_ = 0;
  std::atomic<std::size_t> next_{0};
  std::size_t busy_ = 0;
  std::exception_ptr failure_;
  std::uint64_t generation_ = 0;
  bool quit_ = false;
  std::vector<std::thread> threads_;
};

}  // namespace accord
