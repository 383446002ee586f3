// What the service tells of itself and of its workers: at once where it has changed, and again from
// time to time for whoever comes late.
// Not thread safe.
#pragma once

#include <chrono>
#include <deque>
#include <map>
#include <optional>
#include <string>

#include "common/transport/fleet/fleet_messages.h"
#include "coordinator/dispatch/task_board.h"
#include "coordinator/service/request_desk.h"

namespace accord {

class StatusBoard {
 public:
  StatusBoard(std::string version, std::string host);

  // `now` as the board's and the desk's. Looks at most ten times a second; whether it has now.
  bool update(const TaskBoard& board, const RequestDesk& desk, std::chrono::nanoseconds now);
  std::optional<FleetNews> next();
  const ServiceStatus& service() const { return service_; }

 private:
  void tell_workers(const TaskBoard& board, bool again);
  void tell_service(const TaskBoard& board, const RequestDesk& desk, std::chrono::nanoseconds now,
                    bool again);

  ServiceStatus service_;
  std::map<EndpointId, WorkerStatus> workers_;
  std::optional<std::chrono::nanoseconds> looked_, told_;
  std::deque<FleetNews> news_;
};

}  // namespace accord
