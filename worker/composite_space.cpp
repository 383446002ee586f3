#include "worker/composite_space.h"

#include <algorithm>

#include "common/planning/region.h"
#include "worker/continuation.h"

namespace accord {
namespace {

// Of each robot's part of a sample, so many in ten come from its own roadmap's places.
constexpr std::size_t kFromRoadmapInTen = 4;

}  // namespace

std::vector<RobotId> members(const Subproblem& subproblem) {
  std::vector<RobotId> robots;
  for (const Task& task : subproblem.tasks) robots.push_back(task.robot);
  return robots;
}

Configuration joint_start(const Subproblem& subproblem) {
  Configuration q;
  for (const Task& task : subproblem.tasks) q.insert(q.end(), task.start.begin(), task.start.end());
  return q;
}

Configuration joint_goal(const Subproblem& subproblem) {
  Configuration q;
  for (const Task& task : subproblem.tasks) q.insert(q.end(), task.goal.begin(), task.goal.end());
  return q;
}

SearchRequest joint_request(const Subproblem& subproblem, LocalRoadmap::Node start,
                            LocalRoadmap::Node goal) {
  double hold = subproblem.from;
  for (const Task& task : subproblem.tasks) hold = std::max(hold, hold_until(subproblem, task));
  return {start,
          goal,
          subproblem.from,
          hold,
          subproblem.limits.query_expansions,
          subproblem.limits.query_checks};
}

void JointSampler::sample(Configuration& q) {
  std::size_t offset = 0;
  for (std::size_t i = 0; i < subproblem_.tasks.size(); ++i) {
    const Task& task = subproblem_.tasks[i];
    const std::span<double> mine(q.data() + offset, task.start.size());
    offset += task.start.size();
    if (random_.below(10) < kFromRoadmapInTen) {
      const auto node = static_cast<LocalRoadmap::Node>(random_.below(places_.of(i).size()));
      std::ranges::copy(places_.of(i).configuration(node), mine.begin());
    } else {
      sample_region(task.region, next_, combine({subproblem_.seed, i, 0x73}), mine);
    }
  }
  ++next_;
}

void set_joint_path(const Team& team, const Trajectory& path, Resolution& resolution) {
  resolution.solved = true;
  resolution.end = path.end_time();
  resolution.paths.clear();
  for (std::size_t i = 0; i < team.size(); ++i) {
    Trajectory part(team.part(path.configuration(0), i).size());
    for (std::size_t k = 0; k < path.size(); ++k) {
      part.append(path.time(k), team.part(path.configuration(k), i));
    }
    resolution.paths.push_back(std::move(part));
  }
}

}  // namespace accord
