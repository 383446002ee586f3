#include "coordinator/subproblem_factory.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>

#include "common/planning/random.h"
#include "common/planning/region.h"
#include "common/planning/splice.h"

namespace accord {
namespace {

// Half of the first window, in robots' own times: room to step aside and come back.
constexpr double kWindow = 3.0;
// What an arm's joint moves in its "own time".
constexpr double kArmOwnMotion = 0.5;  // rad or m
// The first region reaches this many body sizes beyond the guide.
constexpr double kRegionMargin = 2.0;
constexpr double kArmRegionMargin = 0.6;  // rad or m
// Outsiders are avoided until this many half windows after the conflict. Their paths that far ahead
// are going to change; in dense traffic a subproblem that respects all of them for long has no
// solution where one that looks ahead a little has.
constexpr double kForesight = 2.0;
constexpr double kShortForesight = 0.4;
// Half windows' counterpart for crowds, in robots' own times: where the window begins before the
// conflict, how long everyone is avoided, and how much later goals are to be reached.
constexpr double kCrowdHindsight = 3.0;
constexpr double kCrowdForesight = 14.0;
constexpr double kCrowdRoom = 12.0;
// Cutting closer to a waypoint than this would leave a sliver of a motion.
constexpr double kSliver = 1e-5;  // s
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// t, or a little later: where every given path has a waypoint exactly there or none nearby.
double away_from_slivers(double t, const std::vector<RobotId>& robots, const Schedule& schedule) {
  for (int tries = 0; tries < 64; ++tries) {
    const bool clear = std::ranges::all_of(robots, [&](RobotId robot) {
      const auto& times = schedule.path(robot).times();
      const auto near = std::ranges::lower_bound(times, t - kSliver);
      return near == times.end() || *near > t + kSliver || *near == t;
    });
    if (clear) break;
    t += 2.5 * kSliver;
  }
  return t;
}

// The segments of a path that reach into [from, until] (s). Where it is cut off at its end, it goes
// on beyond `until`: it does not seem to park.
Trajectory clipped(const Trajectory& path, double from, double until) {
  Trajectory out(path.dof());
  for (std::size_t i = path.segment_at(from); i < path.size(); ++i) {
    out.append(path.time(i), path.configuration(i));
    if (path.time(i) > until) break;
  }
  return out;
}

}  // namespace

void SubproblemFactory::use_roadmap(RobotId robot, int level) {
  int& known =
      roadmap_levels_.try_emplace(world_.scene().robot(robot).model.get(), -1).first->second;
  known = std::max(known, level);
}

bool SubproblemFactory::uses_roadmap(RobotId robot) const {
  return roadmap_level(robot) >= 0;
}

int SubproblemFactory::roadmap_level(RobotId robot) const {
  const auto found = roadmap_levels_.find(world_.scene().robot(robot).model.get());
  return found == roadmap_levels_.end() ? -1 : found->second;
}

bool SubproblemFactory::is_mobile(RobotId robot) const {
  return world_.scene().robot(robot).model->translations() > 0;
}

bool SubproblemFactory::can_move_in_lockstep(RobotId a, RobotId b) const {
  return world_.radius(a) && world_.radius(b) &&
         world_.scene().robot(a).model->dof() == world_.scene().robot(b).model->dof();
}

double SubproblemFactory::body_size(RobotId id) const {
  if (const auto radius = world_.radius(id)) return 2 * *radius;
  const Robot& robot = world_.scene().robot(id);
  const Aabb box = world_.swept_bounds(id, robot.start, robot.start);
  return (box.max - box.min).norm();
}

double SubproblemFactory::own_time(RobotId id) const {
  const RobotModel& model = *world_.scene().robot(id).model;
  if (model.translations() > 0) return body_size(id) / model.speed;
  double longest = 0;
  for (const DegreeOfFreedom& dof : model.dofs) {
    longest = std::max(longest, kArmOwnMotion / dof.velocity);
  }
  return longest;
}

SubproblemFactory::Window SubproblemFactory::window(const Conflict& conflict,
                                                    const Growth& growth) const {
  double unit = std::max(own_time(conflict.first), own_time(conflict.second));
  if (!growth.crowd) {
    for (const RobotId robot : growth.taken_in) unit = std::max(unit, own_time(robot));
  }
  unit *= std::ldexp(1.0, static_cast<int>(growth.window));
  Window out;
  if (growth.crowd) {
    out.from = conflict.time - kCrowdHindsight * unit;
    out.horizon = std::max(out.from, 0.0) + kCrowdForesight * unit;
    out.to = out.horizon + kCrowdRoom * unit;
  } else {
    const double half = kWindow * unit;
    out.from = conflict.time - half;
    out.to = conflict.time + half;
    out.horizon = conflict.time + (growth.shortsighted ? kShortForesight : kForesight) * half;
  }
  if (out.from <= 0) out.from = 0;
  return out;
}

Subproblem SubproblemFactory::create_initial(RobotId id) const {
  const Robot& robot = world_.scene().robot(id);
  Subproblem out;
  out.seed = combine({seed_, id.value});
  out.horizon = kInfinity;
  out.whole = true;
  out.tasks.push_back(
      {id, 0, robot.start, 0, robot.goal, whole_region(world_.scene(), id), {}, {}, -1});
  return out;
}

Subproblem SubproblemFactory::create_whole(const Schedule& schedule) const {
  Subproblem out;
  out.seed = combine({seed_, schedule.size()});
  out.horizon = kInfinity;
  out.whole = true;
  out.limits = SolverLimits::unlimited();
  for (std::uint32_t id = 0; id < schedule.size(); ++id) {
    const Trajectory& path = schedule.path({id});
    Trajectory tail(path.dof());
    tail.append(path.end_time(), path.configuration(path.size() - 1));
    out.tasks.push_back({{id},
                         schedule.version({id}),
                         path.at(0),
                         path.end_time(),
                         path.at(path.end_time()),
                         whole_region(world_.scene(), {id}),
                         path,
                         std::move(tail),
                         std::max(roadmap_level({id}), 0)});
    out.to = std::max(out.to, path.end_time());
  }
  return out;
}

Subproblem SubproblemFactory::create(const Conflict& conflict, const Growth& growth,
                                     const Schedule& schedule, const ConflictBoard& board) const {
  std::set<RobotId> members = growth.taken_in;
  members.insert({conflict.first, conflict.second});
  Subproblem out;
  out.seed = combine({seed_, conflict.first.value, conflict.second.value,
                      std::bit_cast<std::uint64_t>(conflict.time), growth.attempts});
  cut(conflict, growth, schedule, board, members, out);
  if (growth.crowd) {
    // Those who stand by may have to make way.
    members.merge(robots_near(out, board));
    if (growth.lockstep) {
      std::erase_if(members,
                    [&](RobotId robot) { return !can_move_in_lockstep(robot, conflict.first); });
    }
    cut(conflict, growth, schedule, board, members, out);
  }
  if (growth.lockstep) return out;
  // Until the last try the solvers are not to go to their own limits, but to begin anew.
  out.limits.decoupled_samples <<= growth.retries;
  if (growth.retries < Growth::kRetries) out.limits.last_factor = 1;
  add_outsiders(schedule, board, growth.to_the_end, growth.shortsighted, out);
  return out;
}

void SubproblemFactory::cut(const Conflict& conflict, const Growth& growth,
                            const Schedule& schedule, const ConflictBoard& board,
                            const std::set<RobotId>& members, Subproblem& out) const {
  const std::vector<RobotId> robots(members.begin(), members.end());
  set_window(conflict, growth, schedule, robots, out);
  out.tasks.clear();
  for (const RobotId robot : robots) {
    out.tasks.push_back(make_task(robot, growth, schedule, board, out));
  }
  for (const Task& task : out.tasks) out.to = std::max(out.to, task.to);
}

void SubproblemFactory::set_window(const Conflict& conflict, const Growth& growth,
                                   const Schedule& schedule, const std::vector<RobotId>& robots,
                                   Subproblem& out) const {
  double unit = 0, end = 0;
  for (const RobotId robot : robots) {
    unit = std::max(unit, own_time(robot));
    end = std::max(end, schedule.path(robot).end_time());
  }
  const Window window = this->window(conflict, growth);
  end = std::max(end, conflict.time + 0.1 * unit);
  out.from = window.from == 0 ? 0 : away_from_slivers(window.from, robots, schedule);
  if (out.from >= conflict.time) out.from = 0;
  out.to = growth.to_the_end ? end : std::min(window.to, end);
  out.horizon = window.horizon;
  if (growth.crowd && !growth.lockstep) out.clear_until = out.horizon;
  if (growth.lockstep) out.horizon = kInfinity;
  out.lockstep = growth.lockstep;
  out.whole = out.from == 0 && out.to >= end;
}

// The end of a robot's part of the window: moves outwards along its path, past configurations that
// are themselves in conflict.
double SubproblemFactory::clear_end(RobotId robot, double from, double to, const Schedule& schedule,
                                    const ConflictBoard& board) const {
  const Trajectory& path = schedule.path(robot);
  const auto is_clear_at = [&](double t) {
    const Configuration q = path.at(t);
    std::vector<RobotId> near;
    board.grid().within(world_.swept_bounds(robot, q, q), t, t, near);
    return std::ranges::all_of(near, [&](RobotId other) {
      return other == robot || world_.are_clear(robot, q, other, schedule.path(other).at(t));
    });
  };
  // Two robots side by side may be in conflict for ever.
  constexpr double kMost = 2.0;
  const double end = std::min(path.end_time(), from + kMost * (to - from));
  const double step = 0.5 * own_time(robot);
  while (to < end && !is_clear_at(to)) to = std::min(to + step, end);
  return to < path.end_time() ? away_from_slivers(to, {robot}, schedule) : to;
}

Task SubproblemFactory::make_task(RobotId robot, const Growth& growth, const Schedule& schedule,
                                  const ConflictBoard& board, const Subproblem& window) const {
  const Trajectory& path = schedule.path(robot);
  Task task;
  task.robot = robot;
  task.version = schedule.version(robot);
  task.start = path.at(window.from);
  task.to = clear_end(robot, window.from, window.to, schedule, board);
  task.goal = path.at(task.to);
  task.guide = Trajectory(path.dof());
  task.guide.append(window.from, task.start);
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (path.time(i) > window.from && path.time(i) < task.to) {
      task.guide.append(path.time(i), path.configuration(i));
    }
  }
  if (task.to > window.from) task.guide.append(task.to, task.goal);
  task.tail = Trajectory(path.dof());
  task.tail.append(task.to, task.goal);
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (path.time(i) > task.to + kSameInstant) {
      task.tail.append(path.time(i), path.configuration(i));
      if (path.time(i) > window.horizon) break;
    }
  }
  task.region = window.whole || growth.to_the_end ? whole_region(world_.scene(), robot)
                                                  : region(robot, task.guide, growth.window);
  task.roadmap_level = roadmap_level(robot);
  return task;
}

