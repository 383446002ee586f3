#include "coordinator/arc.h"

#include <algorithm>
#include <stdexcept>

#include <spdlog/spdlog.h>

#include "common/runtime/log.h"
#include "coordinator/forerunner.h"

namespace accord {
namespace {

// Commits a robot may be part of on average before the search is called off: rounds then only push
// the same conflicts ahead of themselves.
constexpr std::uint64_t kCommitsPerRobot = 400;

}  // namespace

Outcome Arc::resolve(ConflictBoard& board) {
  const std::uint64_t most_commits = kCommitsPerRobot * (schedule_.size() + 10);
  Round round(factory_, schedule_, board, adaptation_);
  while (round.look_ahead()) {
    if (stop_) return stopped(scene(), board);
    statistics_.conflicts_found = board.found();
    report_conflicts(board.size());
    std::vector<Job> jobs = round.choose();
    ++statistics_.rounds;
    solve(jobs, board);
    if (stop_) return stopped(scene(), board);
    for (const Job& job : jobs) {
      record(job);
      log_job(job);
      const Round::Settled settled = round.settle(job);
      if (settled == Round::Settled::kHopeless) {
        return unresolved(scene(), job.conflict, job.subproblem);
      }
      if (settled == Round::Settled::kNotWorthwhile || job.is_exhausted()) continue;
      ++statistics_.solved_by[job.resolution.solver];
      ++statistics_.conflicts_resolved;
    }
    if (board.size() > 0 && statistics_.conflicts_resolved > most_commits) {
      return given_up(scene(), board, statistics_.conflicts_resolved);
    }
  }
  statistics_.windows_grown = adaptation_.windows_grown();
  statistics_.robots_taken_in = adaptation_.robots_taken_in();
  return {PlanStatus::kSolved, ""};
}

void Arc::solve(std::vector<Job>& jobs, const ConflictBoard& board) {
  const Forerunner forerunner(planning_, factory_, schedule_, board, adaptation_);
  bool are_known = false;
  const Foresight foresight = [&](const Likely& likely, std::size_t most) {
    return forerunner.look_ahead(jobs, are_known, likely, most);
  };
  std::vector<Subproblem> subproblems;
  for (const Job& job : jobs) subproblems.push_back(job.subproblem);
  const std::uint64_t before = workforce_.asked();
  std::vector<Resolution> resolutions = workforce_.solve(subproblems, stop_, foresight);
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    jobs[i].resolution = std::move(resolutions[i]);
    jobs[i].number = before + i + 1;
  }
  are_known = true;
  find_robots_in_the_way(jobs, foresight);
}

// What keeps a team from its goals.
void Arc::find_robots_in_the_way(std::vector<Job>& jobs, const Foresight& foresight) {
  std::vector<Subproblem> without;
  std::vector<Job*> failed;
  for (Job& job : jobs) {
    if (!job.is_in_question()) continue;
    without.push_back(without_outsiders(job.subproblem));
    failed.push_back(&job);
  }
  if (failed.empty() || stop_) return;
  const std::vector<Resolution> resolutions = workforce_.solve(without, stop_, foresight);
  for (std::size_t i = 0; i < failed.size(); ++i) {
    Job& job = *failed[i];
    job.resolution.effort += resolutions[i].effort;
    if (resolutions[i].solved) job.in_the_way = hit_by(planning_, job.subproblem, resolutions[i]);
  }
}

void Arc::record(const Job& job) {
  ++statistics_.subproblems;
  statistics_.effort += job.resolution.effort;
  if (job.is_exhausted()) ++statistics_.exhausted;
}

void Arc::log_job(const Job& job) const {
  if (!logs(LogLevel::kDebug)) return;
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
  log(LogLevel::kDebug,
      fmt::format(
          "conflict at {:.3f} s, window {:.3f} to {:.3f} s, horizon {:.3f} s, {} outsiders: {}: {} "
          "({} searches, {} expansions, {} samples)",
          job.conflict.time, job.subproblem.from, job.subproblem.to, job.subproblem.horizon,
          job.subproblem.outsiders.size(), robots, outcome, effort.searches, effort.expansions,
          effort.samples),
      {{"subproblem", job.number}});
}

}  // namespace accord
