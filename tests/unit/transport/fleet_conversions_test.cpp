// What DDS hands over on the public topics is deserialised within bounds, whoever sent it.
#include "common/transport/dds/fleet/conversions.h"

#include <gtest/gtest.h>

#include <variant>

#include "common/transport/fleet/fleet_limits.h"
#include "common/transport/fleet/plan_pieces.h"
#include "tests/contract/fleet_samples.h"

namespace accord::dds {
namespace {

using eprosima::fastrtps::rtps::SerializedPayload_t;

template <typename Value>
std::vector<std::uint8_t> serialised(const Value& value) {
  typename Wire<Value>::Type sample;
  to_wire(value, sample);
  typename Wire<Value>::Support support;
  SerializedPayload_t payload(
      static_cast<std::uint32_t>(support.getSerializedSizeProvider(&sample)()));
  EXPECT_TRUE(support.serialize(&sample, &payload));
  return {payload.data, payload.data + payload.length};
}

template <typename Value>
std::optional<Value> deserialised(const std::vector<std::uint8_t>& bytes) {
  SerializedPayload_t payload(static_cast<std::uint32_t>(bytes.size()));
  std::copy(bytes.begin(), bytes.end(), payload.data);
  payload.length = static_cast<std::uint32_t>(bytes.size());
  std::uint64_t refused = 0;
  typename Wire<Value>::Type sample;
  typename Wire<Value>::Support support(&refused);
  const bool taken = support.deserialize(&payload, &sample);
  EXPECT_EQ(refused, taken ? 0 : 1);
  if (!taken) return std::nullopt;
  return from_wire(sample);
}

template <typename Value>
void try_hostile(const Value& value) {
  const std::vector<std::uint8_t> sound = serialised(value);
  EXPECT_TRUE(deserialised<Value>(sound));
  for (std::size_t size = 0; size < sound.size(); ++size) {
    deserialised<Value>({sound.begin(), sound.begin() + static_cast<std::ptrdiff_t>(size)});
  }
  for (std::size_t i = 4; i < sound.size(); ++i) {
    for (const unsigned change : {1U, 128U, 255U}) {
      std::vector<std::uint8_t> bytes = sound;
      bytes[i] = static_cast<std::uint8_t>(bytes[i] ^ change);
      deserialised<Value>(bytes);
    }
  }
}

TEST(FleetConversions, TakeOrRefuseBytesThatWereChanged) {
  for (const FleetRequest& request : fleet_samples::requests()) {
    std::visit([](const auto& kind) { try_hostile(kind); }, request);
  }
  const FinishedPlan plan = fleet_samples::plan_of("1", 3, 4);
  try_hostile(PlanPieces(plan).outline());
  try_hostile(PlanPieces(plan).of_robot(1).front());
}

TEST(FleetConversions, RefuseMoreElementsThanThereMayBe) {
  const auto is_taken = [](const auto& value) {
    return deserialised<std::decay_t<decltype(value)>>(serialised(value)).has_value();
  };
  PlanRequest request = std::get<PlanRequest>(fleet_samples::requests().front());
  request.attachments.resize(kAttachments);
  request.queries.resize(limits::kRobots);
  request.solvers.resize(limits::kSolvers);
  EXPECT_TRUE(is_taken(request));
  request.attachments.resize(kAttachments + 1);
  EXPECT_FALSE(is_taken(request));
  request.attachments.resize(2);
  request.queries.resize(limits::kRobots + 1);
  EXPECT_FALSE(is_taken(request));
  request.queries.resize(3);
  request.solvers.resize(limits::kSolvers + 1);
  EXPECT_FALSE(is_taken(request));

  PlanOutline outline = PlanPieces(fleet_samples::plan_of("1", 3, 4)).outline();
  outline.plan.statistics.resize(kStatistics);
  outline.plan.robots.resize(limits::kRobots);
  EXPECT_TRUE(is_taken(outline));
  outline.plan.robots.resize(limits::kRobots + 1);
  EXPECT_FALSE(is_taken(outline));
  outline.plan.robots.resize(1);
  outline.plan.statistics.resize(kStatistics + 1);
  EXPECT_FALSE(is_taken(outline));

  PathPiece piece;
  piece.times = {0};
  piece.segments.resize(kPathPieceSegments);
  EXPECT_TRUE(is_taken(piece));
  piece.segments.resize(kPathPieceSegments + 1);
  EXPECT_FALSE(is_taken(piece));
}

}  // namespace
}  // namespace accord::dds
