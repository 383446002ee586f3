// A line for each change, for files, pipes and programs. Used from one thread.
#pragma once

#include <iosfwd>
#include <string>

#include "client/watch/watched_fleet.h"

namespace accord {

class ChangeLines {
 public:
  enum class As { kText, kJson };

  ChangeLines(std::ostream& out, As as) : out_(out), as_(as) {}

  // A line each for the service, its workers and its requests, as they are. Without the hour.
  void write_all(const WatchedFleet& fleet, WatchTime now);
  // With the hour (UTC), "2026-11-25T17:19:14.184Z" and the like.
  void write(const WatchedFleet::Change& change, WatchTime now, const std::string& hour);

 private:
  std::ostream& out_;
  As as_;
};

// This instant, as write() has it.
std::string utc_now();

}  // namespace accord
