#include "common/transport/fleet/plan_pieces.h"

#include <utility>

#include "common/transport/fleet/fleet_limits.h"

namespace accord {
namespace {

// Pieces of one robot's path, each filled until the next waypoint or segment finds no room.
class Cutter {
 public:
  explicit Cutter(PathPiece empty) : empty_(std::move(empty)), pieces_{empty_} {}

  void add(double time, ConfigurationView configuration) {
    PathPiece& piece = with_room_for(waypoint_bytes(configuration.size()));
    piece.times.push_back(time);
    piece.configurations.insert(piece.configurations.end(), configuration.begin(),
                                configuration.end());
  }
  void add(PathSegment segment) {
    with_room_for(segment_bytes(segment.solver.size(), segment.robots.size()))
        .segments.push_back(std::move(segment));
  }

  std::vector<PathPiece> take() {
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      pieces_[i].piece = static_cast<std::uint32_t>(i);
      pieces_[i].pieces = static_cast<std::uint32_t>(pieces_.size());
    }
    return std::move(pieces_);
  }

 private:
  PathPiece& with_room_for(std::size_t bytes) {
    if (filled_ + bytes > kPathPieceBytes) {
      pieces_.push_back(empty_);
      filled_ = 0;
    }
    filled_ += bytes;
    return pieces_.back();
  }

  const PathPiece empty_;
  std::vector<PathPiece> pieces_;
  std::size_t filled_ = 0;  // bytes of the last one
};

}  // namespace

PlanPieces::PlanPieces(const FinishedPlan& finished) : finished_(finished) {
  for (const RobotPlan& robot : finished.plan.robots) {
    places_.emplace(robot.name, static_cast<std::uint32_t>(places_.size()));
  }
}

PlanOutline PlanPieces::outline() const {
  const Plan& plan = finished_.plan;
  const auto& [scene, status, message, method, seed, timestep, planning_time, makespan,
               sum_of_costs, sum_of_costs_timesteps, robots, statistics] = plan;
  PlanOutline out{finished_.id, 1,
                  Plan{scene,
                       status,
                       message,
                       method,
                       seed,
                       timestep,
                       planning_time,
                       makespan,
                       sum_of_costs,
                       sum_of_costs_timesteps,
                       {},
                       statistics},
                  finished_.content};
  for (const RobotPlan& robot : robots) out.plan.robots.push_back({robot.name, {}, {}});
  return out;
}

std::vector<PathPiece> PlanPieces::of_robot(std::size_t robot) const {
  const auto& [name, trajectory, segments] = finished_.plan.robots[robot];
  PathPiece empty;
  empty.id = finished_.id;
  empty.robot = name;
  empty.robot_index = static_cast<std::uint32_t>(robot);
  empty.dof = static_cast<std::uint32_t>(trajectory.dof());
  Cutter cutter(std::move(empty));
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    cutter.add(trajectory.time(i), trajectory.configuration(i));
  }
  for (const PlanSegment& segment : segments) cutter.add(travelling(segment));
  return cutter.take();
}

PathSegment PlanPieces::travelling(const PlanSegment& segment) const {
  const auto& [from, to, robots, solver] = segment;
  PathSegment out{from, to, solver, {}};
  for (const std::string& name : robots) out.robots.push_back(places_.at(name));
  return out;
}

}  // namespace accord
