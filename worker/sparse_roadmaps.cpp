#include "worker/sparse_roadmaps.h"

#include "common/planning/random.h"
#include "common/planning/region.h"
#include "worker/team.h"

namespace accord {
namespace {

constexpr std::size_t kNeighbours = 6;
constexpr std::size_t kTriesPerSample = 20;
// Parts that each motion of a guide is cut into: places to wait at.
constexpr std::size_t kParts = 4;

void lay_chain(const Team& team, const Trajectory& guide, LocalRoadmap& roadmap) {
  LocalRoadmap::Node before = SparseRoadmaps::kStart;
  Configuration q(team.dof());
  for (std::size_t i = 0; i + 1 < guide.size(); ++i) {
    for (std::size_t part = 1; part <= kParts; ++part) {
      const double share = static_cast<double>(part) / static_cast<double>(kParts);
      guide.at(guide.time(i) + share * (guide.time(i + 1) - guide.time(i)), q);
      const LocalRoadmap::Node node = roadmap.add(team, q);  // the goal itself at the end
      roadmap.connect(team, before, node);
      before = node;
    }
  }
}

void add_samples(const Team& team, const Region& region, std::uint64_t seed, std::size_t count,
                 LocalRoadmap& roadmap) {
  Configuration q(team.dof());
  for (std::size_t i = 0, added = 0; added < count && i < count * kTriesPerSample; ++i) {
    sample_region(region, i, seed, q);
    if (!team.is_free(q)) continue;
    roadmap.connect_nearest(team, roadmap.add(team, q), kNeighbours);
    ++added;
  }
}

}  // namespace

SparseRoadmaps::SparseRoadmaps(const CollisionWorld& world, const Subproblem& subproblem,
                               std::size_t samples) {
  for (const Task& task : subproblem.tasks) {
    const Team team(world, {task.robot}, subproblem.from);
    LocalRoadmap roadmap(team);
    roadmap.add(team, task.start, false);
    roadmap.add(team, task.goal, false);
    lay_chain(team, task.guide, roadmap);
    add_samples(team, task.region, combine({subproblem.seed, task.robot.value}), samples, roadmap);
    roadmaps_.push_back(std::move(roadmap));
  }
}

std::uint64_t SparseRoadmaps::motion_checks() const {
  std::uint64_t sum = 0;
  for (const LocalRoadmap& roadmap : roadmaps_) sum += roadmap.motion_checks();
  return sum;
}

}  // namespace accord
