// The service in a process of its own: found, asked, killed, found again.
#include <gtest/gtest.h>

#include <csignal>
#include <functional>
#include <string>

#include "common/transport/fleet/dds_fleet.h"
#include "tests/contract/dds_world.h"
#include "tests/contract/fleet_samples.h"
#include "tests/support/child_process.h"

namespace accord {
namespace {

using namespace std::chrono_literals;
using fleet_samples::bits_of;
using fleet_samples::plan_of;
using Transport = DdsOptions::Transport;

class ServiceProcess : public testing::ChildProcess {
 public:
  explicit ServiceProcess(const DdsOptions& options)
      : ChildProcess({ACCORD_FLEET_PEER, std::to_string(options.domain), options.cluster,
                      options.transport == Transport::kUdp ? "udp" : "shm"}) {}
};

class FleetProcesses : public ::testing::Test {
 protected:
  void open(Transport transport) {
    options_ = local_dds(transport);
    auto client = make_dds_fleet_client(options_);
    ASSERT_TRUE(client) << client.error();
    client_ = std::move(*client);
  }

  bool until(const std::function<bool()>& holds, std::chrono::nanoseconds patience = 10s) {
    const auto end = std::chrono::steady_clock::now() + patience;
    while (true) {
      while (auto news = client_->take()) {
        if (auto* plan = std::get_if<FinishedPlan>(&*news)) plans_.push_back(std::move(*plan));
      }
      if (holds()) return true;
      if (std::chrono::steady_clock::now() > end) return false;
      client_->wait(10ms);
    }
  }

  bool finds_service() {
    return until([&] { return client_->has_service(); });
  }
  bool has_sent(const FleetRequest& request) {
    return until([&] { return client_->send(request); });
  }
  // Asks for a plan, and gets it.
  bool gets(const FleetRequest& request, const FinishedPlan& plan) {
    plans_.clear();
    return has_sent(request) && until([&] { return !plans_.empty(); }) &&
           plans_.front().id == plan.id && bits_of(plans_.front().plan) == bits_of(plan.plan);
  }

  DdsOptions options_;
  std::unique_ptr<FleetClientPort> client_;
  std::vector<FinishedPlan> plans_;
};

PlanRequest request_for(const std::string& id) {
  PlanRequest out;
  out.id = id;
  out.scene_text = std::string(100'000, '#');
  return out;
}

TEST_F(FleetProcesses, GetTheirPlansOverSharedMemory) {
  open(Transport::kSharedMemory);
  ServiceProcess service(options_);
  ASSERT_TRUE(finds_service());
  EXPECT_TRUE(gets(request_for("1x1"), plan_of("1x1", 1, 1)));
  EXPECT_TRUE(gets(request_for("16x30"), plan_of("16x30", 16, 30)));
  EXPECT_TRUE(gets(request_for("1000x200"), plan_of("1000x200", 1000, 200)));
  EXPECT_TRUE(has_sent(CancelRequest{"everything"}));
  EXPECT_EQ(service.wait(), 0);
  EXPECT_TRUE(until([&] { return !client_->has_service(); }));
}

TEST_F(FleetProcesses, GetTheirPlansOverUdp) {
  open(Transport::kUdp);
  const ServiceProcess service(options_);
  ASSERT_TRUE(finds_service());
  EXPECT_TRUE(gets(request_for("1x1"), plan_of("1x1", 1, 1)));
  EXPECT_TRUE(gets(request_for("16x30"), plan_of("16x30", 16, 30)));
  EXPECT_TRUE(gets(request_for("1000x200"), plan_of("1000x200", 1000, 200)));
}

TEST_F(FleetProcesses, FindAServiceThatWasKilledAndCameBack) {
  open(Transport::kUdp);
  ServiceProcess service(options_);
  ASSERT_TRUE(finds_service());
  EXPECT_TRUE(gets(request_for("16x30"), plan_of("16x30", 16, 30)));
  service.signal(SIGKILL);
  service.wait();
  EXPECT_TRUE(until([&] { return !client_->has_service(); }, 4s));
  EXPECT_FALSE(client_->send(ResendRequest{"16x30"}));
  const ServiceProcess next(options_);
  ASSERT_TRUE(finds_service());
  EXPECT_TRUE(gets(ResendRequest{"16x30"}, plan_of("16x30", 16, 30)));
}

// Who asks as soon as it has found the service may be found by it later than its plan is there.
TEST_F(FleetProcesses, GetPlansThatAreThereBeforeTheyAreFound) {
  open(Transport::kUdp);
  const ServiceProcess service(options_);
  for (int i = 0; i < 20; ++i) {
    auto client = make_dds_fleet_client(options_);
    ASSERT_TRUE(client) << client.error();
    client_ = std::move(*client);
    const std::string id = "4x10/" + std::to_string(i);
    ASSERT_TRUE(finds_service());
    EXPECT_TRUE(gets(request_for(id), plan_of(id, 4, 10)));
  }
}

}  // namespace
}  // namespace accord
