// The answer to a request: a timed path per robot, or why there is none. What plan files carry
// (formats.md). A plain value.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "common/model/trajectory.h"

namespace accord {

// Numbers are part of the public topics (idl/fleet.idl): they never change their meaning.
enum class PlanStatus : std::uint8_t {
  kSolved = 0,
  kInfeasible = 1,
  kTimeout = 2,
  kCancelled = 3,
  kInvalid = 4,
};
std::string_view to_string(PlanStatus status);

// In which composition of robots, and by which solver, a stretch of a path was planned.
struct PlanSegment {
  double from;                      // s
  double to;                        // s
  std::vector<std::string> robots;  // sorted as in the scene; holds the robot itself
  std::string solver;
};

struct RobotPlan {
  std::string name;
  Trajectory trajectory;              // starts at t = 0
  std::vector<PlanSegment> segments;  // without gaps, from 0 to the trajectory's end
};

struct Plan {
  std::string scene;
  PlanStatus status = PlanStatus::kInvalid;
  std::string message;  // why, for every status but solved
  std::string method = "arc";
  std::uint64_t seed = 1;
  double timestep = 0.1;     // s
  double planning_time = 0;  // s, wall clock
  double makespan = 0;       // s
  double sum_of_costs = 0;   // s
  std::int64_t sum_of_costs_timesteps = 0;
  std::vector<RobotPlan> robots;  // in the scene's order; empty unless solved
  // Counts and times of the run. Names that end in "_time" are wall-clock seconds; everything else
  // is the same for the same request.
  std::vector<std::pair<std::string, double>> statistics;
};

// Fills makespan, sum_of_costs and sum_of_costs_timesteps from the robots' paths.
void compute_costs(Plan& plan);

}  // namespace accord
