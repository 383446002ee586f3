#include "coordinator/service/status_board.h"

#include <utility>

#include <unistd.h>

namespace accord {
namespace {

constexpr auto kLook = std::chrono::milliseconds(100);
constexpr auto kAgain = std::chrono::seconds(2);

std::string standing_of(const WorkerRecord& worker) {
  switch (worker.standing) {
    case WorkerRecord::Standing::kWelcome:
      return "welcome";
    case WorkerRecord::Standing::kLeaving:
      return "leaving";
    case WorkerRecord::Standing::kRefused:
      return "refused";
    case WorkerRecord::Standing::kDistrusted:
      return "distrusted";
  }
  return "";
}

WorkerStatus status_of(EndpointId id, const WorkerRecord& worker) {
  return {id.value,
          worker.info.host,
          worker.info.process,
          worker.info.version,
          worker.info.threads,
          static_cast<std::uint32_t>(worker.tasks.size()),
          standing_of(worker),
          worker.why};
}

}  // namespace

StatusBoard::StatusBoard(std::string version, std::string host) {
  service_.version = std::move(version);
  service_.host = std::move(host);
  service_.process = static_cast<std::uint32_t>(getpid());
}

bool StatusBoard::update(const TaskBoard& board, const RequestDesk& desk,
                         std::chrono::nanoseconds now) {
  if (looked_ && now - *looked_ < kLook) return false;
  looked_ = now;
  const bool again = !told_ || now - *told_ >= kAgain;
  if (again) told_ = now;
  tell_workers(board, again);
  tell_service(board, desk, now, again);
  return true;
}

void StatusBoard::tell_workers(const TaskBoard& board, bool again) {
  for (auto known = workers_.begin(); known != workers_.end();) {
    if (board.workers().contains(known->first)) {
      ++known;
      continue;
    }
    known->second.standing = "lost";
    known->second.busy = 0;
    news_.emplace_back(std::move(known->second));
    known = workers_.erase(known);
  }
  for (const auto& [id, worker] : board.workers()) {
    WorkerStatus status = status_of(id, worker);
    WorkerStatus& known = workers_[id];
    if (!again && status == known) continue;
    known = status;
    news_.emplace_back(std::move(status));
  }
}

void StatusBoard::tell_service(const TaskBoard& board, const RequestDesk& desk,
                               std::chrono::nanoseconds now, bool again) {
  ServiceStatus status = service_;
  status.workers = 0;
  status.threads = 0;
  for (const auto& [id, worker] : board.workers()) {
    if (worker.standing != WorkerRecord::Standing::kWelcome) continue;
    ++status.workers;
    status.threads += worker.info.threads;
  }
  status.queued = static_cast<std::uint32_t>(desk.queued());
  status.planning = static_cast<std::uint32_t>(desk.planning());
  status.finished = 0;
  for (const auto& [how, count] : desk.counters().finished) status.finished += count;
  status.accepting = !desk.is_draining();
  if (!again && status == service_) return;
  service_ = status;
  service_.uptime = status.uptime;
  status.uptime = std::chrono::duration<double>(now).count();
  news_.emplace_back(std::move(status));
}

std::optional<FleetNews> StatusBoard::next() {
  if (news_.empty()) return std::nullopt;
  FleetNews news = std::move(news_.front());
  news_.pop_front();
  return news;
}

}  // namespace accord
