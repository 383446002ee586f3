#include "coordinator/arc.h"

#include <algorithm>
#include <limits>
#include <set>
#include <stdexcept>

#include <spdlog/spdlog.h>

#include "common/planning/conflict.h"

namespace accord {
namespace {

// Commits a robot may be part of on average before the search is called off: rounds then only push
// the same conflicts ahead of themselves.
constexpr std::uint64_t kCommitsPerRobot = 400;
// Conflicts that are known at a time, at least: enough for many workers. All of a small problem's.
constexpr std::size_t kEnoughConflicts = 64;
constexpr std::size_t kRobotsPerConflict = 4;

}  // namespace

Outcome Arc::resolve(ConflictBoard& board) {
  const std::uint64_t most_commits = kCommitsPerRobot * (schedule_.size() + 10);
  const std::size_t enough = std::max(kEnoughConflicts, schedule_.size() / kRobotsPerConflict);
  const double reach = adaptation_.reach();
  while (board.look_ahead(enough, reach)) {
    if (stop_) return stopped(scene(), board);
    statistics_.conflicts_found = board.found();
    report(Progress::Phase::kConflicts, schedule_.size());
    std::vector<Job> jobs = choose(board);
    ++statistics_.rounds;
    solve(jobs);
    if (stop_) return stopped(scene(), board);
    for (const Job& job : jobs) {
      record(job);
      log(job);
      if (job.resolution.solved &&
          adaptation_.prefers_crowd(job.conflict, job.subproblem, job.resolution, board)) {
        continue;
      }
      if (job.resolution.solved || job.resolution.improves()) commit(job, board);
      if (!is_left(job)) {
        adaptation_.note_resolved(job.conflict, job.subproblem);
      } else if (!adaptation_.grow(job.conflict, job.subproblem, job.in_the_way, board)) {
        return unresolved(scene(), job.conflict, job.subproblem);
      }
    }
    if (board.size() > 0 && statistics_.conflicts_resolved > most_commits) {
      return given_up(scene(), board, statistics_.conflicts_resolved);
    }
  }
  statistics_.windows_grown = adaptation_.windows_grown();
  statistics_.robots_taken_in = adaptation_.robots_taken_in();
  return {PlanStatus::kSolved, ""};
}

// UpdateSolution: splices the local paths in, and looks for conflicts where paths have changed.
void Arc::commit(const Job& job, ConflictBoard& board) {
  if (!schedule_.commit(job.subproblem, job.resolution)) {
    throw std::logic_error(job.resolution.solver + " returned paths that do not fit their window");
  }
  std::vector<RobotId> changed;
  for (const Task& task : job.subproblem.tasks) {
    if (schedule_.version(task.robot) != task.version) changed.push_back(task.robot);
  }
  board.update(changed, job.subproblem.from);
  ++statistics_.solved_by[job.resolution.solver];
  ++statistics_.conflicts_resolved;
}

// Whether the conflict that a job is about is still there.
bool Arc::is_left(const Job& job) {
  if (job.resolution.solved) return false;
  if (!job.resolution.improves()) return true;
  return std::ranges::any_of(job.resolution.left, [&](RobotId robot) {
    return robot == job.conflict.first || robot == job.conflict.second;
  });
}

// The earliest conflicts first; each robot's own earliest only; none whose robots another chosen
// one has to avoid, or the other way round.
std::vector<Arc::Job> Arc::choose(const ConflictBoard& board) const {
  std::vector<Job> jobs;
  std::set<RobotId> used;     // members and outsiders of chosen ones
  std::set<RobotId> members;  // of chosen ones
  std::set<RobotId> waiting;  // robots with an earlier conflict that was not chosen
  for (const Conflict& conflict : board.conflicts()) {
    const bool behind = waiting.contains(conflict.first) || waiting.contains(conflict.second) ||
                        used.contains(conflict.first) || used.contains(conflict.second);
    waiting.insert({conflict.first, conflict.second});
    if (behind) continue;
    const Growth growth = adaptation_.growth_of(conflict, board);
    if (std::ranges::any_of(growth.taken_in, [&](RobotId r) { return used.contains(r); })) continue;
    Job job{conflict, factory_.create(conflict, growth, schedule_, board), {}, {}};
    const auto clashes = [&](const auto& entry) { return used.contains(entry.robot); };
    const auto is_member = [&](const auto& entry) { return members.contains(entry.robot); };
    if (std::ranges::any_of(job.subproblem.tasks, clashes) ||
        std::ranges::any_of(job.subproblem.outsiders, is_member)) {
      continue;
    }
    for (const Task& task : job.subproblem.tasks) {
      used.insert(task.robot);
      members.insert(task.robot);
    }
    for (const Outsider& outsider : job.subproblem.outsiders) used.insert(outsider.robot);
    jobs.push_back(std::move(job));
  }
  return jobs;
}

void Arc::solve(std::vector<Job>& jobs) {
  std::vector<Subproblem> subproblems;
  for (Job& job : jobs) subproblems.push_back(std::move(job.subproblem));
  std::vector<Resolution> resolutions = workforce_.solve(subproblems, stop_);
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    jobs[i].subproblem = std::move(subproblems[i]);
    jobs[i].resolution = std::move(resolutions[i]);
  }
  find_robots_in_the_way(jobs);
}

