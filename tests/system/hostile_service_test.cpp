// A service that means harm: whatever it calls things, nothing of it reaches the terminal of who
// watches it, asks it or cancels as anything but plain text.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdio>
#include <thread>

#include "common/transport/fleet/dds_fleet.h"
#include "tests/contract/dds_world.h"

namespace accord {
namespace {

using namespace std::chrono_literals;

// Clears the screen, in both ways that terminals know; sets the title; rings; begins a line anew.
const std::string kHarm =
    "\x1B[2J\xC2\x9B"
    "2J\x1B]0;gotcha\x07\rgone\n\x7F\xFF";

class HostileService : public testing::Test {
 protected:
  HostileService() {
    auto port = make_dds_fleet_service(options_, [] {});
    if (!port) throw std::runtime_error(port.error());
    port_ = std::move(*port);
    thread_ = std::thread([this] {
      for (; !quit_; std::this_thread::sleep_for(20ms)) speak();
    });
  }
  ~HostileService() override {
    quit_ = true;
    thread_.join();
  }

  void speak() {
    while (const auto request = port_->take()) {
      const std::string id = std::visit([](const auto& kind) { return kind.id; }, *request);
      port_->publish(RequestReply{id, false, Rejection::kBadScene, kHarm, kHarm});
    }
    ServiceStatus service;
    service.version = service.host = kHarm;
    service.workers = 1;
    port_->publish(service);
    WorkerStatus worker;
    worker.host = worker.version = worker.text = kHarm;
    worker.standing = "welcome";
    port_->publish(worker);
    RequestState state;
    state.id = kHarm;
    state.phase = RequestPhase::kFinished;
    port_->publish(state);
    FinishedPlan finished{kHarm, {}};
    finished.plan.scene = finished.plan.message = kHarm;
    port_->publish(finished);
  }

  // All that the command says, on either stream.
  std::string said_by(const std::string& command) const {
    const std::string line = std::string(ACCORD) + " " + command + " --transport udp" +
                             " --interface 127.0.0.1 --cluster " + options_.cluster + " --domain " +
                             std::to_string(options_.domain) + " 2>&1 </dev/null";
    std::string out;
    FILE* pipe = popen(line.c_str(), "r");
    if (pipe == nullptr) throw std::runtime_error("popen");
    for (int c = 0; (c = std::fgetc(pipe)) != EOF;) out.push_back(static_cast<char>(c));
    pclose(pipe);
    return out;
  }

  DdsOptions options_ = local_dds(DdsOptions::Transport::kUdp);
  std::unique_ptr<FleetServicePort> port_;
  std::atomic<bool> quit_{false};
  std::thread thread_;
};

TEST_F(HostileService, ReachesNoTerminal) {
  for (const char* command : {"watch --once", "watch --once --json", "workers", "workers --json",
                              "cancel a", "submit " ACCORD_SOURCE_DIR "/scenes/peer-inlet.yaml"}) {
    const std::string said = said_by(command);
    EXPECT_NE(said.find("gone"), std::string::npos) << command << " has not heard it:\n" << said;
    for (const char c : said) {
      const auto byte = static_cast<unsigned char>(c);
      ASSERT_TRUE(c == '\n' || (byte >= 0x20 && byte < 0x7F)) << command << ":\n" << said;
    }
    EXPECT_EQ(said.find("\ngone"), std::string::npos) << command << " begins a line for it";
  }
}

}  // namespace
}  // namespace accord