Region SubproblemFactory::region(RobotId id, const Trajectory& guide, unsigned doublings) const {
  const RobotModel& model = *world_.scene().robot(id).model;
  const Region whole = whole_region(world_.scene(), id);
  const double scale = std::ldexp(1.0, static_cast<int>(doublings));
  Region out{guide.at(guide.start_time()), guide.at(guide.start_time())};
  for (std::size_t k = 0; k < model.dof(); ++k) {
    for (std::size_t i = 0; i < guide.size(); ++i) {
      out.lower[k] = std::min(out.lower[k], guide.configuration(i)[k]);
      out.upper[k] = std::max(out.upper[k], guide.configuration(i)[k]);
    }
    const bool translation = k < model.translations();
    const double margin = scale * (translation ? kRegionMargin * body_size(id) : kArmRegionMargin);
    out.lower[k] -= margin;
    out.upper[k] += margin;
    if (model.dofs[k].wraps) continue;
    out.lower[k] = std::max(out.lower[k], whole.lower[k]);
    out.upper[k] = std::min(out.upper[k], whole.upper[k]);
  }
  return out;
}

Aabb SubproblemFactory::workspace(RobotId id, const Region& region) const {
  const Robot& robot = world_.scene().robot(id);
  Aabb box{Vec3::Zero(), Vec3::Zero()};
  if (robot.model->translations() > 0) {
    for (std::size_t k = 0; k < robot.model->translations(); ++k) {
      const auto axis = static_cast<Eigen::Index>(k);
      box.min[axis] = region.lower[k];
      box.max[axis] = region.upper[k];
    }
    const Vec3 room = Vec3::Constant(0.5 * body_size(id));
    return {box.min - room, box.max + room};
  }
  double reach = 0;
  for (const double r : world_.reach(id)) reach = std::max(reach, r);
  for (const Joint& joint : robot.model->joints) {
    if (joint.parent == 0) reach += joint.origin.translation().norm();
  }
  const Vec3 base = robot.base.translation();
  box = world_.swept_bounds(id, robot.start, robot.start);
  box.merge({base - Vec3::Constant(reach), base + Vec3::Constant(reach)});
  return box;
}

