// What the public topics cost over DDS: from a request to its whole plan, with a service in a
// process of its own that has the plan at once. Prints a table.
//
//   fleet_bench [ROUNDS]
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

#include "common/io/limits.h"
#include "common/transport/fleet/dds_fleet.h"
#include "tests/contract/dds_world.h"
#include "tests/support/child_process.h"

namespace {

using namespace accord;
using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;
using Transport = DdsOptions::Transport;

double milliseconds_since(Clock::time_point begin) {
  return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

class Session {
 public:
  explicit Session(const DdsOptions& options)
      : service_({ACCORD_FLEET_PEER, std::to_string(options.domain), options.cluster,
                  options.transport == Transport::kUdp ? "udp" : "shm"}) {
    auto client = make_dds_fleet_client(options);
    if (!client) {
      std::cerr << client.error() << '\n';
      std::exit(1);
    }
    client_ = std::move(*client);
    while (!client_->has_service()) client_->wait(10ms);
  }
  ~Session() {
    client_->send(CancelRequest{"everything"});
    service_.wait();
  }
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  // How long it takes, ms, to the reply and to the plan.
  std::pair<double, double> ask(const PlanRequest& request) {
    const auto begin = Clock::now();
    double replied = 0;
    while (!client_->send(request)) client_->wait(1ms);
    while (true) {
      client_->wait(1s);
      while (const auto news = client_->take()) {
        if (std::holds_alternative<RequestReply>(*news)) replied = milliseconds_since(begin);
        if (std::holds_alternative<FinishedPlan>(*news))
          return {replied, milliseconds_since(begin)};
      }
    }
  }

 private:
  testing::ChildProcess service_;
  std::unique_ptr<FleetClientPort> client_;
};

void measure(Session& session, const char* transport, const std::string& plan, std::size_t bytes,
             int rounds) {
  PlanRequest request;
  request.scene_text = std::string(std::min(bytes, limits::kSceneBytes), '#');
  if (bytes > limits::kSceneBytes) {
    request.attachments = {{"map", std::string(bytes - limits::kSceneBytes, '#')}};
  }
  std::vector<double> replies;
  std::vector<double> plans;
  for (int i = -1; i < rounds; ++i) {
    request.id = plan + "/" + std::to_string(i);
    const auto [replied, planned] = session.ask(request);
    if (i < 0) continue;  // the plan had to be made
    replies.push_back(replied);
    plans.push_back(planned);
  }
  std::ranges::sort(replies);
  std::ranges::sort(plans);
  std::printf(
      "%-14s request of %6zu KiB: reply %7.2f ms; plan of %-8s median %7.2f ms, p99 %7.2f, most "
      "%7.2f\n",
      transport, bytes >> 10U, replies[replies.size() / 2], plan.c_str(), plans[plans.size() / 2],
      plans[plans.size() * 99 / 100], plans.back());
}

void measure(const char* name, Transport transport, int rounds) {
  DdsOptions options = local_dds(transport);
  options.segment_bytes = std::size_t{64} << 20U;
  options.announcement = 200ms;
  Session session(options);
  measure(session, name, "1x2", 4 << 10U, rounds);
  measure(session, name, "16x30", 4 << 10U, rounds);
  measure(session, name, "1000x200", 200 << 10U, std::max(rounds / 20, 5));
  measure(session, name, "1x2", 14 << 20U, std::max(rounds / 50, 3));
  measure(session, name, "1x2", 68 << 20U, 3);
}

}  // namespace

int main(int argc, char** argv) {
  const int rounds = argc > 1 ? std::atoi(argv[1]) : 500;
  measure("shared memory", Transport::kSharedMemory, rounds);
  measure("UDP", Transport::kUdp, rounds);
}
