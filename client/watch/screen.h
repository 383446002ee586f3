// All that is known of a service, as the lines of a screen. Pure; thread safe.
#pragma once

#include <string>
#include <vector>

#include "client/watch/columns.h"
#include "client/watch/watched_fleet.h"

namespace accord {

// Columns and lines of a terminal.
struct ScreenSize {
  std::size_t width = kAnyWidth;
  std::size_t height = kAnyWidth;
};

// The service, its requests and its workers, each under its heading, in at most so many lines of at
// most so many characters; where there are more, how many are left out is said.
std::vector<std::string> screen_of(const WatchedFleet& fleet, WatchTime now, ScreenSize size);

// The workers alone, but for those that are lost.
std::vector<Row> rows_of_workers(const WatchedFleet& fleet);

}  // namespace accord
