// The latest path of each robot, whichever request it is of, for robots that come later than their
// plan. What has been planned last counts: a plan that is sent again, since somebody asked for it,
// does not become the latest.
// Not thread safe.
#pragma once

#include <cstddef>
#include <deque>
#include <map>
#include <memory>
#include <string>

#include "common/transport/fleet/fleet_messages.h"
#include "common/transport/fleet/recent_ids.h"

namespace accord {

class LatestPaths {
 public:
  // Keeps plans of so many waypoints' numbers at most, in bytes; the oldest go first.
  explicit LatestPaths(std::size_t most_bytes);

  void add(const std::shared_ptr<const FinishedPlan>& plan);

  struct Path {
    std::shared_ptr<const FinishedPlan> plan;  // null: none is known
    std::size_t robot = 0;                     // its place there
  };
  Path of(const std::string& robot) const;

 private:
  struct Kept {
    std::shared_ptr<const FinishedPlan> plan;
    std::size_t bytes = 0;
  };

  void forget_oldest();

  std::size_t most_bytes_;
  std::size_t bytes_ = 0;
  RecentIds known_;
  std::deque<Kept> plans_;  // the oldest first
  std::map<std::string, Path> latest_;
};

}  // namespace accord
