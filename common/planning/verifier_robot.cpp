#include "common/planning/verifier_robot.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "common/planning/verifier_words.h"

namespace accord::verification {
namespace {

constexpr double kStartTolerance = 1e-9;  // m or rad, each degree of freedom
constexpr double kGoalTolerance = 1e-6;
constexpr double kLimitTolerance = 1e-9;
constexpr double kSpeedTolerance = 1e-6;  // relative

// One linear stretch of a robot's path, between the waypoints index and index + 1; from == to where
// the path has one waypoint only.
struct Segment {
  const Robot& robot;
  RobotId id;
  ConfigurationView from;
  ConfigurationView to;
  double t0;
  double t1;

  double time(double fraction) const { return t0 + fraction * (t1 - t0); }
  void at(double fraction, Configuration& q) const {
    q.resize(from.size());
    for (std::size_t k = 0; k < q.size(); ++k) q[k] = from[k] + fraction * (to[k] - from[k]);
  }
};

Segment segment(const Subject& subject, RobotId id, std::size_t index) {
  const Trajectory& path = subject.path(id);
  const std::size_t next = std::min(index + 1, path.size() - 1);
  return {subject.robot(id),         id,
          path.configuration(index), path.configuration(next),
          path.time(index),          path.time(next)};
}

// The degree of freedom of q that is furthest from where it should be, and how far.
struct Deviation {
  std::size_t dof = 0;
  double amount = 0;
};
Deviation deviation(const RobotModel& model, ConfigurationView q, ConfigurationView wanted,
                    bool wrap) {
  Deviation worst;
  for (std::size_t k = 0; k < q.size(); ++k) {
    double amount = q[k] - wanted[k];
    if (wrap && model.dofs[k].wraps) amount = std::remainder(amount, 2 * std::numbers::pi);
    if (std::abs(amount) > std::abs(worst.amount)) worst = {k, amount};
  }
  return worst;
}

std::optional<Violation> check_end(const Subject& subject, RobotId id, Violation::Kind kind) {
  const Robot& robot = subject.robot(id);
  const Trajectory& path = subject.path(id);
  const bool start = kind == Violation::Kind::kStart;
  const std::size_t index = start ? 0 : path.size() - 1;
  const ConfigurationView q = path.configuration(index);
  const Deviation off = deviation(*robot.model, q, start ? robot.start : robot.goal, !start);
  if (std::abs(off.amount) <= (start ? kStartTolerance : kGoalTolerance)) return std::nullopt;

  const Vec3 where = place_of(robot, q);
  std::string text = quoted(robot.name);
  text += start ? " does not begin at its start: " : " does not end at its goal: ";
  text += robot.model->dofs[off.dof].name + " is off by " + number(off.amount) + " at " +
          seconds(path.time(index)) + " near " + place(subject.scene, where);
  return Violation{kind,  {robot.name},         path.time(index),
                   where, std::abs(off.amount), std::move(text)};
}

// The earliest instant of the segment at which a degree of freedom is out of its bounds.
std::optional<Violation> check_limits(const Segment& s) {
  double earliest = std::numeric_limits<double>::infinity();
  std::size_t dof = 0;
  double excess = 0;
  for (std::size_t k = 0; k < s.from.size(); ++k) {
    const DegreeOfFreedom& limits = s.robot.model->dofs[k];
    const auto outside = [&](double q) { return std::max(limits.lower - q, q - limits.upper); };
    const double before = outside(s.from[k]);
    const double after = outside(s.to[k]);
    if (std::max(before, after) <= kLimitTolerance) continue;
    const double bound = s.to[k] > limits.upper ? limits.upper : limits.lower;
    const double fraction =
        before > kLimitTolerance ? 0 : (bound - s.from[k]) / (s.to[k] - s.from[k]);
    if (s.time(fraction) >= earliest) continue;
    earliest = s.time(fraction);
    dof = k;
    excess = std::max(before, after);
  }
  if (excess <= 0) return std::nullopt;
  const DegreeOfFreedom& limits = s.robot.model->dofs[dof];
  return Violation{Violation::Kind::kLimit,
                   {s.robot.name},
                   earliest,
                   place_of(s.robot, s.from),
                   excess,
                   quoted(s.robot.name) + " moves " + quoted(limits.name) + " " + number(excess) +
                       " beyond its limits [" + number(limits.lower) + ", " + number(limits.upper) +
                       "] from " + seconds(earliest) + " on"};
}

Violation too_fast(const Subject& subject, const Segment& s, const std::string& what, double speed,
                   double limit) {
  const Vec3 where = place_of(s.robot, s.from);
  return {Violation::Kind::kSpeed,
          {s.robot.name},
          s.t0,
          where,
          speed - limit,
          quoted(s.robot.name) + " moves" + what + " at " + number(speed) + ", its limit is " +
              number(limit) + ", from " + seconds(s.t0) + " to " + seconds(s.t1) + " near " +
              place(subject.scene, where)};
}

std::optional<Violation> check_speeds(const Subject& subject, const Segment& s) {
  const RobotModel& model = *s.robot.model;
  // What the rounding of the two times themselves may hide.
  const double rounding = 2 * std::numeric_limits<double>::epsilon() * s.t1;
  const double allowed = (s.t1 - s.t0) * (1 + kSpeedTolerance) + rounding;
  double squared = 0;
  for (std::size_t k = 0; k < model.translations(); ++k) {
    squared += (s.to[k] - s.from[k]) * (s.to[k] - s.from[k]);
  }
  const double length = std::sqrt(squared);
  if (length > model.speed * allowed) {
    return too_fast(subject, s, "", length / (s.t1 - s.t0), model.speed);
  }
  for (std::size_t k = model.translations(); k < model.dof(); ++k) {
    const double change = std::abs(s.to[k] - s.from[k]);
    const DegreeOfFreedom& limits = model.dofs[k];
    if (change > limits.velocity * allowed) {
      return too_fast(subject, s, " " + quoted(limits.name), change / (s.t1 - s.t0),
                      limits.velocity);
    }
  }
  return std::nullopt;
}

// The fault behind an unproved motion: the worst from `fraction` on for as long as the robot is in
// contact with the same thing. Looks at instants ever further apart, so that it finds thin things
// close by and still ends soon.
std::optional<Fault> worst_fault(const Subject& subject, const Segment& s, double fraction) {
  std::optional<Fault> worst;
  Configuration q;
  double step = 1e-9;
  for (double u = fraction;; u = std::min(1.0, u + step), step *= 1.3) {
    s.at(u, q);
    const std::optional<Fault> fault = subject.world.fault(s.id, q);
    if (!worst) {
      worst = fault;
    } else if (!fault || fault->kind != worst->kind || fault->other != worst->other) {
      break;
    } else if (fault->gap < worst->gap) {
      worst = fault;
    }
    if (u >= 1) break;
  }
  return worst;
}

std::string fault_text(const Subject& subject, const Segment& s, const Fault& fault, double time) {
  const std::string who = quoted(s.robot.name);
  const std::string when_and_where =
      " at " + seconds(time) + " near " + place(subject.scene, fault.where);
  switch (fault.kind) {
    case Fault::Kind::kLimit:
      return who + " moves " + quoted(fault.body) + " beyond its limits by " + number(-fault.gap) +
             when_and_where;
    case Fault::Kind::kBounds:
      return who + " leaves the scene's bounds by " + metres(-fault.gap) + when_and_where;
    case Fault::Kind::kSelf:
      return who + " collides with itself" + when_and_where + ": " + quoted(fault.body) + " and " +
             quoted(fault.other) + " " + closeness(fault.gap, 0);
    case Fault::Kind::kObstacle:
    case Fault::Kind::kRobot:
      break;
  }
  return who + " collides with obstacle " + quoted(fault.other) + when_and_where + ": they " +
         closeness(fault.gap, subject.scene.clearance);
}

Violation::Kind violation_kind(Fault::Kind kind) {
  switch (kind) {
    case Fault::Kind::kLimit:
      return Violation::Kind::kLimit;
    case Fault::Kind::kBounds:
      return Violation::Kind::kBounds;
    case Fault::Kind::kSelf:
      return Violation::Kind::kSelf;
    case Fault::Kind::kObstacle:
    case Fault::Kind::kRobot:
      break;
  }
  return Violation::Kind::kObstacle;
}

std::optional<Violation> check_motion(const Subject& subject, const Segment& s) {
  const std::optional<double> fraction = subject.world.first_fault(s.id, s.from, s.to);
  if (!fraction) return std::nullopt;
  const double time = s.time(*fraction);
  if (const std::optional<Fault> fault = worst_fault(subject, s, *fraction)) {
    return Violation{
        violation_kind(fault->kind),         {s.robot.name}, time, fault->where, fault->gap,
        fault_text(subject, s, *fault, time)};
  }
  Configuration q;
  s.at(*fraction, q);
  const Vec3 where = place_of(s.robot, q);
  return Violation{Violation::Kind::kObstacle,
                   {s.robot.name},
                   time,
                   where,
                   subject.scene.clearance,
                   quoted(s.robot.name) + " passes too close to something to be proved free at " +
                       seconds(time) + " near " + place(subject.scene, where)};
}

const std::optional<Violation>& earlier(const std::optional<Violation>& a,
                                        const std::optional<Violation>& b) {
  if (!a) return b;
  return b && b->time < a->time ? b : a;
}

}  // namespace

std::optional<Violation> check_robot(const Subject& subject, RobotId id) {
  if (auto violation = check_end(subject, id, Violation::Kind::kStart)) return violation;
  const std::size_t waypoints = subject.path(id).size();
  for (std::size_t i = 0; i == 0 || i + 1 < waypoints; ++i) {
    const Segment s = segment(subject, id, i);
    const std::optional<Violation> limits = check_limits(s);
    const std::optional<Violation> speeds = check_speeds(subject, s);
    const std::optional<Violation> motion = check_motion(subject, s);
    if (const auto& first = earlier(earlier(limits, speeds), motion)) return first;
  }
  return check_end(subject, id, Violation::Kind::kGoal);
}

}  // namespace accord::verification
