// The only unit of work: a local multi-robot problem around a conflict, or one robot's own path.
// Pure values that can be sent anywhere: the same subproblem gives the same resolution wherever
// and whenever it is solved. (Sections IV-A to IV-C of the ARC paper: E', R', Q')
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "common/model/ids.h"
#include "common/model/trajectory.h"

namespace accord {

// A robot's own roadmaps come in so many levels, each denser than the one before.
inline constexpr int kRoadmapLevels = 5;

// A box in one robot's configuration space: E' of the paper, for that robot.
struct Region {
  Configuration lower;
  Configuration upper;
};

// One robot of a subproblem.
struct Task {
  RobotId robot;
  std::uint64_t version;   // of the robot's trajectory that this was computed from
  Configuration start;     // at the window's start
  double to = 0;           // s: when the robot's present path reaches the goal
  Configuration goal;      // to be reached then, or later
  Region region;           // holds start, goal and guide
  Trajectory guide;        // the robot's present path inside the window
  Trajectory tail;         // and after it, as far as the horizon; begins at the goal
  int roadmap_level = -1;  // of the robot's own roadmap, to search on as well; -1: none

  // Whether the robot goes on after its goal; else it rests there.
  bool goes_on() const { return tail.size() > 1; }
};

// A robot that is not part of the subproblem and keeps to its present path.
struct Outsider {
  RobotId robot;
  std::uint64_t version;
  Trajectory path;
  double until;  // s: avoided until then; infinite where it has parked and is not to be moved
};

// What bounds a solution attempt. Counts, never time: budgets must not depend on the machine.
struct SolverLimits {
  std::size_t query_expansions = 4000;        // states expanded by one safe-interval search
  std::size_t query_checks = 20000;           // geometric queries against moving bodies in one
  std::size_t priority_orders = 6;            // orders tried by prioritized planning; 1: in task
                                              // order alone
  std::size_t decoupled_samples = 48;         // free samples a robot adds at most
  std::size_t composite_nodes = 400;          // nodes of one composite roadmap at most; more where
                                              // nothing is left to grow: Subproblem says
  std::size_t composite_window_per_dof = 12;  // W of the adaptive termination, per dof
  std::size_t last_factor = 50;               // times the nodes where nothing is left to grow

  // For baselines, which go on until they are stopped, in task order.
  static SolverLimits unlimited() {
    constexpr std::size_t kMost = 1'000'000'000;
    return {kMost, kMost, 1, kMost, kMost, 12, 1};
  }

  friend bool operator==(const SolverLimits&, const SolverLimits&) = default;
};

struct Subproblem {
  std::uint64_t seed = 0;
  double from = 0;     // s: all robots are at their starts
  double to = 0;       // s: when the last of the present paths reaches its goal
  double horizon = 0;  // s: outsiders are avoided until then; what comes later is left to later
                       // subproblems, which will know it better
  // s: the team's robots keep clear of each other until then, at least until all have arrived where
  // it is infinite.
  double clear_until = std::numeric_limits<double>::infinity();
  // Too many robots for the hierarchy's levels: all go to the ends of their paths in lockstep, and
  // may still run into others where they do not arrive so (see LockstepQuery).
  bool lockstep = false;
  bool whole = false;               // E' = E and Q' = Q
  std::vector<Task> tasks;          // in the order of robot ids
  std::vector<Outsider> outsiders;  // in the order of robot ids
  SolverLimits limits;

  // Nothing is left to grow: the last solver goes on to its own limit.
  bool is_last() const { return whole && outsiders.empty(); }
  // Of one composite roadmap, at most.
  std::size_t composite_nodes() const {
    return limits.composite_nodes * (is_last() ? limits.last_factor : 1);
  }
  // Many robots that look a short time ahead.
  bool is_crowd() const { return clear_until < std::numeric_limits<double>::infinity(); }
};

// What solving it cost. The same for the same subproblem: work on what many share, such as a
// robot's own roadmaps, is counted as asked for, not as done.
struct Effort {
  std::uint64_t searches = 0;
  std::uint64_t expansions = 0;
  std::uint64_t samples = 0;
  std::uint64_t motion_checks = 0;
  std::uint64_t distance_queries = 0;  // but for those that proved edges of shared roadmaps

  Effort& operator+=(const Effort& other) {
    searches += other.searches;
    expansions += other.expansions;
    samples += other.samples;
    motion_checks += other.motion_checks;
    distance_queries += other.distance_queries;
    return *this;
  }
};

struct Resolution {
  bool solved = false;            // else: exhausted
  std::string solver;             // which one found it
  int roadmap_level = -1;         // of the roadmap that a robot's own path was found on; -1: none
  double end = 0;                 // s: when the last robot arrives at its goal
  std::vector<Trajectory> paths;  // one a task; from `from` to its arrival, at most `end`
  // Of a crowd that is not solved: robots that no path was found for, so that they keep to their
  // present ones. All others keep clear of each other on theirs, which is worth having.
  // Of a crowd in lockstep that is solved: robots that had not arrived with the others, and go on
  // as if alone once the last of these has.
  std::vector<RobotId> left;
  Effort effort;

  bool improves() const { return !solved && !left.empty(); }
};

}  // namespace accord
