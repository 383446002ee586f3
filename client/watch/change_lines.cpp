#include "client/watch/change_lines.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <chrono>
#include <ostream>

#include "client/watch/rows.h"

namespace accord {

void ChangeLines::write_all(const WatchedFleet& fleet, WatchTime now) {
  if (fleet.service()) write(*fleet.service(), now, "");
  for (const WatchedWorker* worker : fleet.workers()) write(*worker, now, "");
  for (const WatchedRequest* request : fleet.requests(now)) write(*request, now, "");
}

// Flushed, so that whoever reads the pipe knows at once.
void ChangeLines::write(const WatchedFleet::Change& change, WatchTime now,
                        const std::string& hour) {
  const NamedRow row = row_of(change, now);
  if (as_ == As::kJson) {
    out_ << json_of(row.kind, row.row, hour);
  } else {
    out_ << hour << (hour.empty() ? "" : " ") << line_of(row.kind, row.row);
  }
  out_ << "\n" << std::flush;
}

std::string utc_now() {
  using namespace std::chrono;
  const auto now = system_clock::now();
  const auto fraction = floor<milliseconds>(now.time_since_epoch()).count() % 1000;
  return fmt::format("{:%Y-%m-%dT%H:%M:%S}.{:03}Z", fmt::gmtime(system_clock::to_time_t(now)),
                     fraction);
}

}  // namespace accord
