// How news travels on the public topics: as it is, but for plans. They are of any size, so they go
// as an outline and bounded pieces of the robots' paths. Plain values; the wire's counterparts are
// Plan and RobotPlan of idl/fleet.idl.
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "common/transport/fleet/fleet_messages.h"

namespace accord {

// A plan but for the paths.
struct PlanOutline {
  std::string id;
  std::uint32_t version = 1;  // of this request's plan; a higher one replaces it
  Plan plan;                  // its robots have names only
  std::string content = {};   // FinishedPlan's
};

// As PlanSegment, with robots by their places in the outline: names of a crowd of hundreds, in the
// segments of each of its members, would be most of a plan.
struct PathSegment {
  double from = 0;  // s
  double to = 0;    // s
  std::string solver;
  std::vector<std::uint32_t> robots;

  friend bool operator==(const PathSegment&, const PathSegment&) = default;
};

// Some of a robot's waypoints and segments, which follow those of the piece before.
struct PathPiece {
  std::string id;
  std::uint32_t version = 1;
  std::string robot;
  std::uint32_t robot_index = 0;  // its place in the outline
  std::uint32_t dof = 0;
  std::uint32_t piece = 0;
  std::uint32_t pieces = 1;
  std::vector<double> times;           // s
  std::vector<double> configurations;  // times.size() x dof, row by row
  std::vector<PathSegment> segments;

  friend bool operator==(const PathPiece&, const PathPiece&) = default;
};

using FleetPart =
    std::variant<RequestReply, RequestState, PlanOutline, PathPiece, WorkerStatus, ServiceStatus>;

}  // namespace accord
