// The public topics over DDS keep the contract, within one process but through real transports; and
// whoever else speaks DDS may use them, or try to do harm.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <fastdds/dds/publisher/qos/PublisherQos.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <functional>
#include <thread>
#include <tuple>

#include "common/transport/dds/fleet/participant.h"
#include "common/transport/fleet/dds_fleet.h"
#include "common/transport/fleet/fleet_limits.h"
#include "tests/contract/dds_world.h"
#include "tests/contract/fleet_contract.h"
#include "tests/contract/fleet_samples.h"

namespace accord {
namespace {

using fleet_contract::Check;
using Transport = DdsOptions::Transport;

class DdsFleetWorld final : public fleet_contract::World {
 public:
  explicit DdsFleetWorld(DdsOptions options) : options_(std::move(options)) {}

  std::unique_ptr<FleetServicePort> serve(std::function<void()> wake) override {
    auto service = make_dds_fleet_service(options_, std::move(wake));
    if (!service) throw std::runtime_error(service.error());
    return std::move(*service);
  }
  std::unique_ptr<FleetClientPort> join() override {
    auto client = make_dds_fleet_client(options_);
    if (!client) throw std::runtime_error(client.error());
    return std::move(*client);
  }

 private:
  DdsOptions options_;
};

class DdsFleet : public testing::TestWithParam<std::tuple<Check, Transport>> {};

TEST_P(DdsFleet, KeepsTheContract) {
  DdsFleetWorld world(local_dds(std::get<Transport>(GetParam())));
  EXPECT_EQ(std::get<Check>(GetParam()).run(world), "");
}

INSTANTIATE_TEST_SUITE_P(Contract, DdsFleet,
                         testing::Combine(testing::ValuesIn(fleet_contract::checks()),
                                          testing::Values(Transport::kSharedMemory,
                                                          Transport::kUdp)),
                         [](const auto& param_info) {
                           const bool udp = std::get<1>(param_info.param) == Transport::kUdp;
                           return std::get<0>(param_info.param).name +
                                  (udp ? "OverUdp" : "OverSharedMemory");
                         });

// ---- Strangers: whoever speaks DDS ----

using namespace std::chrono_literals;
using dds::FleetParticipant;
using eprosima::fastdds::dds::DataWriter;
using eprosima::fastdds::dds::TypeSupport;

bool until(const std::function<bool()>& holds) {
  const auto end = std::chrono::steady_clock::now() + 10s;
  while (!holds()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(1ms);
  }
  return true;
}

bool is_matched(DataWriter& writer) {
  eprosima::fastdds::dds::PublicationMatchedStatus status;
  writer.get_publication_matched_status(status);
  return status.current_count > 0;
}

// Says to write requests, and writes bytes of its own making.
class Garbage final : public fleet::PlanRequestPubSubType {
 public:
  bool serialize(void* bytes, eprosima::fastrtps::rtps::SerializedPayload_t* payload) override {
    const auto& text = *static_cast<std::string*>(bytes);
    std::ranges::copy(text, payload->data);
    payload->length = static_cast<std::uint32_t>(text.size());
    return true;
  }
  std::function<std::uint32_t()> getSerializedSizeProvider(void* bytes) override {
    return [bytes] { return static_cast<std::uint32_t>(static_cast<std::string*>(bytes)->size()); };
  }
};

// ---- Who wants to hear how plans end, and nothing of paths ----

class DdsFleetOutcomes : public testing::Test {
 protected:
  std::unique_ptr<FleetClientPort> join(HeardPlans plans) {
    auto client = make_dds_fleet_client(options_, plans);
    if (!client || !until([&] { return (*client)->has_service(); })) {
      throw std::runtime_error("it finds no service");
    }
    return std::move(*client);
  }
  // How the next plan ended that it hears of.
  static std::optional<FinishedPlan> next(FleetClientPort& client) {
    std::optional<FleetNews> news;
    until([&] { return (news = client.take()) && std::holds_alternative<FinishedPlan>(*news); });
    return news ? std::optional(std::get<FinishedPlan>(*news)) : std::nullopt;
  }

  DdsOptions options_ = local_dds(Transport::kUdp);
  std::unique_ptr<FleetServicePort> service_ = DdsFleetWorld(options_).serve([] {});
};

TEST_F(DdsFleetOutcomes, ComeWithNamesOfRobotsAndNoPaths) {
  const auto client = join(HeardPlans::kOutcomes);
  service_->publish(fleet_samples::plan_of("1", 3, 20));
  const auto heard = next(*client);
  ASSERT_TRUE(heard);
  EXPECT_EQ(heard->id, "1");
  ASSERT_EQ(heard->plan.robots.size(), 3U);
  EXPECT_TRUE(heard->plan.robots[0].trajectory.empty());
  service_->publish(fleet_samples::plan_of("1", 3, 20));
  EXPECT_TRUE(next(*client)) << "again, where somebody has asked for it again";
}

TEST_F(DdsFleetOutcomes, OfThePastComeToThoseWhoWantThem) {
  service_->publish(fleet_samples::plan_of("before", 3, 20));
  const auto from_now_on = join(HeardPlans::kOutcomes);
  const auto all = join(HeardPlans::kAllOutcomes);
  EXPECT_EQ(next(*all).value().id, "before");
  service_->publish(fleet_samples::plan_of("later", 3, 20));
  EXPECT_EQ(next(*all).value().id, "later");
  EXPECT_EQ(next(*from_now_on).value().id, "later");
}

TEST_F(DdsFleetOutcomes, AreForThoseWhoCancelAndDoNotRequest) {
  const auto client = join(HeardPlans::kOutcomes);
  PlanRequest request;
  request.id = "1";
  EXPECT_FALSE(client->send(request));
  ASSERT_TRUE(client->send(CancelRequest{"1"}));
  std::optional<FleetRequest> heard;
  EXPECT_TRUE(until([&] { return (heard = service_->take()).has_value(); }));
  EXPECT_EQ(heard, FleetRequest(CancelRequest{"1"}));
}

class DdsFleetStrangers : public testing::Test {
 protected:
  DdsFleetStrangers() {
    service_ = DdsFleetWorld(options_).serve([] {});
    auto stranger =
        FleetParticipant::create(options_, options_.cluster, "stranger", nullptr, nullptr);
    stranger_ = std::move(stranger.value());
  }

