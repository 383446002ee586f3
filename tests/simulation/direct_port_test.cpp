#include "coordinator/dispatch/direct_port.h"

#include <gtest/gtest.h>

#include "common/transport/simulated_network.h"

namespace accord {
namespace {

using namespace std::chrono_literals;

// A port that began its time anew would have heard of everybody at the beginning of the world, and
// give them up as silent.
TEST(DirectPort, GoesOnInTheTimeOfTheOneBeforeIt) {
  SimulatedNetwork network(1);
  const auto bus = network.join(Role::kCoordinator);
  const auto worker = network.join(Role::kWorker);
  TaskBoard board{TaskBoard::Settings{}};
  const auto pass = [&](Bus&, std::optional<TaskBoard::Time>) {
    network.advance_to(network.now() + 10ms);
    return network.now();
  };
  network.advance_to(5s);
  Announcement announcement;
  announcement.threads = 1;
  ASSERT_EQ(worker->publish({}, announcement), Published::kSent);
  {
    DirectPort first(*bus, board, 1, pass);
    for (int i = 0; i < 3; ++i) first.turn();
  }
  ASSERT_EQ(board.threads(), 1U);
  while (worker->take()) continue;
  ASSERT_EQ(worker->publish(bus->self(), Heartbeat{}), Published::kSent);
  network.advance_to(network.now() + 10ms);
  DirectPort second(*bus, board, 2, pass);
  for (int i = 0; i < 3; ++i) second.turn();
  EXPECT_EQ(board.counters().workers_lost(), 0U);
}

}  // namespace
}  // namespace accord
