// A port of a thread that owns bus and board itself: it runs their loop while it waits. For tests,
// simulations and measurements, which plan one request at a time.
#pragma once

#include <functional>
#include <optional>

#include "common/transport/bus.h"
#include "coordinator/dispatch/task_board.h"
#include "coordinator/dispatch/task_port.h"

namespace accord {

class DirectPort final : public TaskPort {
 public:
  // One turn of the loop: moves time on, lets others work; returns what the time is then.
  // For a real bus: waits for an event, but not past the deadline, which may be over.
  using Turn = std::function<TaskBoard::Time(Bus& bus, std::optional<TaskBoard::Time> deadline)>;

  // Bus and board must outlive this.
  DirectPort(Bus& bus, TaskBoard& board, RequestId request, Turn turn);
  ~DirectPort() override;
  DirectPort(const DirectPort&) = delete;
  DirectPort& operator=(const DirectPort&) = delete;

  void open(RequestWork work) override;
  TaskId next_id() override { return next_id_++; }
  void add(std::vector<NewTask> tasks) override { board_.add(request_, std::move(tasks)); }
  void cancel(const std::vector<TaskId>& tasks) override { board_.cancel(tasks); }
  void hurry(const std::vector<TaskId>& tasks) override { board_.hurry(tasks); }
  std::size_t threads() const override { return board_.threads(); }
  std::optional<FinishedTask> wait(const std::atomic<bool>& stop) override;
  void accept(TaskId task) override { board_.accept(task); }
  void reject(const FinishedTask& finished, const std::string& why) override {
    board_.reject(finished, why);
  }

  // One turn of the loop, for who waits for something else than a task.
  void turn();

 private:
  void exchange();

  Bus& bus_;
  TaskBoard& board_;
  RequestId request_;
  Turn pass_;
  std::optional<TaskBoard::Time> now_;  // nullopt: nobody has asked yet
  TaskId next_id_;
};

}  // namespace accord
