// A service on the public topics that has a plan at once, for tests that need a process of its own
// to kill. A request's id says how large a plan: "16x30" or "16x30/7" is one of 16 robots with 30
// waypoints each, the same in every process.
//
//   fleet_peer DOMAIN CLUSTER udp|shm|both
//
// Goes on until it is killed, or asked to cancel "everything".
#include <condition_variable>
#include <iostream>
#include <map>
#include <mutex>
#include <string>
#include <utility>

#include "common/transport/fleet/dds_fleet.h"
#include "tests/contract/fleet_samples.h"

namespace {

using namespace accord;

class Waker {
 public:
  void wake() {
    const std::scoped_lock lock(mutex_);
    woken_ = true;
    changed_.notify_one();
  }
  void wait() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return std::exchange(woken_, false); });
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  bool woken_ = false;
};

// Made once a size.
const FinishedPlan& plan_for(const std::string& id) {
  static std::map<std::string, FinishedPlan> plans;
  const std::string size = id.substr(0, id.find('/'));
  const auto [plan, is_new] = plans.try_emplace(size);
  if (is_new) {
    const std::size_t x = size.find('x');
    plan->second =
        fleet_samples::plan_of(id, std::stoul(size.substr(0, x)), std::stoul(size.substr(x + 1)));
  }
  plan->second.id = id;
  return plan->second;
}

void answer(const std::string& id, FleetServicePort& port) {
  port.publish(RequestReply{id, true, Rejection::kNone, {}, {}});
  RequestState state;
  state.id = id;
  state.phase = RequestPhase::kFinished;
  port.publish(state);
  port.publish(plan_for(id));
}

// False when it is time to go.
bool serve(const FleetRequest& request, FleetServicePort& port) {
  if (const auto* plan = std::get_if<PlanRequest>(&request)) answer(plan->id, port);
  if (const auto* resend = std::get_if<ResendRequest>(&request)) answer(resend->id, port);
  return request != FleetRequest(CancelRequest{"everything"});
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) return 2;
  const std::string transport = argv[3];
  DdsOptions options;
  options.domain = static_cast<std::uint32_t>(std::stoul(argv[1]));
  options.cluster = argv[2];
  options.interfaces = {"127.0.0.1"};
  options.transport = transport == "udp"   ? DdsOptions::Transport::kUdp
                      : transport == "shm" ? DdsOptions::Transport::kSharedMemory
                                           : DdsOptions::Transport::kBoth;
  Waker waker;
  const auto port = make_dds_fleet_service(options, [&waker] { waker.wake(); });
  if (!port) {
    std::cerr << port.error() << '\n';
    return 1;
  }
  while (true) {
    while (const auto request = (*port)->take()) {
      if (!serve(*request, **port)) return 0;
    }
    waker.wait();
  }
}
