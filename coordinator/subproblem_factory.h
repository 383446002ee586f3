// CreateSubProblem and AdaptSubProblem of the ARC paper: cuts a local problem out of the schedule
// around a conflict, and makes it larger when it could not be solved.
// Pure but for what it reads; not thread safe.
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <vector>

#include "common/geometry/collision_world.h"
#include "common/planning/conflict.h"
#include "common/planning/schedule.h"
#include "common/planning/subproblem.h"
#include "coordinator/conflict_board.h"

namespace accord {

// How far a conflict's subproblem has been grown. (Alg. 2, line 11: AdaptSubProblem)
struct Growth {
  static constexpr unsigned kRetries = 4;  // the last one of them is the last try

  unsigned window = 0;         // doublings of the time window and of the region's margin
  bool shortsighted = false;   // outsiders are avoided only until shortly after the conflict
  bool crowd = false;          // many robots, which look a short time ahead
  bool lockstep = false;       // a crowd, discs or balls, that is too large for the levels
  bool to_the_end = false;     // the window ends with the paths, the region is the whole space
  std::set<RobotId> taken_in;  // robots beyond the conflicting pair
  unsigned retries = 0;        // of the whole problem of all its robots, with more samples each
  unsigned attempts = 0;       // all in all
};

class SubproblemFactory {
 public:
  SubproblemFactory(const CollisionWorld& world, std::uint64_t seed) : world_(world), seed_(seed) {}

  // A robot's own path, from its start at time 0 to its goal: (E, {r}, {q}). (Alg. 1, line 3)
  Subproblem create_initial(RobotId robot) const;

  // All robots from their starts to their goals, with no limit but the solver's own patience: a
  // baseline's one subproblem. Requires: every robot has a path.
  Subproblem create_whole(const Schedule& schedule) const;

  // The subproblem of a conflict at a stage of growth. All robots not in it that come near are its
  // outsiders, but for a crowd in lockstep, which looks out for nobody. Requires: no pair of its
  // robots is in conflict before conflict.time.
  Subproblem create(const Conflict& conflict, const Growth& growth, const Schedule& schedule,
                    const ConflictBoard& board) const;

  // Robots of this model were planned on their roadmaps' level: theirs are searched from now on.
  void use_roadmap(RobotId robot, int level);
  bool uses_roadmap(RobotId robot) const;

  // When a subproblem at that stage of growth begins, is to end at least, and stops looking ahead.
  struct Window {
    double from;     // s
    double to;       // s
    double horizon;  // s
  };
  Window window(const Conflict& conflict, const Growth& growth) const;

  // Whether a robot can leave where it is, as arms cannot.
  bool is_mobile(RobotId robot) const;

  // Whether both are discs or both are balls.
  bool can_move_in_lockstep(RobotId a, RobotId b) const;

  // Time (s) in which a robot moves by about its own size: the unit of windows.
  double own_time(RobotId robot) const;

 private:
  int roadmap_level(RobotId robot) const;  // -1: it uses none
  void set_window(const Conflict& conflict, const Growth& growth, const Schedule& schedule,
                  const std::vector<RobotId>& robots, Subproblem& out) const;
  void cut(const Conflict& conflict, const Growth& growth, const Schedule& schedule,
           const ConflictBoard& board, const std::set<RobotId>& members, Subproblem& out) const;
  // Robots outside the subproblem that come near one of its regions before its horizon.
  std::set<RobotId> robots_near(const Subproblem& subproblem, const ConflictBoard& board) const;
  double clear_end(RobotId robot, double from, double to, const Schedule& schedule,
                   const ConflictBoard& board) const;
  Task make_task(RobotId robot, const Growth& growth, const Schedule& schedule,
                 const ConflictBoard& board, const Subproblem& window) const;
  void add_outsiders(const Schedule& schedule, const ConflictBoard& board, bool settled_only,
                     bool shortsighted, Subproblem& out) const;
  Region region(RobotId robot, const Trajectory& guide, unsigned doublings) const;
  Aabb workspace(RobotId robot, const Region& region) const;
  double body_size(RobotId robot) const;

  const CollisionWorld& world_;
  std::uint64_t seed_;
  std::map<const RobotModel*, int> roadmap_levels_;
};

}  // namespace accord
