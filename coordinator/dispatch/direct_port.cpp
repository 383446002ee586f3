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
    exchange();
    // What has come is looked at before anything else is waited for.
    if (auto finished = board_.take_finished()) return finished;
    now_ = pass_(bus_, board_.next_deadline());
  }
  return std::nullopt;
}

void DirectPort::turn() {
  exchange();
  now_ = pass_(bus_, board_.next_deadline());
}

void DirectPort::exchange() {
  // The board's clock has run on since the last request's port.
  if (!now_) now_ = pass_(bus_, TaskBoard::Time(0));
  while (const auto event = bus_.take()) board_.on_event(*event, *now_);
  board_.on_time(*now_);
  while (const auto out = board_.next_outgoing(*now_)) {
    board_.on_published(out->to, bus_.publish(out->to, out->message), *now_);
  }
}

}  // namespace accord
