// The Bus over DDS keeps the contract, within one process but through real transports.
#include <gtest/gtest.h>

#include <tuple>

#include "tests/contract/dds_world.h"

namespace accord {
namespace {

using bus_contract::Check;
using Transport = DdsOptions::Transport;

class DdsBus : public testing::TestWithParam<std::tuple<Check, Transport>> {};

TEST_P(DdsBus, KeepsTheContract) {
  DdsWorld world(local_dds(std::get<Transport>(GetParam())));
  EXPECT_EQ(std::get<Check>(GetParam()).run(world), "");
}

INSTANTIATE_TEST_SUITE_P(Contract, DdsBus,
                         testing::Combine(testing::ValuesIn(bus_contract::checks()),
                                          testing::Values(Transport::kSharedMemory,
                                                          Transport::kUdp)),
                         [](const auto& param_info) {
                           const bool udp = std::get<1>(param_info.param) == Transport::kUdp;
                           return std::get<0>(param_info.param).name +
                                  (udp ? "OverUdp" : "OverSharedMemory");
                         });

TEST(DdsBusBoth, FindsAndReachesPeersByOneTransportOrTheOther) {
  DdsWorld world(local_dds(Transport::kBoth));
  EXPECT_EQ(bus_contract::check_named("EveryKindArrivesAsItWas").run(world), "");
}

TEST(DdsBusOfSmallDatagrams, CarriesLargeMessagesInParts) {
  for (const std::size_t bytes : {kLeastDatagramBytes, std::size_t{1452}}) {
    for (const Transport transport : {Transport::kUdp, Transport::kBoth}) {
      DdsOptions options = local_dds(transport);
      options.datagram_bytes = bytes;
      DdsWorld world(options);
      EXPECT_EQ(bus_contract::check_named("LargeMessagesArriveWhole").run(world), "") << bytes;
    }
  }
}

TEST(DdsBusPeers, AreFoundByTheirAddressesWithoutMulticast) {
  DdsOptions options = local_dds(Transport::kUdp);
  options.discovery = DdsOptions::Discovery::kPeers;
  options.addresses = {{"127.0.0.1", 0}};
  DdsWorld world(options);
  EXPECT_EQ(bus_contract::check_named("PeersFindEachOther").run(world), "");
}

TEST(DdsBusClusters, ThatShareADomainKnowNothingOfEachOther) {
  using namespace std::chrono_literals;
  const DdsOptions ours = local_dds(Transport::kUdp);
  DdsOptions theirs = ours;
  theirs.cluster += "-other";
  const auto coordinator = make_dds_bus(Role::kCoordinator, ours);
  const auto stranger = make_dds_bus(Role::kWorker, theirs);
  const auto worker = make_dds_bus(Role::kWorker, ours);
  ASSERT_TRUE(coordinator && stranger && worker);
  for (int i = 0; i < 500 && !(*coordinator)->is_present((*worker)->self()); ++i) {
    (*coordinator)->wait_for_event(10ms);
    while ((*coordinator)->take()) {
    }
  }
  EXPECT_EQ((*coordinator)->peers(), std::vector{(*worker)->self()});
  EXPECT_FALSE((*stranger)->take());
}

// A worker that left with tasks untaken deadlocked the coordinator in one of a hundred runs.
TEST(DdsBusRegression, WorkersThatLeaveWithFullQueuesLeaveTheCoordinatorAtWork) {
  using namespace std::chrono_literals;
  const DdsOptions options = local_dds(Transport::kUdp);
  const auto made = make_dds_bus(Role::kCoordinator, options);
  ASSERT_TRUE(made);
  Bus& coordinator = **made;
  for (int round = 0; round < 40; ++round) {
    auto worker = make_dds_bus(Role::kWorker, options);
    ASSERT_TRUE(worker);
    const EndpointId id = (*worker)->self();
    while (!coordinator.is_present(id)) {
      coordinator.wait_for_event(10ms);
      while (coordinator.take()) {
      }
    }
    const TaskBatch batch{1, {}, {}, {{{1, 0}, Bytes(3000)}}};
    while (coordinator.publish(id, batch) == Published::kSent) {
    }
    worker->reset();
    while (coordinator.is_present(id)) {
      coordinator.wait_for_event(10ms);
      while (coordinator.take()) {
      }
    }
  }
}

TEST(DdsOptions, ThatMakeNoSenseAreRefusedWithASentence) {
  const auto fault = [](const auto& spoil) {
    DdsOptions options;
    spoil(options);
    const auto bus = make_dds_bus(Role::kWorker, options);
    return bus ? "" : bus.error();
  };
  EXPECT_EQ(fault([](DdsOptions& o) { o.domain = 233; }), "domain: expected 0 to 232, not 233");
  EXPECT_EQ(fault([](DdsOptions& o) { o.cluster = "a*"; }),
            "cluster: expected 1 to 64 letters, digits, '-', '_' and '.'");
  EXPECT_EQ(fault([](DdsOptions& o) { o.interfaces = {"eth0"}; }),
            "interfaces: expected IPv4 addresses, not \"eth0\"");
  EXPECT_EQ(fault([](DdsOptions& o) { o.discovery = DdsOptions::Discovery::kPeers; }),
            "addresses: expected some, for discovery by peers or a server");
  EXPECT_EQ(fault([](DdsOptions& o) { o.lease = o.announcement; }),
            "lease: expected at least two announcements' time");
}

}  // namespace
}  // namespace accord