  std::optional<FleetRequest> next_request() {
    std::optional<FleetRequest> request;
    until([&] { return (request = service_->take()).has_value(); });
    return request;
  }

  DdsOptions options_ = local_dds(Transport::kUdp);
  std::unique_ptr<FleetServicePort> service_;
  std::unique_ptr<FleetParticipant> stranger_;
};

TEST_F(DdsFleetStrangers, AskForPlansLikeAnyClient) {
  DataWriter* writer = stranger_->add_writer<PlanRequest>(nullptr);
  ASSERT_TRUE(until([&] { return is_matched(*writer); }));
  PlanRequest request;
  request.id = "theirs";
  ASSERT_TRUE(dds::write(request, *writer));
  EXPECT_EQ(next_request(), FleetRequest(request));
}

TEST_F(DdsFleetStrangers, ThatListenToRequestsAreNoService) {
  service_.reset();
  stranger_->add_reader<PlanRequest>(nullptr);
  stranger_->add_reader<CancelRequest>(nullptr);
  stranger_->add_reader<ResendRequest>(nullptr);
  const auto client = DdsFleetWorld(options_).join();
  std::this_thread::sleep_for(300ms);
  EXPECT_FALSE(client->has_service());
}

TEST_F(DdsFleetStrangers, ThatAskForMoreThanMayBeAreCountedAndTold) {
  DataWriter* writer = stranger_->add_writer<PlanRequest>(nullptr);
  // Late, since the service may find the writer before it finds this reader.
  auto* replies = stranger_->add_reader<RequestReply>(nullptr, true);
  ASSERT_TRUE(until([&] { return is_matched(*writer); }));
  PlanRequest request;
  request.id = "huge";
  request.scene_text = std::string(limits::kSceneBytes + 1, '#');
  ASSERT_TRUE(dds::write(request, *writer));
  request.attachments.resize(kAttachments + 1);
  ASSERT_TRUE(dds::write(request, *writer));
  const PlanRequest sound;
  ASSERT_TRUE(until([&] { return dds::write(sound, *writer); }));
  EXPECT_EQ(next_request(), FleetRequest(sound));
  EXPECT_EQ(service_->counters().malformed, 2);
  std::optional<RequestReply> reply;
  ASSERT_TRUE(until([&] { return (reply = dds::read<RequestReply>(*replies)).has_value(); }));
  EXPECT_EQ(reply->id, "huge");
  EXPECT_EQ(reply->reason, Rejection::kTooLarge);
  EXPECT_EQ(reply->text, "4194305 bytes of a scene; expected at most 4194304");
}

TEST_F(DdsFleetStrangers, ThatSendBytesWithoutSenseAreCounted) {
  auto* participant = dds::join_domain(options_, "anybody", nullptr).value();
  auto* topic =
      dds::add_topic(*participant, "accord/fleet/v1/plan_requests", TypeSupport(new Garbage()));
  ASSERT_NE(topic, nullptr);
  eprosima::fastdds::dds::PublisherQos qos;
  qos.partition().push_back(options_.cluster.c_str());
  DataWriter* writer =
      participant->create_publisher(qos)->create_datawriter(topic, dds::writer_qos(64));
  ASSERT_TRUE(until([&] { return is_matched(*writer); }));
  const std::string encapsulation("\0\1\0\0", 4);
  for (const std::string& rest :
       {std::string(), std::string(3, 'a'), std::string(40, '\xff'), std::string(100'000, '\1')}) {
    std::string bytes = encapsulation + rest;
    ASSERT_TRUE(until([&] { return writer->write(&bytes); }));
  }
  PlanRequest sound;
  sound.id = "sound";
  DataWriter* sane = stranger_->add_writer<PlanRequest>(nullptr);
  ASSERT_TRUE(until([&] { return is_matched(*sane); }));
  ASSERT_TRUE(dds::write(sound, *sane));
  const auto is_done = [&] {
    while (const auto request = service_->take()) EXPECT_EQ(*request, FleetRequest(sound));
    return service_->counters().received == 1 && service_->counters().malformed == 4;
  };
  EXPECT_TRUE(until(is_done));
  dds::leave_domain(*participant);
}

}  // namespace
}  // namespace accord
