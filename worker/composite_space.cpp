#include "worker/composite_space.h"

#include <algorithm>

#include "common/planning/region.h"
#include "worker/continuation.h"

namespace accord {
namespace {

// Of each robot's part of a sample, so many in ten come from its own roadmap's places.
constexpr std::size_t kFromRoadmapInTen = 4;
constexpr std::size_t kTriesAtOnce = 50;
constexpr std::size_t kTriesOneByOne = 64;  // for each robot

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

void JointSampler::draw(std::size_t robot, std::span<double> q) {
  LocalRoadmap& places = places_.of(robot);
  if (random_.below(10) < kFromRoadmapInTen) {
    const auto node = static_cast<LocalRoadmap::Node>(random_.below(places.size()));
    std::ranges::copy(places.configuration(node), q.begin());
  } else {
    sample_region(subproblem_.tasks[robot].region, next_, combine({subproblem_.seed, robot, 0x73}),
                  q);
  }
}

bool JointSampler::sample_free(const Team& team, Configuration& q) {
  return draw_at_once(team, q) || draw_one_by_one(team, q);
}

bool JointSampler::draw_at_once(const Team& team, Configuration& q) {
  for (std::size_t tries = 0; tries < kTriesAtOnce; ++tries) {
    for (std::size_t i = 0; i < team.size(); ++i) draw(i, team.mutable_part(q, i));
    ++next_;
    if (team.is_free(q)) return true;
  }
  return false;
}

bool JointSampler::draw_one_by_one(const Team& team, Configuration& q) {
  for (std::size_t i = 0; i < team.size(); ++i) {
    std::size_t tries = 0;
    do {
      if (tries++ == kTriesOneByOne) return false;
      draw(i, team.mutable_part(q, i));
      ++next_;
    } while (!team.is_free_beside(q, i));
  }
  return true;
}

bool JointSampler::move_one(const Team& team, Configuration& q) {
  for (std::size_t tries = 0; tries < kTriesOneByOne; ++tries, ++next_) {
    const std::size_t robot = random_.below(team.size());
    const ConfigurationView stays = team.part(q, robot);
    const Configuration before(stays.begin(), stays.end());
    draw(robot, team.mutable_part(q, robot));
    if (team.is_free(q)) return true;
    std::ranges::copy(before, team.mutable_part(q, robot).begin());
  }
  return false;
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
