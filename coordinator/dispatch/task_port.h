// One request's way to the task board, wherever that is: at hand (DirectPort), or owned by the
// service's loop on another thread.
#pragma once

#include <atomic>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "coordinator/dispatch/task.h"

namespace accord {

// Not thread safe: one thread, that of the request, calls. Destruction ends the request on the
// board: its tasks are dropped.
class TaskPort {
 public:
  virtual ~TaskPort() = default;

  // What the tasks have in common; `work.request` is the port's own business. Call once, first.
  virtual void open(RequestWork work) = 0;
  // A name for a task that no other task has, of this request or another.
  virtual TaskId next_id() = 0;
  virtual void add(std::vector<NewTask> tasks) = 0;
  // As TaskBoard's. A task that was cancelled may still come out of wait() if it had finished.
  virtual void cancel(const std::vector<TaskId>& tasks) = 0;
  virtual void hurry(const std::vector<TaskId>& tasks) = 0;
  // How many tasks can be worked on at once, at present: a guide to what is worth adding.
  virtual std::size_t threads() const = 0;
  // The next task that is finished; waits for it. nullopt: `stop` became true.
  virtual std::optional<FinishedTask> wait(const std::atomic<bool>& stop) = 0;
  // As TaskBoard's.
  virtual void accept(TaskId task) = 0;
  virtual void reject(const FinishedTask& finished, const std::string& why) = 0;
};

}  // namespace accord