// What keeps a team from its goals: the outsiders that a solution without outsiders would run into.
void Arc::find_robots_in_the_way(std::vector<Job>& jobs) {
  std::vector<Subproblem> without;
  std::vector<Job*> failed;
  for (Job& job : jobs) {
    const bool is_exhausted = !job.resolution.solved && !job.resolution.improves();
    if (!is_exhausted || job.subproblem.outsiders.empty()) continue;
    without.push_back(job.subproblem);
    without.back().outsiders.clear();
    failed.push_back(&job);
  }
  if (failed.empty() || stop_) return;
  const std::vector<Resolution> resolutions = workforce_.solve(without, stop_);
  for (std::size_t i = 0; i < failed.size(); ++i) {
    failed[i]->resolution.effort += resolutions[i].effort;
    if (resolutions[i].solved) failed[i]->in_the_way = hit_by(*failed[i], resolutions[i]);
  }
}

// The outsiders that a job's resolution runs into, earliest first.
std::vector<RobotId> Arc::hit_by(const Job& job, const Resolution& resolution) const {
  std::vector<std::pair<double, RobotId>> hits;
  const std::vector<Task>& tasks = job.subproblem.tasks;
  for (const Outsider& outsider : job.subproblem.outsiders) {
    double first = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < tasks.size(); ++i) {
      const auto hit = earliest_contact(planning_, tasks[i].robot, resolution.paths[i],
                                        outsider.robot, outsider.path, job.subproblem.from,
                                        std::min({first, resolution.end, outsider.until}));
      if (hit) first = std::min(first, *hit);
    }
    if (first < std::numeric_limits<double>::infinity()) hits.emplace_back(first, outsider.robot);
  }
  std::ranges::sort(hits);
  std::vector<RobotId> robots;
  for (const auto& [time, robot] : hits) robots.push_back(robot);
  return robots;
}

void Arc::record(const Job& job) {
  ++statistics_.subproblems;
  statistics_.effort += job.resolution.effort;
  if (!job.resolution.solved && !job.resolution.improves()) ++statistics_.exhausted;
}

void Arc::log(const Job& job) const {
  if (!spdlog::should_log(spdlog::level::debug)) return;
  std::string robots;
  for (const Task& task : job.subproblem.tasks) {
    robots += (robots.empty() ? "" : ", ") + scene().robot(task.robot).name;
  }
  std::string outcome = job.resolution.solver;
  if (!job.resolution.solved) outcome = "exhausted";
  if (job.resolution.improves()) {
    outcome =
        fmt::format("{} but for {} robots", job.resolution.solver, job.resolution.left.size());
  }
  const Effort& effort = job.resolution.effort;
  spdlog::debug(
      "conflict at {:.3f} s, window {:.3f} to {:.3f} s, horizon {:.3f} s, {} outsiders: {}: {} "
      "({} searches, {} expansions, {} samples)",
      job.conflict.time, job.subproblem.from, job.subproblem.to, job.subproblem.horizon,
      job.subproblem.outsiders.size(), robots, outcome, effort.searches, effort.expansions,
      effort.samples);
}

}  // namespace accord
