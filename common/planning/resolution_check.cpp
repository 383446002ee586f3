#include "common/planning/resolution_check.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "common/planning/meetings.h"
#include "common/planning/resolution_form.h"
#include "common/planning/verifier_words.h"

namespace accord {
namespace {

using verification::quoted;
using verification::seconds;

constexpr double kSpeedTolerance = 1e-6;  // relative; the verifier's

std::string name_of(const CollisionWorld& world, RobotId robot) {
  return quoted(world.scene().robot(robot).name);
}

std::string fault_text(const std::optional<Fault>& fault) {
  if (!fault) return "comes too close to something";
  switch (fault->kind) {
    case Fault::Kind::kLimit:
      return "leaves its limits";
    case Fault::Kind::kBounds:
      return "leaves the scene's bounds";
    case Fault::Kind::kSelf:
      return "comes too close to itself";
    case Fault::Kind::kObstacle:
    case Fault::Kind::kRobot:
      break;
  }
  return "comes too close to " + quoted(fault->other);
}

// A motion that cannot be proved free, in words. The proof ends a little before the fault: looks
// for it ever further on.
std::string motion_text(const CollisionWorld& world, RobotId robot, const Trajectory& path,
                        std::size_t from, std::size_t to) {
  const double u =
      world.first_fault(robot, path.configuration(from), path.configuration(to)).value_or(0.0);
  const double span = path.time(to) - path.time(from), time = path.time(from) + u * span;
  std::optional<Fault> fault;
  for (double share = 1e-9; !fault && share < 2; share *= 2) {
    fault = world.fault(robot, path.at(std::min(time + share * span, path.time(to))));
  }
  return name_of(world, robot) + " " + fault_text(fault) + " at " + seconds(time);
}

bool is_too_fast(const RobotModel& model, const Trajectory& path, std::size_t from,
                 Configuration& delta) {
  const ConfigurationView a = path.configuration(from), b = path.configuration(from + 1);
  delta.resize(a.size());
  for (std::size_t k = 0; k < delta.size(); ++k) delta[k] = b[k] - a[k];
  // What the rounding of the two times themselves may hide.
  const double rounding = 2 * std::numeric_limits<double>::epsilon() * path.time(from + 1);
  const double duration = path.time(from + 1) - path.time(from);
  return !(least_duration(model, delta) <= duration * (1 + kSpeedTolerance) + rounding);
}

// What is wrong with a robot's path even if it were alone.
std::optional<std::string> lone_fault(const CollisionWorld& world, RobotId robot,
                                      const Trajectory& path) {
  const RobotModel& model = *world.scene().robot(robot).model;
  Configuration delta;
  for (std::size_t k = 0; k + 1 < path.size(); ++k) {
    if (!is_too_fast(model, path, k, delta)) continue;
    return name_of(world, robot) + " would have to move faster than it can at " +
           seconds(path.time(k));
  }
  for (std::size_t k = 0; k == 0 || k + 1 < path.size(); ++k) {
    const std::size_t next = std::min(k + 1, path.size() - 1);
    if (!world.motion_is_free(robot, path.configuration(k), path.configuration(next))) {
      return motion_text(world, robot, path, k, next);
    }
  }
  return std::nullopt;
}

// Who has to keep clear of whom, and for how long.
class Promises {
 public:
  Promises(const Subproblem& subproblem, const Resolution& resolution)
      : subproblem_(subproblem), resolution_(resolution) {}

  std::vector<Mover> movers() const {
    std::vector<Mover> movers;
    const double arrival = last_arrival();
    for (std::size_t i = 0; i < subproblem_.tasks.size(); ++i) {
      const RobotId robot = subproblem_.tasks[i].robot;
      const double until = is_left(robot) ? arrival : in_window(i);
      if (is_left(robot) && !resolution_.solved) continue;
      movers.push_back({robot, &resolution_.paths[i], until, true});
    }
    if (subproblem_.lockstep) return movers;  // which looks out for nobody else
    for (const Outsider& outsider : subproblem_.outsiders) {
      movers.push_back({outsider.robot, &outsider.path, outsider.until, false});
    }
    return movers;
  }

 private:
  bool is_left(RobotId robot) const {
    return std::ranges::find(resolution_.left, robot) != resolution_.left.end();
  }

  // Of those that are not left.
  double last_arrival() const {
    double last = subproblem_.from;
    for (std::size_t i = 0; i < subproblem_.tasks.size(); ++i) {
      if (is_left(subproblem_.tasks[i].robot)) continue;
      last = std::max(last, resolution_.paths[i].end_time());
    }
    return last;
  }

  double in_window(std::size_t i) const {
    const double arrival = resolution_.paths[i].end_time();
    const double rest = subproblem_.tasks[i].goes_on() ? arrival : subproblem_.horizon;
    return std::min(std::max(arrival, rest), subproblem_.clear_until);
  }

  const Subproblem& subproblem_;
  const Resolution& resolution_;
};

}  // namespace

std::optional<std::string> resolution_fault(const CollisionWorld& world,
                                            const Subproblem& subproblem,
                                            const Resolution& resolution) {
  if (!resolution.solved && !resolution.improves()) return std::nullopt;
  if (auto fault = form_fault(world.scene(), subproblem, resolution)) return fault;
  for (std::size_t i = 0; i < resolution.paths.size(); ++i) {
    const Task& task = subproblem.tasks[i];
    if (resolution.paths[i] == task.guide) continue;
    if (auto fault = lone_fault(world, task.robot, resolution.paths[i])) return fault;
  }
  const std::vector<Mover> movers = Promises(subproblem, resolution).movers();
  const auto meeting = find_meeting(world, movers, subproblem.from);
  if (!meeting) return std::nullopt;
  return name_of(world, movers[meeting->first].robot) + " and " +
         name_of(world, movers[meeting->second].robot) + " come too close to each other at " +
         seconds(meeting->time);
}

}  // namespace accord
