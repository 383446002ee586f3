// What workers may return that is wrong in a way that is hard to see: of sound form but for a hair.
#pragma once

#include <algorithm>
#include <limits>
#include <optional>

#include "common/geometry/tolerances.h"
#include "common/planning/conflict.h"
#include "common/planning/subproblem.h"

namespace accord::testing {

// Changes a resolution that holds into one that does not. False where it cannot, and the resolution
// is left as it is. The world keeps what the verifier asks for (kProofMargin).
using Lie = bool (*)(const CollisionWorld& world, const Subproblem&, Resolution&);

inline void set_end(Resolution& resolution) {
  resolution.end = 0;
  for (const Trajectory& path : resolution.paths) {
    resolution.end = std::max(resolution.end, path.end_time());
  }
}

// The same places, at times that `time_of` gives.
template <class TimeOf>
Trajectory retimed(const Trajectory& path, const TimeOf& time_of) {
  Trajectory out(path.dof());
  for (std::size_t k = 0; k < path.size(); ++k) out.append(time_of(k), path.configuration(k));
  return out;
}

inline bool ends_elsewhere(const CollisionWorld&, const Subproblem&, Resolution& resolution) {
  Trajectory& path = resolution.paths.back();
  Trajectory out(path.dof());
  for (std::size_t k = 0; k < path.size(); ++k) {
    Configuration q(path.configuration(k).begin(), path.configuration(k).end());
    if (k + 1 == path.size()) q[0] += 2e-9;
    out.append(path.time(k), q);
  }
  path = std::move(out);
  return true;
}

inline bool is_too_fast(const CollisionWorld&, const Subproblem& subproblem,
                        Resolution& resolution) {
  Trajectory& path = resolution.paths.front();
  if (path.size() < 2) return false;
  path = retimed(path, [from = subproblem.from, &path](std::size_t k) {
    return from + (path.time(k) - from) * (1 - 2e-6);
  });
  set_end(resolution);
  return true;
}

// Straight to the goal.
inline bool cuts_through_an_obstacle(const CollisionWorld& world, const Subproblem& subproblem,
                                     Resolution& resolution) {
  for (std::size_t i = 0; i < subproblem.tasks.size(); ++i) {
    Trajectory& path = resolution.paths[i];
    const ConfigurationView goal = path.configuration(path.size() - 1);
    if (world.motion_is_free(subproblem.tasks[i].robot, path.configuration(0), goal)) continue;
    Trajectory out(path.dof());
    out.append(path.start_time(), path.configuration(0));
    out.append(path.end_time(), goal);  // the way is no longer
    path = std::move(out);
    return true;
  }
  return false;
}

// Has robot i wait until it just about touches another: bisects for how long.
inline bool waits_until_it_touches(const CollisionWorld& world, const Subproblem& subproblem,
                                   Resolution& resolution, std::size_t i, RobotId other,
                                   const Trajectory& theirs, double until) {
  const RobotId robot = subproblem.tasks[i].robot;
  const Trajectory& path = resolution.paths[i];
  const auto delayed = [&](double delay) {
    Trajectory out(path.dof());
    out.append(path.start_time(), path.configuration(0));
    for (std::size_t k = 0; k < path.size(); ++k) {
      out.append(path.time(k) + delay, path.configuration(k));
    }
    return out;
  };
  const auto touches = [&](double delay) {
    const Trajectory late = delayed(delay);
    return !paths_are_clear(world, robot, late, other, theirs, subproblem.from,
                            std::min({until, late.end_time(), subproblem.clear_until}));
  };
  constexpr double kMostDelay = 8;  // s
  double clear = 1e-6, touching = 0.05;
  while (touching < kMostDelay && !touches(touching)) touching *= 1.2;
  if (touches(clear) || !touches(touching)) return false;
  while (touching - clear > 1e-9) {
    const double middle = 0.5 * (clear + touching);
    (touches(middle) ? touching : clear) = middle;
  }
  resolution.paths[i] = delayed(touching);
  set_end(resolution);
  return true;
}

inline bool touches_its_team(const CollisionWorld& world, const Subproblem& subproblem,
                             Resolution& resolution) {
  for (std::size_t i = 0; i < subproblem.tasks.size(); ++i) {
    for (std::size_t j = 0; j < subproblem.tasks.size(); ++j) {
      const Trajectory& theirs = resolution.paths[j];
      if (i != j && waits_until_it_touches(world, subproblem, resolution, i,
                                           subproblem.tasks[j].robot, theirs, theirs.end_time())) {
        return true;
      }
    }
  }
  return false;
}

inline bool touches_an_outsider(const CollisionWorld& world, const Subproblem& subproblem,
                                Resolution& resolution) {
  for (std::size_t i = 0; i < subproblem.tasks.size(); ++i) {
    for (const Outsider& outsider : subproblem.outsiders) {
      if (waits_until_it_touches(world, subproblem, resolution, i, outsider.robot, outsider.path,
                                 outsider.until)) {
        return true;
      }
    }
  }
  return false;
}

}  // namespace accord::testing
