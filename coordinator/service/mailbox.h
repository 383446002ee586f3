// Between the threads that plan and the loop that owns the task board: what ports ask of the board
// one way, finished tasks the other.
//
// Thread safety: ports belong to one thread each; serve() and deliver() are for the
// loop. The mailbox outlives its ports.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "coordinator/dispatch/task_board.h"
#include "coordinator/dispatch/task_port.h"

namespace accord {

class Mailbox {
 public:
  // `wake` rouses the loop: something is to be taken. Called from any thread.
  explicit Mailbox(std::function<void()> wake) : wake_(std::move(wake)) {}
  Mailbox(const Mailbox&) = delete;
  Mailbox& operator=(const Mailbox&) = delete;

  // A port for a request that has none yet.
  std::unique_ptr<TaskPort> open_port(RequestId request);

  // Carries out on the board all that ports have asked for since.
  void serve(TaskBoard& board);
  // Hands a finished task to its request's port; dropped where that is gone.
  void deliver(FinishedTask task);

 private:
  class Port;
  struct Inbox {
    std::condition_variable has_mail;
    std::deque<FinishedTask> tasks;
  };
  using Ask = std::function<void(TaskBoard&)>;

  void ask(Ask what);

  std::function<void()> wake_;
  std::mutex mutex_;
  std::vector<Ask> asked_;
  std::atomic<std::size_t> threads_{0};  // of workers, when the board was served last
  std::map<RequestId, std::shared_ptr<Inbox>> inboxes_;
};

}  // namespace accord
