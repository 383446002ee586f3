// Proves a plan free of collisions in continuous time, trusting no planner: from the scene and the
// plan's numbers alone. Shares nothing with planning but geometry/.
//
// In order: the plan's form; each robot by itself (start, limits, speeds, bounds, obstacles, its
// own links, goal), segment by segment; every pair of robots from 0 to the end of time, a broad
// phase in space and time first; what the plan says of itself, its segments and its costs.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/model/plan.h"
#include "common/model/scene.h"

namespace accord {

struct Violation {
  enum class Kind {
    kForm,    // robots, waypoints, times or segments are missing, unknown, out of order or not
              // finite
    kStart,   // does not begin at the start
    kGoal,    // does not end at the goal (headings, continuous joints: up to 2 pi)
    kLimit,   // leaves a degree of freedom's bounds
    kSpeed,   // moves faster than allowed
    kBounds,  // leaves the scene's bounds
    kObstacle,
    kSelf,
    kRobots,  // two robots
    kCosts,   // makespan or costs do not match the paths
  };
  Kind kind;
  std::vector<std::string> robots;
  double time;       // s
  Vec3 where;        // near the place; world frame
  double gap;        // m: separation where positive, else minus the overlap; what is exceeded by
                     // how much for the other kinds
  std::string text;  // one sentence: what, who, when, where, by how much
};

std::string_view to_string(Violation::Kind kind);

struct Separation {
  double distance;     // m: a proven lower bound, never below the clearance
  double time;         // s, near it
  std::string first;   // robot
  std::string second;  // robot or obstacle
};

struct Verdict {
  std::optional<Violation> violation;  // the earliest; nullopt: the plan is proved
  // The smallest separations, where anything comes closer than 1 m; only for proved plans, and only
  // where asked for.
  std::optional<Separation> robots;
  std::optional<Separation> obstacles;

  bool proved() const { return !violation; }
};

// What else is worked out of a plan that holds: the smallest separations cost more than the proof.
enum class Beyond { kNothing, kSeparations };

// Requires: the scene passed io's checks. Any plan is acceptable input. `threads` changes only the
// time it takes. Thread safe.
Verdict verify(const std::shared_ptr<const Scene>& scene, const Plan& plan, unsigned threads = 1,
               Beyond beyond = Beyond::kSeparations);

}  // namespace accord
