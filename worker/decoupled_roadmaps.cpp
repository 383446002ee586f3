#include "worker/decoupled_roadmaps.h"

#include <algorithm>
#include <cmath>

#include "common/planning/random.h"
#include "common/planning/region.h"

namespace accord {
namespace {

constexpr std::size_t kNeighbours = 10;
// Points between the guide's waypoints, over the whole window: places to wait at.
constexpr std::size_t kGuidePoints = 9;
// Tries a sample is worth: regions are mostly free, and where they are not, coupling is cheaper.
constexpr std::size_t kTriesPerSample = 10;

Team alone(const CollisionWorld& world, RobotId robot) {
  return Team(world, {robot}, 0);
}

}  // namespace

DecoupledRoadmaps::DecoupledRoadmaps(const Workspace& workspace, const Subproblem& subproblem)
    : subproblem_(subproblem), next_sample_(subproblem.tasks.size(), 0) {
  for (const Task& task : subproblem.tasks) {
    const Team team = alone(workspace.world(), task.robot);
    LocalRoadmap& roadmap = roadmaps_.emplace_back(team);
    roadmap.add(team, task.start, false);
    roadmap.add(team, task.goal, false);
    if (task.roadmap_level >= 0) {
      workspace.roadmap(task.robot)
          .copy_into(static_cast<std::size_t>(task.roadmap_level), task.region, team, roadmap);
      join_ends(team, roadmap);
    }
    lay_guide(team, roadmap, task);
  }
}

void DecoupledRoadmaps::join_ends(const Team& team, LocalRoadmap& roadmap) {
  std::vector<LocalRoadmap::Node> near;
  for (const LocalRoadmap::Node end : {kStart, kGoal}) {
    const auto all = static_cast<LocalRoadmap::Node>(roadmap.size());
    roadmap.nearest(team, roadmap.configuration(end), kNeighbours, all, near);
    for (const LocalRoadmap::Node node : near) roadmap.connect(team, end, node);
  }
}

void DecoupledRoadmaps::lay_guide(const Team& team, LocalRoadmap& roadmap, const Task& task) {
  roadmap.connect(team, kStart, kGoal);
  if (task.guide.empty()) return;
  std::vector<double> times = task.guide.times();
  const double from = task.guide.start_time(), to = task.guide.end_time();
  for (std::size_t i = 1; i <= kGuidePoints; ++i) {
    times.push_back(from + (to - from) * static_cast<double>(i) / (kGuidePoints + 1.0));
  }
  std::ranges::sort(times);
  Configuration q(team.dof());
  LocalRoadmap::Node before = kStart;
  for (const double t : times) {
    task.guide.at(t, q);
    const LocalRoadmap::Node node = roadmap.add(team, q);
    roadmap.connect(team, before, node);
    if (node != before) roadmap.connect_nearest(team, node, 4);
    before = node;
  }
  roadmap.connect(team, before, kGoal);
}

void DecoupledRoadmaps::add_samples(const CollisionWorld& world, std::size_t count) {
  for (std::size_t i = 0; i < roadmaps_.size(); ++i) {
    const Task& task = subproblem_.tasks[i];
    const Team team = alone(world, task.robot);
    const std::uint64_t seed = combine({subproblem_.seed, task.robot.value});
    Configuration q(team.dof());
    std::size_t added = 0;
    for (std::size_t tries = 0; added < count && tries < count * kTriesPerSample; ++tries) {
      sample_region(task.region, next_sample_[i]++, seed, q);
      if (!team.is_free(q)) continue;
      const LocalRoadmap::Node node = roadmaps_[i].add(team, q);
      roadmaps_[i].connect_nearest(team, node, kNeighbours);
      ++added;
    }
    samples_ += added;
  }
}

std::uint64_t DecoupledRoadmaps::motion_checks() const {
  std::uint64_t sum = 0;
  for (const LocalRoadmap& roadmap : roadmaps_) sum += roadmap.motion_checks();
  return sum;
}

}  // namespace accord
