#include "common/planning/schedule.h"

#include <algorithm>
#include <limits>

#include "common/planning/resolution_form.h"
#include "common/planning/splice.h"

namespace accord {
namespace {

// The part of a coupling timeline inside [from, to), moved by `shift`.
void copy_clipped(const std::vector<CouplingSegment>& segments, double from, double to,
                  double shift, std::vector<CouplingSegment>& out) {
  for (const CouplingSegment& segment : segments) {
    const double begin = std::max(segment.from, from), end = std::min(segment.to, to);
    if (begin >= end) continue;
    out.push_back({begin + shift, end + shift, segment.robots, segment.solver, segment.subproblem});
  }
}

// Makes a timeline run from 0 to `end` without gaps: where a robot has parked, until it is moved
// again, belongs to how it got there.
void close_gaps(double end, std::vector<CouplingSegment>& coupling) {
  while (coupling.size() > 1 && coupling.back().from >= end) coupling.pop_back();
  coupling.front().from = 0;
  for (std::size_t i = 1; i < coupling.size(); ++i) coupling[i - 1].to = coupling[i].from;
  coupling.back().to = end;
  if (coupling.size() > 1) {
    std::erase_if(coupling, [](const CouplingSegment& s) { return s.from >= s.to; });
  }
}

}  // namespace

Schedule::Schedule(std::shared_ptr<const Scene> scene)
    : scene_(std::move(scene)), entries_(scene_->robots.size()) {}

void Schedule::set_initial(RobotId robot, Trajectory path, std::string solver,
                           std::uint64_t number) {
  Entry& entry = entries_[robot.index()];
  entry.coupling = {{0, path.end_time(), {robot}, std::move(solver), number}};
  entry.path = std::move(path);
  ++entry.version;
}

bool Schedule::commit(const Subproblem& subproblem, const Resolution& resolution,
                      std::uint64_t number) {
  if (form_fault(*scene_, subproblem, resolution)) return false;
  for (const Task& task : subproblem.tasks) {
    if (version(task.robot) != task.version) return false;
  }
  const auto goes_on_as_before = [&](std::size_t i) {
    return resolution.paths[i] == subproblem.tasks[i].guide;
  };
  std::vector<RobotId> robots;
  for (std::size_t i = 0; i < subproblem.tasks.size(); ++i) {
    if (!goes_on_as_before(i)) robots.push_back(subproblem.tasks[i].robot);
  }
  for (std::size_t i = 0; i < subproblem.tasks.size(); ++i) {
    if (goes_on_as_before(i)) continue;
    const Task& task = subproblem.tasks[i];
    Entry& entry = entries_[task.robot.index()];
    const double arrival = resolution.paths[i].end_time();
    std::vector<CouplingSegment> coupling;
    copy_clipped(entry.coupling, 0, subproblem.from, 0, coupling);
    if (coupling.empty() && subproblem.from > 0) coupling.push_back(entry.coupling.front());
    coupling.push_back({subproblem.from, arrival, robots, resolution.solver, number});
    copy_clipped(entry.coupling, task.to, std::numeric_limits<double>::infinity(),
                 arrival - task.to, coupling);
    splice(entry, subproblem, task, resolution.paths[i]);
    entry.coupling = std::move(coupling);
    close_gaps(entry.path.end_time(), entry.coupling);
    ++entry.version;
  }
  return true;
}

void Schedule::splice(Entry& entry, const Subproblem& subproblem, const Task& task,
                      const Trajectory& local) const {
  const Trajectory& old = entry.path;
  Trajectory path(old.dof());
  path.reserve(old.size() + local.size());
  for (std::size_t i = 0; i < old.size() && old.time(i) < subproblem.from - kSameInstant; ++i) {
    path.append(old.time(i), old.configuration(i));
  }
  for (std::size_t i = 0; i < local.size(); ++i) path.append(local.time(i), local.configuration(i));
  append_tail(*scene_->robot(task.robot).model, old, task.to, path);
  entry.path = path.tidied();
}

}  // namespace accord
