#include "coordinator/dispatch/direct_port.h"

#include <utility>

namespace accord {

DirectPort::DirectPort(Bus& bus, TaskBoard& board, RequestId request, Turn turn)
    : bus_(bus),
      board_(board),
      request_(request),
      pass_(std::move(turn)),
      next_id_((request << 32U) + 1) {}

DirectPort::~DirectPort() {
  board_.end(request_);
}

void DirectPort::open(RequestWork work) {
  work.request = request_;
  board_.add(std::move(work), {});
}

std::optional<FinishedTask> DirectPort::wait(const std::atomic<bool>& stop) {
  while (!stop) {
    if (auto finished = board_.take_finished()) return finished;
    turn();
  }
  return std::nullopt;
}

void DirectPort::turn() {
  // The board's clock has run on since the last request's port.
  const TaskBoard::Time now = now_ ? *now_ : pass_(bus_, TaskBoard::Time(0));
  while (const auto event = bus_.take()) board_.on_event(*event, now);
  board_.on_time(now);
  while (const auto out = board_.next_outgoing(now)) {
    board_.on_published(out->to, bus_.publish(out->to, out->message), now);
  }
  now_ = pass_(bus_, board_.next_deadline());
}

}  // namespace accord
