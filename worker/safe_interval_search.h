// Safe-interval path planning on a roadmap, in continuous time: the earliest arrival at a goal
// among moving obstacles, waiting allowed at every node (SIPP; Phillips and Likhachev, ICRA 2011).
// Optimal on the roadmap where departures are found exactly (see MovingObstacles).
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <vector>

#include "common/model/trajectory.h"
#include "worker/local_roadmap.h"
#include "worker/team.h"
#include "worker/timed_motions.h"

namespace accord {

struct SearchRequest {
  LocalRoadmap::Node start;
  LocalRoadmap::Node goal;
  double from;             // s: at the start
  double hold_until;       // s: the goal must stay free until then (or the arrival, if later)
  std::size_t expansions;  // gives up after so many
  std::uint64_t checks;    // and after so many geometric queries against moving bodies
  double greed = 1;        // > 1: looks first where the goal is near, for arrivals at most so many
                           // times later than the earliest
};

// A path, and the roadmap's node at each of its waypoints.
struct TimedPath {
  Trajectory path;
  std::vector<LocalRoadmap::Node> nodes;
};

// The earliest path from `from` to the arrival as `motions` allow it, waits written out. nullopt:
// the roadmap holds no such path, a budget ran out, or `stop` became true. Proves edges as it needs
// them. `expanded` is increased by the states expanded.
std::optional<TimedPath> search_in_time(const Team& team, LocalRoadmap& roadmap,
                                        TimedMotions& motions, const SearchRequest& request,
                                        const std::atomic<bool>& stop, std::uint64_t& expanded);

// The same among the moving bodies that the team avoids.
std::optional<Trajectory> safe_interval_search(Team& team, LocalRoadmap& roadmap,
                                               const SearchRequest& request,
                                               const std::atomic<bool>& stop,
                                               std::uint64_t& expanded);

}  // namespace accord
