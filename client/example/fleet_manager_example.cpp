// A small fleet manager: has a scene planned by a service, and drives simulated robots along the
// plan.
//
//   fleet_manager_example SCENE [SPEED]
//
// Where the service is, environment variables say (docs/operations.md), as in ACCORD_DDS_DOMAIN=3.
// SPEED: of the simulation, 1 is real time. Ctrl-C cancels the request, or halts the robots.
// Exit code 0: all robots are where they are to be.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "client/fleet/fleet_manager.h"
#include "client/fleet/request_file.h"
#include "common/io/words.h"
#include "common/runtime/configuration.h"
#include "common/transport/dds_settings.h"
#include "common/transport/fleet/dds_fleet.h"

namespace {

using namespace accord;
using Clock = std::chrono::steady_clock;

constexpr std::size_t kTextBytes = 1000;  // of what is printed of a text
constexpr double kTick = 0.1;  // s of the plan's time, from one command to the robots to the next

std::atomic<bool> interrupted{false};
static_assert(std::atomic<bool>::is_always_lock_free, "or a signal handler must not touch it");

// The stand-in for a real robot: it is where it was told to be last.
struct SimulatedRobot {
  std::string name;
  Configuration at;
};

void print(double time, const SimulatedRobot& robot) {
  std::printf("%8.2f s  %s ", time, robot.name.c_str());
  for (const double number : robot.at) std::printf(" %.3f", number);
  std::printf("\n");
}

DdsOptions options_of_environment() {
  DdsOptions options;
  Settings table;
  add_dds_settings(table, options);
  const WrittenFaults faults = configure(table, {std::nullopt, process_environment(), {}});
  for (const std::string& fault : faults.usage) std::fprintf(stderr, "%s\n", fault.c_str());
  if (!faults.none()) std::exit(2);
  return options;
}

// A plan holds for robots that begin where it begins, all at one instant, which is its time 0; from
// then on each is to be where its path is. So no robot moves unless every one stands at its start,
// and one that falls behind has to halt them all.
bool drive(const Plan& plan, std::vector<SimulatedRobot>& robots, double speed) {
  const auto stands_at_start = [](const SimulatedRobot& robot, const RobotPlan& path) {
    return robot.name == path.name && robot.at == path.trajectory.at(0);
  };
  if (!std::ranges::equal(robots, plan.robots, stands_at_start)) {
    std::printf("not all robots are where the plan begins\n");
    return false;
  }
  const Clock::time_point begin = Clock::now();
  for (int tick = 0;; ++tick) {
    const double time = std::min(tick * kTick, plan.makespan);
    std::this_thread::sleep_until(begin + std::chrono::duration_cast<Clock::duration>(
                                              std::chrono::duration<double>(time / speed)));
    if (interrupted) {
      std::printf("halted at %.2f s: all robots stay where they are\n", time);
      return false;
    }
    for (std::size_t i = 0; i < robots.size(); ++i) {
      plan.robots[i].trajectory.at(time, robots[i].at);  // between two waypoints: linearly
      print(time, robots[i]);
    }
    if (time >= plan.makespan) return true;
  }
}

}  // namespace

int main(int argc, char** argv) {
  const double speed = argc > 2 ? std::atof(argv[2]) : 1;
  if (argc < 2 || argc > 3 || !(speed > 0)) {
    std::fprintf(stderr, "usage: fleet_manager_example SCENE [SPEED]\n");
    return 2;
  }
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  for (const int number : {SIGINT, SIGTERM}) std::signal(number, [](int) { interrupted = true; });

  RequestFile file = request_for_scene(argv[1]);
  for (const Diagnostic& fault : file.faults) {
    std::fprintf(stderr, "%s\n", to_string(fault).c_str());
  }
  if (!file.scene) return 3;
  std::vector<SimulatedRobot> robots;
  for (const Robot& robot : file.scene->robots) robots.push_back({robot.name, robot.start});

  const auto port = make_dds_fleet_client(options_of_environment());
  if (!port) {
    std::fprintf(stderr, "%s\n", port.error().c_str());
    return 6;
  }
  FleetManager manager(**port, {});
  file.request.id = "example-" + std::to_string(std::random_device()());
  const auto answer = manager.plan(
      file.request,
      [](const RequestState& state) {
        std::printf("%s: %.2f s, %s, %u of %u robots planned, %lu conflicts found\n",
                    state.id.c_str(), state.elapsed, std::string(to_string(state.phase)).c_str(),
                    state.robots_planned, state.robots, state.conflicts_found);
      },
      interrupted);
  if (!answer) {
    std::fprintf(stderr, "%s\n",
                 answer.error().why == NoAnswer::Why::kNoService
                     ? "no service has answered"
                     : printable(answer.error().reply.text, kTextBytes).c_str());
    return answer.error().why == NoAnswer::Why::kNoService ? 6 : 3;
  }
  if (answer->status != PlanStatus::kSolved) {
    std::printf("%s: %s\n", std::string(to_string(answer->status)).c_str(),
                printable(answer->message, kTextBytes).c_str());
    return answer->status == PlanStatus::kCancelled ? 5 : 4;
  }
  return drive(*answer, robots, speed) ? 0 : 5;
}
