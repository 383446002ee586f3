// The joint configuration space of a subproblem's robots: all of them as one team, in the order of
// the tasks. What the composite solvers share.
#pragma once

#include <span>
#include <vector>

#include "common/planning/random.h"
#include "common/planning/subproblem.h"
#include "worker/decoupled_roadmaps.h"
#include "worker/safe_interval_search.h"
#include "worker/team.h"
#include "worker/workspace.h"

namespace accord {

std::vector<RobotId> members(const Subproblem& subproblem);
Configuration joint_start(const Subproblem& subproblem);
Configuration joint_goal(const Subproblem& subproblem);

// A search for a joint path through the window, from node `start` to node `goal`.
SearchRequest joint_request(const Subproblem& subproblem, LocalRoadmap::Node start,
                            LocalRoadmap::Node goal);

// Joint configurations: of each robot's part some come from its own roadmap's
// places (start, goal, guide), which hold still while others pass and lie in narrow passages; the
// rest from its region. The same stream for the same subproblem. Not thread safe.
class JointSampler {
 public:
  // Both must outlive this.
  JointSampler(const Workspace& workspace, const Subproblem& subproblem)
      : subproblem_(subproblem),
        places_(workspace, subproblem),
        random_(combine({subproblem.seed, 0x636f6d70})) {}

  // Uniform in [0, n), from the same stream. Requires: n > 0.
  std::size_t below(std::size_t n) { return random_.below(n); }

  // Draws a configuration in which all robots are free and clear of each other: all parts at once
  // or, in a crowd where that keeps failing, one after the other beside those before. False: it
  // found none in a number of tries. Requires: team is the subproblem's.
  bool sample_free(const Team& team, Configuration& q);

  // Draws one robot's part anew, the others staying where they are in q: how robots that have no
  // room to move at the same time get by each other. False: it found none in a number of tries.
  bool move_one(const Team& team, Configuration& q);

 private:
  void draw(std::size_t robot, std::span<double> q);
  bool draw_at_once(const Team& team, Configuration& q);
  bool draw_one_by_one(const Team& team, Configuration& q);

  const Subproblem& subproblem_;
  DecoupledRoadmaps places_;
  RandomStream random_;
  std::uint64_t next_ = 0;
};

// Fills in a resolution's paths, one a robot, from a joint path.
void set_joint_path(const Team& team, const Trajectory& path, Resolution& resolution);

}  // namespace accord
