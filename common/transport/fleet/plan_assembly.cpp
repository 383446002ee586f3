#include "common/transport/fleet/plan_assembly.h"

#include <algorithm>
#include <utility>

#include "common/transport/fleet/fleet_limits.h"
#include "common/transport/fleet/path_assembly.h"

namespace accord {
namespace {

constexpr std::size_t kOpenPlans = 64;
constexpr std::size_t kRemembered = 4096;    // given plans, and expected ones
constexpr int kAskings = 6;                  // of one plan, with nothing coming in between
constexpr std::size_t kPieceOverhead = 256;  // bytes that a piece takes beside its contents
// One plan of the largest size has room.
constexpr std::size_t kOpenBytes = kPlanWireBytes + limits::kRobots * kPieceOverhead +
                                   kPlanWireBytes / kPathPieceBytes * kPieceOverhead;

std::size_t memory_of(const PathPiece& piece) {
  return kPieceOverhead + content_bytes(piece);
}

std::size_t memory_of(const PlanOutline& outline) {
  std::size_t bytes = kPieceOverhead;
  for (const RobotPlan& robot : outline.plan.robots) bytes += sizeof(robot) + robot.name.size();
  return bytes;
}

// Adds the segments of a piece, robots by their names. False: one is of a robot that is not there.
bool add_segments(const PathPiece& piece, const std::vector<RobotPlan>& robots, RobotPlan& out) {
  for (const PathSegment& segment : piece.segments) {
    PlanSegment& added =
        out.segments.emplace_back(PlanSegment{segment.from, segment.to, {}, segment.solver});
    added.robots.reserve(segment.robots.size());
    for (const std::uint32_t robot : segment.robots) {
      if (robot >= robots.size()) return false;
      added.robots.push_back(robots[robot].name);
    }
  }
  return true;
}

}  // namespace

PlanAssembly::PlanAssembly(Time patience)
    : patience_(patience), given_(kRemembered), expected_(kRemembered) {}

std::optional<FinishedPlan> PlanAssembly::add(PlanOutline outline, Time now) {
  const auto plan = open(outline.id, outline.version, now);
  if (plan == plans_.end()) return std::nullopt;
  // A plan without paths is all here. What else has come is of a service that was killed, where
  // the request would have ended otherwise.
  if (outline.plan.robots.empty()) drop_parts(plan->second);
  if (plan->second.outline) return std::nullopt;
  const std::size_t bytes = memory_of(outline);
  plan->second.outline = std::move(outline);
  return account(plan, bytes) ? finish_if_complete(plan) : std::nullopt;
}

std::optional<FinishedPlan> PlanAssembly::add(PathPiece piece, Time now) {
  const auto plan = open(piece.id, piece.version, now);
  if (plan == plans_.end()) return std::nullopt;
  if (!fits(plan->second, piece)) {
    ++malformed_;
    return std::nullopt;
  }
  Path& path = plan->second.paths[piece.robot_index];
  const std::size_t bytes = memory_of(piece);
  const auto [place, is_new] = path.pieces.try_emplace(piece.piece);
  if (!is_new) return std::nullopt;
  place->second = std::move(piece);
  if (path.complete()) ++plan->second.complete_paths;
  return account(plan, bytes) ? finish_if_complete(plan) : std::nullopt;
}

// The plan that a part belongs to; end() where it is late.
PlanAssembly::Plans::iterator PlanAssembly::open(const std::string& id, std::uint32_t version,
                                                 Time now) {
  if (given_.find(id) >= version) return plans_.end();
  auto plan = plans_.find(id);
  if (plan != plans_.end() && plan->second.version > version) return plans_.end();
  if (plan != plans_.end() && plan->second.version < version) {
    forget(plan);
    plan = plans_.end();
  }
  if (plan == plans_.end()) {
    plan = plans_.try_emplace(id).first;
    plan->second.version = version;
  }
  plan->second.heard = now;
  plan->second.asked = 0;
  return plan;
}

// Whether a piece is of the same path as those of its robot that are here.
bool PlanAssembly::fits(const Open& plan, const PathPiece& piece) const {
  const auto path = plan.paths.find(piece.robot_index);
  if (path == plan.paths.end()) return true;
  const PathPiece& other = path->second.pieces.begin()->second;
  return piece.pieces == other.pieces && piece.dof == other.dof && piece.robot == other.robot;
}

std::optional<FinishedPlan> PlanAssembly::finish_if_complete(Plans::iterator plan) {
  const Open& open = plan->second;
  if (!open.outline || open.complete_paths < open.outline->plan.robots.size()) return std::nullopt;
  Open complete = std::move(plan->second);
  const std::string id = plan->first;
  bytes_ -= complete.bytes;
  plans_.erase(plan);
  const std::uint32_t version = complete.version;
  auto joint = joined(std::move(complete));
  if (joint) {
    given_.add(id, version);
    expected_.erase(id);
  } else {
    ++malformed_;
  }
  return joint;
}

std::optional<FinishedPlan> PlanAssembly::joined(Open open) {
  FinishedPlan out{std::move(open.outline->id), std::move(open.outline->plan), nullptr,
                   std::move(open.outline->content)};
  std::vector<RobotPlan>& robots = out.plan.robots;
  if (open.paths.size() != robots.size()) return std::nullopt;
  for (auto& [place, path] : open.paths) {
    if (place >= robots.size() || !path.complete()) return std::nullopt;
    RobotPlan& robot = robots[place];
    const PathPiece& first = path.pieces.begin()->second;
    if (first.robot != robot.name) return std::nullopt;
    std::size_t waypoints = 0;
    for (const auto& [number, piece] : path.pieces) waypoints += piece.times.size();
    robot.trajectory = Trajectory(first.dof);
    robot.trajectory.reserve(waypoints);
    for (const auto& [number, piece] : path.pieces) {
      if (!add_waypoints(piece, robot.trajectory)) return std::nullopt;
      if (!add_segments(piece, robots, robot)) return std::nullopt;
    }
    path.pieces.clear();  // a plan is not in memory twice
  }
  return out;
}

// ---- Asking again ----

void PlanAssembly::expect(const std::string& id) {
  given_.erase(id);
  expected_.add(id, 0);
}

void PlanAssembly::note_finished(const std::string& id, Time now) {
  if (!expected_.find(id) || plans_.contains(id)) return;
  const auto plan = plans_.try_emplace(id).first;
  plan->second.heard = now;
  account(plan, kPieceOverhead);
}

PlanAssembly::Time PlanAssembly::due(const Open& plan) const {
  // After 1, 1 + 2, 1 + 2 + 4, ... times the patience.
  return plan.heard + patience_ * ((2 << plan.asked) - 1);
}

std::vector<std::string> PlanAssembly::overdue(Time now) {
  std::vector<std::string> out;
  for (auto plan = plans_.begin(); plan != plans_.end();) {
    const auto next = std::next(plan);
    if (due(plan->second) <= now) {
      if (plan->second.asked == kAskings) {
        forget(plan);
      } else {
        ++plan->second.asked;
        out.push_back(plan->first);
      }
    }
    plan = next;
  }
  return out;
}

std::optional<PlanAssembly::Time> PlanAssembly::next_overdue() const {
  std::optional<Time> out;
  for (const auto& [id, plan] : plans_) {
    if (!out || due(plan) < *out) out = due(plan);
  }
  return out;
}

// ---- Bounds ----

// Makes room for what a plan has grown by. False: there is not that much, and it is forgotten.
bool PlanAssembly::account(Plans::iterator grown, std::size_t bytes) {
  grown->second.bytes += bytes;
  bytes_ += bytes;
  if (grown->second.bytes > kOpenBytes) {
    ++malformed_;
    forget(grown);
    return false;
  }
  while (plans_.size() > kOpenPlans || bytes_ > kOpenBytes) {
    auto quietest = plans_.end();
    for (auto plan = plans_.begin(); plan != plans_.end(); ++plan) {
      if (plan == grown) continue;
      if (quietest == plans_.end() || plan->second.heard < quietest->second.heard) quietest = plan;
    }
    forget(quietest);
  }
  return true;
}

void PlanAssembly::drop_parts(Open& plan) {
  bytes_ -= std::exchange(plan.bytes, 0);
  plan.outline.reset();
  plan.paths.clear();
  plan.complete_paths = 0;
}

void PlanAssembly::forget(Plans::iterator plan) {
  bytes_ -= plan->second.bytes;
  plans_.erase(plan);
}

}  // namespace accord
