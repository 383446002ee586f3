#include "coordinator/service/mailbox.h"

#include <chrono>
#include <utility>

namespace accord {
namespace {

// How soon a request that waits for tasks notices that it is to stop.
constexpr auto kStopPoll = std::chrono::milliseconds(10);

}  // namespace

class Mailbox::Port final : public TaskPort {
 public:
  Port(Mailbox& mailbox, RequestId request, std::shared_ptr<Inbox> inbox)
      : mailbox_(mailbox),
        request_(request),
        inbox_(std::move(inbox)),
        next_id_((request << 32U) + 1) {}
  ~Port() override {
    {
      const std::lock_guard lock(mailbox_.mutex_);
      mailbox_.inboxes_.erase(request_);
    }
    mailbox_.ask([request = request_](TaskBoard& board) { board.end(request); });
  }

  void open(RequestWork work) override {
    work.request = request_;
    mailbox_.ask(
        [work = std::move(work)](TaskBoard& board) mutable { board.add(std::move(work), {}); });
  }
  TaskId next_id() override { return next_id_++; }
  void add(std::vector<NewTask> tasks) override {
    mailbox_.ask([request = request_, tasks = std::move(tasks)](TaskBoard& board) mutable {
      board.add(request, std::move(tasks));
    });
  }
  void cancel(const std::vector<TaskId>& tasks) override {
    mailbox_.ask([tasks](TaskBoard& board) { board.cancel(tasks); });
  }
  void hurry(const std::vector<TaskId>& tasks) override {
    mailbox_.ask([tasks](TaskBoard& board) { board.hurry(tasks); });
  }
  std::size_t threads() const override { return mailbox_.threads_; }
  std::optional<FinishedTask> wait(const std::atomic<bool>& stop) override {
    std::unique_lock lock(mailbox_.mutex_);
    while (inbox_->tasks.empty()) {
      if (stop) return std::nullopt;
      inbox_->has_mail.wait_for(lock, kStopPoll);
    }
    FinishedTask task = std::move(inbox_->tasks.front());
    inbox_->tasks.pop_front();
    return task;
  }
  void accept(TaskId task) override {
    mailbox_.ask([task](TaskBoard& board) { board.accept(task); });
  }
  void reject(const FinishedTask& finished, const std::string& why) override {
    mailbox_.ask([finished, why](TaskBoard& board) { board.reject(finished, why); });
  }

 private:
  Mailbox& mailbox_;
  RequestId request_;
  std::shared_ptr<Inbox> inbox_;
  TaskId next_id_;
};

std::unique_ptr<TaskPort> Mailbox::open_port(RequestId request) {
  auto inbox = std::make_shared<Inbox>();
  {
    const std::lock_guard lock(mutex_);
    inboxes_[request] = inbox;
  }
  return std::make_unique<Port>(*this, request, std::move(inbox));
}

void Mailbox::ask(Ask what) {
  {
    const std::lock_guard lock(mutex_);
    asked_.push_back(std::move(what));
  }
  wake_();
}

void Mailbox::serve(TaskBoard& board) {
  std::vector<Ask> asked;
  {
    const std::lock_guard lock(mutex_);
    asked.swap(asked_);
  }
  for (Ask& what : asked) what(board);
  threads_ = board.threads();
}

void Mailbox::deliver(FinishedTask task) {
  const std::lock_guard lock(mutex_);
  const auto found = inboxes_.find(task.request);
  if (found == inboxes_.end()) return;
  found->second->tasks.push_back(std::move(task));
  found->second->has_mail.notify_one();
}

}  // namespace accord
