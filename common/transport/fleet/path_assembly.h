// Puts one robot's path together from the pieces in which it travels, in whatever order and however
// often those come.
// Not thread safe. Memory is bounded: only the pieces of the path that came last are kept.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "common/model/trajectory.h"
#include "common/transport/fleet/plan_parts.h"

namespace accord {

struct RobotPath {
  std::string id;  // of the request
  std::uint32_t version = 1;
  std::string robot;
  Trajectory trajectory;
  std::vector<PathSegment> segments;
};

class PathAssembly {
 public:
  explicit PathAssembly(std::string robot) : robot_(std::move(robot)) {}

  // The path, where this was the piece that it lacked. Requires: fleet_fault() of it is nullopt.
  std::optional<RobotPath> add(PathPiece piece);

  // Pieces of other robots, or that contradicted others.
  std::uint64_t malformed() const { return malformed_; }

 private:
  std::optional<RobotPath> joined();

  std::string robot_;
  std::map<std::uint32_t, PathPiece> pieces_;  // of one path
  std::uint64_t malformed_ = 0;
};

// Appends a piece's waypoints. False: times do not ascend.
bool add_waypoints(const PathPiece& piece, Trajectory& out);

}  // namespace accord
