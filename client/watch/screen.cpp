#include "client/watch/screen.h"

#include <fmt/format.h>

#include <algorithm>

#include "client/counted.h"
#include "client/watch/rows.h"

namespace accord {
namespace {

using Lines = std::vector<std::string>;

std::string head(const WatchedFleet& fleet, WatchTime now) {
  const auto& service = fleet.service();
  if (!service) return "no service has answered yet";
  if (!service->is_present) {
    const std::chrono::duration<double> gone = now - service->heard;
    return fmt::format("no service for {:.0f} s; what it last said:", gone.count());
  }
  return service->status.accepting ? "" : "the service is about to end, and takes no more requests";
}

// A table of which at most so many lines are shown.
void add(const Lines& table, std::size_t most, const char* what, Lines& out) {
  if (table.empty()) {
    out.push_back(fmt::format("no {}s", what));
  } else if (table.size() <= most) {
    out.insert(out.end(), table.begin(), table.end());
  } else {
    const std::size_t shown = most > 2 ? most - 1 : std::min<std::size_t>(most, 1);
    out.insert(out.end(), table.begin(), table.begin() + static_cast<std::ptrdiff_t>(shown));
    const std::size_t rows = table.size() - std::max<std::size_t>(shown, 1);
    if (most > 1) out.push_back(fmt::format("... and {} more", rows));
  }
}

}  // namespace

std::vector<Row> rows_of_workers(const WatchedFleet& fleet) {
  std::vector<Row> out;
  for (const WatchedWorker* worker : fleet.workers()) {
    if (worker->status.standing != "lost") out.push_back(row_of(*worker));
  }
  return out;
}

std::vector<std::string> screen_of(const WatchedFleet& fleet, WatchTime now, ScreenSize size) {
  Lines out;
  if (std::string line = head(fleet, now); !line.empty()) out.push_back(std::move(line));
  if (!fleet.service()) return out;
  std::vector<Row> requests, workers;
  for (const WatchedRequest* request : fleet.requests(now)) {
    requests.push_back(row_of(*request, now));
  }
  for (const WatchedWorker* worker : fleet.workers()) workers.push_back(row_of(*worker));
  const Lines service_table = in_columns({row_of(*fleet.service(), now)}, size.width);
  const Lines request_table = in_columns(requests, size.width);
  const Lines worker_table = in_columns(workers, size.width);

  out.insert(out.end(), service_table.begin(), service_table.end());
  // Two empty lines are between tables. Each table may have half of what is left, and what the
  // other one does not need.
  const std::size_t taken = out.size() + 2;
  const std::size_t room = size.height > taken ? size.height - taken : 0;
  const std::size_t for_workers =
      std::max(room / 2, room - std::min(room, std::max<std::size_t>(request_table.size(), 1)));
  const std::size_t shown_workers =
      std::min(for_workers, std::max<std::size_t>(worker_table.size(), 1));
  out.emplace_back();
  add(request_table, room - shown_workers, "request", out);
  out.emplace_back();
  add(worker_table, shown_workers, "worker", out);
  for (std::string& line : out) {
    if (line.size() > size.width) line.resize(size.width);
  }
  if (out.size() > size.height) out.resize(size.height);
  return out;
}

}  // namespace accord
