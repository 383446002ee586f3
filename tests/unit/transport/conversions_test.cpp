// What DDS hands over is deserialised within bounds, whoever sent it.
#include "common/transport/dds/conversions.h"

#include <gtest/gtest.h>

#include <random>

#include "common/transport/message_limits.h"

namespace accord::dds {
namespace {

using eprosima::fastrtps::rtps::SerializedPayload_t;

template <typename Kind>
std::vector<std::uint8_t> serialised(const Kind& message) {
  typename Wire<Kind>::Type sample;
  to_wire(message, sample);
  typename Wire<Kind>::Support support;
  SerializedPayload_t payload(
      static_cast<std::uint32_t>(support.getSerializedSizeProvider(&sample)()));
  EXPECT_TRUE(support.serialize(&sample, &payload));
  return {payload.data, payload.data + payload.length};
}

template <typename Kind>
bool is_taken(std::vector<std::uint8_t> bytes) {
  SerializedPayload_t payload(static_cast<std::uint32_t>(bytes.size()));
  std::copy(bytes.begin(), bytes.end(), payload.data);
  payload.length = static_cast<std::uint32_t>(bytes.size());
  typename Wire<Kind>::Type sample;
  typename Wire<Kind>::Support support;
  if (!support.deserialize(&payload, &sample)) return false;
  static_cast<void>(message_fault(from_wire(sample)));
  return true;
}

template <typename Kind>
void try_hostile(const Kind& message) {
  const std::vector<std::uint8_t> sound = serialised(message);
  EXPECT_TRUE(is_taken<Kind>(sound));
  std::mt19937 random(1);
  for (std::size_t size = 0; size < sound.size(); ++size) {
    is_taken<Kind>({sound.begin(), sound.begin() + static_cast<std::ptrdiff_t>(size)});
  }
  for (std::size_t i = 4; i < sound.size(); ++i) {
    for (const unsigned change : {1U, 128U, 255U}) {
      std::vector<std::uint8_t> bytes = sound;
      bytes[i] = static_cast<std::uint8_t>(bytes[i] ^ change);
      is_taken<Kind>(bytes);
    }
  }
}

TEST(Conversions, TakeOrRefuseBytesThatWereChanged) {
  const TaskKey key{1, 2};
  try_hostile(TaskBatch{1, {}, {1, 2}, {{key, {1, 2, 3}}, {key, {}}}});
  try_hostile(Command{Command::Kind::kRevoke, {key}, {}, "text"});
  try_hostile(ScenePiece{{}, 3, 0, {1, 2, 3}});
  try_hostile(Announcement{});
  try_hostile(ResultBatch{{{key, ResultItem::Outcome::kDone, {1, 2}, 1, "text"}}});
  try_hostile(Heartbeat{1, {{key, true, 1}}});
  try_hostile(SceneRequest{});
}

TEST(Conversions, RefuseMoreElementsThanAMessageMayHave) {
  ResultBatch results;
  results.results.resize(kBatchItems);
  EXPECT_TRUE(is_taken<ResultBatch>(serialised(results)));
  results.results.resize(kBatchItems + 1);
  EXPECT_FALSE(is_taken<ResultBatch>(serialised(results)));
  TaskBatch tasks;
  tasks.hierarchy = {1, 2, 3};
  tasks.tasks.resize(kBatchItems + 1);
  EXPECT_FALSE(is_taken<TaskBatch>(serialised(tasks)));
  Command command;
  command.tasks.resize(kKeys + 1);
  EXPECT_FALSE(is_taken<Command>(serialised(command)));
  Heartbeat heartbeat;
  heartbeat.tasks.resize(kKeys + 1);
  EXPECT_FALSE(is_taken<Heartbeat>(serialised(heartbeat)));
}

}  // namespace
}  // namespace accord::dds
