#include "coordinator/round.h"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>

namespace accord {
namespace {

// Conflicts that are known at a time, at least: enough for many workers. All of a small problem's.
constexpr std::size_t kEnoughConflicts = 64;
constexpr std::size_t kRobotsPerConflict = 4;

// Whether the conflict that a job is about is still there.
bool is_left(const Job& job) {
  if (job.resolution.solved) return false;
  if (!job.resolution.improves()) return true;
  return std::ranges::any_of(job.resolution.left, [&](RobotId robot) {
    return robot == job.conflict.first || robot == job.conflict.second;
  });
}

// Robots that a choice of subproblems has to do with.
class Chosen {
 public:
  void add(const Subproblem& subproblem) {
    for (const Task& task : subproblem.tasks) {
      used_.insert(task.robot);
      members_.insert(task.robot);
    }
    for (const Outsider& outsider : subproblem.outsiders) used_.insert(outsider.robot);
  }
  bool uses(RobotId robot) const { return used_.contains(robot); }
  bool clashes_with(const Subproblem& subproblem) const {
    const auto is_used = [&](const Task& task) { return used_.contains(task.robot); };
    const auto is_member = [&](const Outsider& other) { return members_.contains(other.robot); };
    return std::ranges::any_of(subproblem.tasks, is_used) ||
           std::ranges::any_of(subproblem.outsiders, is_member);
  }

 private:
  std::set<RobotId> used_;  // members and outsiders
  std::set<RobotId> members_;
};

}  // namespace

Subproblem without_outsiders(const Subproblem& subproblem) {
  Subproblem without = subproblem;
  without.outsiders.clear();
  return without;
}

std::vector<RobotId> hit_by(const CollisionWorld& world, const Subproblem& subproblem,
                            const Resolution& without) {
  std::vector<std::pair<double, RobotId>> hits;
  const std::vector<Task>& tasks = subproblem.tasks;
  for (const Outsider& outsider : subproblem.outsiders) {
    double first = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < tasks.size(); ++i) {
      const auto hit =
          earliest_contact(world, tasks[i].robot, without.paths[i], outsider.robot, outsider.path,
                           subproblem.from, std::min({first, without.end, outsider.until}));
      if (hit) first = std::min(first, *hit);
    }
    if (first < std::numeric_limits<double>::infinity()) hits.emplace_back(first, outsider.robot);
  }
  std::ranges::sort(hits);
  std::vector<RobotId> robots;
  for (const auto& [time, robot] : hits) robots.push_back(robot);
  return robots;
}

bool Round::look_ahead() {
  const std::size_t enough = std::max(kEnoughConflicts, schedule_.size() / kRobotsPerConflict);
  return board_.look_ahead(enough, adaptation_.reach());
}

std::vector<Job> Round::choose(const std::vector<const Subproblem*>& pending) const {
  std::vector<Job> jobs;
  Chosen chosen;
  for (const Subproblem* subproblem : pending) chosen.add(*subproblem);
  std::set<RobotId> waiting;  // robots with an earlier conflict that was not chosen
  for (const Conflict& conflict : board_.conflicts()) {
    const bool behind = waiting.contains(conflict.first) || waiting.contains(conflict.second) ||
                        chosen.uses(conflict.first) || chosen.uses(conflict.second);
    waiting.insert({conflict.first, conflict.second});
    if (behind) continue;
    const Growth growth = adaptation_.growth_of(conflict, board_);
    if (std::ranges::any_of(growth.taken_in, [&](RobotId r) { return chosen.uses(r); })) continue;
    Job job{conflict, factory_.create(conflict, growth, schedule_, board_), {}, {}, 0};
    if (chosen.clashes_with(job.subproblem)) continue;
    chosen.add(job.subproblem);
    jobs.push_back(std::move(job));
  }
  return jobs;
}

Round::Settled Round::settle(const Job& job) {
  if (job.resolution.solved &&
      adaptation_.prefers_crowd(job.conflict, job.subproblem, job.resolution, board_)) {
    return Settled::kNotWorthwhile;
  }
  if (!job.is_exhausted()) commit(job);
  if (!is_left(job)) {
    adaptation_.note_resolved(job.conflict, job.subproblem);
    return Settled::kCommitted;
  }
  return adaptation_.grow(job.conflict, job.subproblem, job.in_the_way, board_)
             ? Settled::kLeft
             : Settled::kHopeless;
}

// UpdateSolution: splices the local paths in, and looks for conflicts where paths have changed.
void Round::commit(const Job& job) {
  if (!schedule_.commit(job.subproblem, job.resolution, job.number)) {
    throw std::logic_error(job.resolution.solver + " returned paths that do not fit their window");
  }
  std::vector<RobotId> changed;
  for (const Task& task : job.subproblem.tasks) {
    if (schedule_.version(task.robot) != task.version) changed.push_back(task.robot);
  }
  board_.update(changed, job.subproblem.from);
}

}  // namespace accord
