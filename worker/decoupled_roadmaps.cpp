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

void join_ends(const Team& team, LocalRoadmap& roadmap) {
  std::vector<LocalRoadmap::Node> near;
  for (const LocalRoadmap::Node end :
       {DecoupledRoadmaps::start(roadmap), DecoupledRoadmaps::goal(roadmap)}) {
    roadmap.nearest(team, roadmap.configuration(end), kNeighbours, roadmap.first_own(), near);
    for (const LocalRoadmap::Node node : near) roadmap.connect(team, end, node);
  }
}

void lay_guide(const Team& team, const Task& task, LocalRoadmap& roadmap) {
  const LocalRoadmap::Node goal = DecoupledRoadmaps::goal(roadmap);
  LocalRoadmap::Node before = DecoupledRoadmaps::start(roadmap);
  roadmap.connect(team, before, goal);
  if (task.guide.empty()) return;
  std::vector<double> times = task.guide.times();
  const double from = task.guide.start_time(), to = task.guide.end_time();
  for (std::size_t i = 1; i <= kGuidePoints; ++i) {
    times.push_back(from + (to - from) * static_cast<double>(i) / (kGuidePoints + 1.0));
  }
  std::ranges::sort(times);
  Configuration q(team.dof());
  for (const double t : times) {
    task.guide.at(t, q);
    const LocalRoadmap::Node node = roadmap.add(team, q);
    roadmap.connect(team, before, node);
    if (node != before) roadmap.connect_nearest(team, node, 4);
    before = node;
  }
  roadmap.connect(team, before, goal);
}

}  // namespace

DecoupledRoadmaps::DecoupledRoadmaps(const Workspace& workspace, const Subproblem& subproblem)
    : workspace_(workspace), subproblem_(subproblem), entries_(subproblem.tasks.size()) {}

LocalRoadmap& DecoupledRoadmaps::of(std::size_t task) {
  std::optional<Entry>& entry = entries_[task];
  if (entry && entry->samples == samples_wanted_) return entry->roadmap;
  const Team team(workspace_.world(), {subproblem_.tasks[task].robot}, 0);
  if (!entry) entry.emplace(Entry{build(team, subproblem_.tasks[task])});
  if (entry->samples < samples_wanted_) sample(team, subproblem_.tasks[task], *entry);
  return entry->roadmap;
}

void DecoupledRoadmaps::avoid(std::size_t task, RobotId other, const Trajectory& path, double until,
                              Team& team) {
  const CollisionWorld& world = workspace_.world();
  const RobotId robot = subproblem_.tasks[task].robot;
  if (world.radius(robot) && world.radius(other)) {
    team.avoid(other, path, until);
    return;
  }
  const LocalRoadmap& roadmap = of(task);
  auto& bodies = entries_[task]->bodies;
  auto known =
      std::ranges::find_if(bodies, [&](const auto& body) { return body->is(other, path, until); });
  if (known == bodies.end()) {
    // Of orders tried in turn, only the last paths come again.
    constexpr std::size_t kMostBodies = 64;
    if (bodies.size() == kMostBodies) bodies.erase(bodies.begin());
    bodies.push_back(
        std::make_shared<MovingBody>(world, robot, other, path, subproblem_.from, until, &roadmap));
    known = bodies.end() - 1;
  }
  team.avoid(*known);
}

void DecoupledRoadmaps::avoid_outsiders(std::size_t task, Team& team) {
  for (const Outsider& outsider : subproblem_.outsiders) {
    avoid(task, outsider.robot, outsider.path, outsider.until, team);
  }
}

LocalRoadmap DecoupledRoadmaps::build(const Team& team, const Task& task) const {
  const RobotRoadmap& own = workspace_.roadmap(task.robot);
  const bool is_mobile = workspace_.world().scene().robot(task.robot).model->translations() > 0;
  const SharedRoadmap* base = nullptr;
  if (subproblem_.is_crowd()) {
    base = &own.dense();
  } else if (task.roadmap_level >= 0 || (is_mobile && subproblem_.is_last())) {
    // Where nothing is left to grow, robots that went straight need places to make way to, too.
    // (Arms cannot leave.)
    base = &own.level(static_cast<std::size_t>(std::max(task.roadmap_level, 0)));
  }
  // Motions of discs and balls are proved in closed form.
  const bool is_point = workspace_.world().radius(task.robot).has_value();
  LocalRoadmap roadmap =
      base ? LocalRoadmap(team, *base, task.region, is_point) : LocalRoadmap(team);
  roadmap.add(team, task.start, false);
  roadmap.add(team, task.goal, false);
  if (base) join_ends(team, roadmap);
  lay_guide(team, task, roadmap);
  return roadmap;
}

void DecoupledRoadmaps::sample(const Team& team, const Task& task, Entry& entry) {
  const std::size_t count = samples_wanted_ - entry.samples;
  const std::uint64_t seed = combine({subproblem_.seed, task.robot.value});
  Configuration q(team.dof());
  std::size_t added = 0;
  for (std::size_t tries = 0; added < count && tries < count * kTriesPerSample; ++tries) {
    sample_region(task.region, entry.next_sample++, seed, q);
    if (!team.is_free(q)) continue;
    const LocalRoadmap::Node node = entry.roadmap.add(team, q);
    entry.roadmap.connect_nearest(team, node, kNeighbours);
    ++added;
  }
  samples_ += added;
  entry.samples = samples_wanted_;
}

std::uint64_t DecoupledRoadmaps::motion_checks() const {
  std::uint64_t sum = 0;
  for (const auto& entry : entries_) sum += entry ? entry->roadmap.motion_checks() : 0;
  return sum;
}

}  // namespace accord
