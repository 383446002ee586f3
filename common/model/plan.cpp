#include "common/model/plan.h"

#include <algorithm>
#include <cmath>

namespace accord {

std::string_view to_string(PlanStatus status) {
  switch (status) {
    case PlanStatus::kSolved:
      return "solved";
    case PlanStatus::kInfeasible:
      return "infeasible";
    case PlanStatus::kTimeout:
      return "timeout";
    case PlanStatus::kCancelled:
      return "cancelled";
    case PlanStatus::kInvalid:
      return "invalid";
  }
  return "invalid";
}

void compute_costs(Plan& plan) {
  // An arrival that is a whole number of timesteps but for rounding counts as that number.
  constexpr double kRounding = 1e-9;  // timesteps
  plan.makespan = plan.sum_of_costs = 0;
  plan.sum_of_costs_timesteps = 0;
  for (const RobotPlan& robot : plan.robots) {
    const double arrival = robot.trajectory.arrival_time();
    plan.makespan = std::max(plan.makespan, arrival);
    plan.sum_of_costs += arrival;
    plan.sum_of_costs_timesteps +=
        static_cast<std::int64_t>(std::ceil(arrival / plan.timestep - kRounding));
  }
}

}  // namespace accord
