// Which values are shown of requests, workers and the service. A further one is a line here. Pure.
#pragma once

#include "client/watch/row.h"
#include "client/watch/watched_fleet.h"

namespace accord {

Row row_of(const WatchedRequest& request, WatchTime now);
Row row_of(const WatchedWorker& worker);
Row row_of(const WatchedService& service, WatchTime now);

// "request", "worker" or "service", and its row.
struct NamedRow {
  const char* kind;
  Row row;
};
NamedRow row_of(const WatchedFleet::Change& change, WatchTime now);

}  // namespace accord
