// Threads that solve jobs and make scenes ready, beside the loop that owns the desk.
// start(), make_ready() and take() are for that one loop.
#pragma once

#include <atomic>
#include <condition_variable>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <variant>
#include <vector>

#include "worker/service/scene_shelf.h"
#include "worker/service/task_desk.h"

namespace accord {

class JobThreads {
 public:
  struct Ended {
    TaskDesk::Job job;
    ResultItem result;
    std::vector<TriedLevel> levels;
  };
  struct SceneOutcome {
    SceneHash scene;
    std::string why_not;  // empty: it is ready
  };
  using Outcome = std::variant<Ended, SceneOutcome>;

  // `wake` is called, from any thread, when there is an outcome. Requires: threads > 0.
  JobThreads(SceneShelf& shelf, unsigned threads, std::function<void()> wake);
  // Stops what runs and waits for it.
  ~JobThreads();
  JobThreads(const JobThreads&) = delete;
  JobThreads& operator=(const JobThreads&) = delete;

  void start(TaskDesk::Job job);
  void make_ready(TaskDesk::Scene scene);
  // A job that runs, or waits to, ends soon; with whatever result.
  void stop(const TaskKey& key);
  std::optional<Outcome> take();

 private:
  struct Running {
    TaskDesk::Job job;
    std::shared_ptr<std::atomic<bool>> stop;
  };
  using Work = std::variant<Running, TaskDesk::Scene>;

  void serve();
  Outcome carry_out(Work& work);

  SceneShelf& shelf_;
  std::function<void()> wake_;
  std::mutex mutex_;
  std::condition_variable has_work_;
  bool quit_ = false;
  std::deque<Work> work_;
  std::deque<Outcome> outcomes_;
  std::map<TaskKey, std::shared_ptr<std::atomic<bool>>> stops_;  // of jobs that have not ended
  std::vector<std::thread> threads_;
};

}  // namespace accord
