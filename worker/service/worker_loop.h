// A worker process at work: the loop that owns its bus and its books, and the threads that solve.
// Not thread safe, but for drain().
#pragma once

#include <atomic>
#include <chrono>

#include "common/transport/bus.h"
#include "worker/service/job_threads.h"
#include "worker/service/scene_shelf.h"
#include "worker/service/task_desk.h"
#include "worker/service/worker_tally.h"

namespace accord {

class WorkerLoop {
 public:
  // Bus and tally must outlive this. Requires: settings.info.threads > 0.
  WorkerLoop(Bus& bus, const TaskDesk::Settings& settings, WorkerTally& tally);

  enum class End {
    kDrained,    // drain() was called, and what was begun is finished or has taken too long to
    kForgotten,  // the coordinator was lost and none has answered since: join anew
  };
  End run();

  // Hand back what has not begun, finish the rest, and end. From any thread; not from a signal
  // handler.
  void drain();

 private:
  void turn();
  TaskDesk::Time now() const { return std::chrono::steady_clock::now() - began_; }

  Bus& bus_;
  WorkerTally& tally_;
  TaskDesk desk_;
  SceneShelf shelf_;
  JobThreads threads_;
  std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
  std::atomic<bool> drain_{false};
};

}  // namespace accord
