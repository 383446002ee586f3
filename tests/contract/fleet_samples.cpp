#include "tests/contract/fleet_samples.h"

#include <algorithm>
#include <cstring>

#include "common/planning/random.h"

namespace accord::fleet_samples {
namespace {

class Bits {
 public:
  void add(const std::string& text) {
    add(text.size());
    out_ += text;
  }
  template <typename Number>
  void add(Number number) {
    const std::size_t end = out_.size();
    out_.resize(end + sizeof(number));
    std::memcpy(out_.data() + end, &number, sizeof(number));
  }
  std::string take() { return std::move(out_); }

 private:
  std::string out_;
};

void add(const RobotPlan& robot, Bits& out) {
  const auto& [name, trajectory, segments] = robot;
  out.add(name);
  out.add(trajectory.dof());
  out.add(trajectory.size());
  for (const double time : trajectory.times()) out.add(time);
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    for (const double number : trajectory.configuration(i)) out.add(number);
  }
  out.add(segments.size());
  for (const auto& [from, to, robots, solver] : segments) {
    out.add(from);
    out.add(to);
    out.add(robots.size());
    for (const std::string& other : robots) out.add(other);
    out.add(solver);
  }
}

}  // namespace

std::vector<FleetRequest> requests() {
  PlanRequest request;
  request.id = "order-17/\xc3\xa4";
  request.scene_text = "version: 1\nrobots: []\n";
  request.attachments = {{"meshes/pallet.stl", std::string("solid\0\xff", 7)}, {"empty", ""}};
  request.scene_name = "depot";
  request.queries = {{"agv1", Configuration{0.1, -0.0, 1e-300}, std::nullopt},
                     {"agv2", std::nullopt, Configuration{}},
                     {"agv3", Configuration{1}, Configuration{2}}};
  request.method = "cbs-mp";
  request.seed = 0xfedcba9876543210ULL;
  request.solvers = {"prioritized-query", "decoupled-prm"};
  request.deadline = 2.5;
  request.priority = -3;
  PlanRequest least;
  least.id = "1";
  return {request, least, CancelRequest{request.id}, ResendRequest{request.id}};
}

std::vector<FleetNews> news() {
  RequestState state{"order-17", RequestPhase::kConflicts, 3, 16, 15, 1ULL << 40U, 12, 7, 0.1, 62.5,
                     1e9};
  WorkerStatus worker{0xfedcba9876543210ULL, "h\xc3\xb6st",        4711, "0.1.0", 16, 3,
                      "distrusted",          "its result was none"};
  ServiceStatus service{"0.1.0", "host", 4712, 86400.5, 4, 64, 2, 1, 1ULL << 33U, false};
  return {RequestReply{"order-17", true, Rejection::kNone, {}, {}},
          RequestReply{"order-18", false, Rejection::kBadQuery, "queries[2].goal", "expected 3"},
          state,
          RequestState{},
          worker,
          service};
}

FinishedPlan plan_of(const std::string& id, std::size_t robots, std::size_t waypoints) {
  constexpr std::size_t kDof = 3;
  constexpr std::size_t kCrowd = 30;
  RandomStream random(combine({robots, waypoints}));
  FinishedPlan out{id, {}, nullptr, std::string(64, 'a')};
  Plan& plan = out.plan;
  plan.scene = "fleet";
  plan.status = PlanStatus::kSolved;
  plan.method = "arc";
  plan.seed = 0xfedcba9876543210ULL;
  plan.planning_time = random.uniform();
  plan.statistics = {{"conflicts", 12}, {"verifier_time", random.uniform()}, {"least", -0.0}};
  for (std::size_t i = 0; i < robots; ++i) plan.robots.push_back({"r" + std::to_string(i), {}, {}});
  for (std::size_t i = 0; i < robots; ++i) {
    RobotPlan& robot = plan.robots[i];
    robot.trajectory = Trajectory(kDof);
    double time = 0;
    for (std::size_t w = 0; w < waypoints; ++w) {
      const Configuration q{random.uniform(-50, 50), random.uniform(-50, 50), random.uniform()};
      robot.trajectory.append(time, q);
      time += random.uniform(0.01, 1);
    }
    const double end = robot.trajectory.end_time();
    robot.segments = {{0, end / 3, {robot.name}, "initial"}, {end / 3, end, {}, "crowd"}};
    const std::size_t first = i / kCrowd * kCrowd;
    for (std::size_t other = first; other < std::min(first + kCrowd, robots); ++other) {
      robot.segments.back().robots.push_back(plan.robots[other].name);
    }
  }
  compute_costs(plan);
  return out;
}

std::string bits_of(const Plan& plan) {
  const auto& [scene, status, message, method, seed, timestep, planning_time, makespan,
               sum_of_costs, sum_of_costs_timesteps, robots, statistics] = plan;
  Bits out;
  out.add(scene);
  out.add(status);
  out.add(message);
  out.add(method);
  out.add(seed);
  for (const double number : {timestep, planning_time, makespan, sum_of_costs}) out.add(number);
  out.add(sum_of_costs_timesteps);
  for (const auto& [name, value] : statistics) {
    out.add(name);
    out.add(value);
  }
  for (const RobotPlan& robot : robots) add(robot, out);
  return out.take();
}

}  // namespace accord::fleet_samples