std::set<RobotId> SubproblemFactory::robots_near(const Subproblem& subproblem,
                                                 const ConflictBoard& board) const {
  std::set<RobotId> near;
  std::vector<RobotId> found;
  std::optional<Aabb> last;
  for (const Task& task : subproblem.tasks) {
    const Aabb box = workspace(task.robot, task.region);
    // Where the regions are the whole space, they are one after the other the same.
    if (last && last->min == box.min && last->max == box.max) continue;
    last = box;
    board.grid().within(box, subproblem.from, subproblem.horizon, found);
    near.insert(found.begin(), found.end());
  }
  for (const Task& task : subproblem.tasks) near.erase(task.robot);
  return near;
}

void SubproblemFactory::add_outsiders(const Schedule& schedule, const ConflictBoard& board,
                                      bool settled_only, bool shortsighted, Subproblem& out) const {
  std::set<RobotId> near = robots_near(out, board);
  if (settled_only) {
    for (const Conflict& conflict : board.conflicts()) {
      if (conflict.time > out.horizon) break;
      near.erase(conflict.first);
      near.erase(conflict.second);
    }
  }
  std::map<RobotId, double> first_conflicts;
  if (shortsighted) {
    for (const Conflict& conflict : board.conflicts()) {
      first_conflicts.try_emplace(conflict.first, conflict.time);
      first_conflicts.try_emplace(conflict.second, conflict.time);
    }
  }
  for (const RobotId robot : near) {
    const auto own = first_conflicts.find(robot);
    double until = own == first_conflicts.end() ? out.horizon : std::min(out.horizon, own->second);
    // Waiting for a parked robot to vanish must not seem a way past it. A crowd that finds no other
    // asks it to move when it comes there.
    if (!(out.is_crowd() && shortsighted) && schedule.path(robot).end_time() <= until)
      until = kInfinity;
    out.outsiders.push_back(
        {robot, schedule.version(robot), clipped(schedule.path(robot), out.from, until), until});
  }
}

}  // namespace accord
