// What goes and comes on each of the public topics, counted where it happens: plans are sent by a
// thread of their own.
// Thread safe.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "common/transport/traffic.h"

namespace accord {

// After accord/fleet/v1/ (docs/topics.md).
inline constexpr std::array<std::string_view, 9> kFleetTopicNames{
    "plan_requests", "cancels",     "resends", "replies", "statuses",
    "plans",         "robot_plans", "workers", "service"};
inline constexpr std::size_t kFleetTopics = kFleetTopicNames.size();

// The place of a topic among these; fails to compile for others where it is a constant.
constexpr std::size_t fleet_topic_index(std::string_view name) {
  std::size_t index = 0;
  while (kFleetTopicNames.at(index) != name) ++index;
  return index;
}

class FleetTraffic {
 public:
  using Totals = std::array<Traffic, kFleetTopics>;

  void count_sent(std::size_t topic, std::size_t bytes) {
    topics_[topic].sent += 1;
    topics_[topic].sent_bytes += bytes;
  }
  void count_received(std::size_t topic, std::size_t bytes) {
    topics_[topic].received += 1;
    topics_[topic].received_bytes += bytes;
  }
  Totals totals() const {
    Totals out;
    for (std::size_t i = 0; i < kFleetTopics; ++i) {
      out[i] = {topics_[i].sent, topics_[i].sent_bytes, topics_[i].received,
                topics_[i].received_bytes};
    }
    return out;
  }

 private:
  struct Counts {
    std::atomic<std::uint64_t> sent = 0, sent_bytes = 0, received = 0, received_bytes = 0;
  };
  std::array<Counts, kFleetTopics> topics_;
};

}  // namespace accord
