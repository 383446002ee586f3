// The topics: one a kind of message.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>
#include <variant>

#include "common/transport/endpoint_id.h"
#include "common/transport/messages.h"

namespace accord::dds {

struct TopicTraits {
  const char* name;          // after accord/vN/, but for announcements
  std::size_t writer_depth;  // samples on their way to a peer; kept until there are more
  std::size_t reader_depth;  // samples that wait to be taken, of all peers
};

// By Message's index.
inline constexpr std::array<TopicTraits, kMessageKinds> kTopics = {{
    {"tasks", 64, 128},
    {"commands", 256, 512},
    {"scenes", 16, 64},
    {"announcements", 64, 4096},
    {"results", 256, 8192},
    {"heartbeats", 64, 8192},
    {"scene_requests", 64, 4096},
}};
inline constexpr std::size_t kAnnouncements = 3;
static_assert(std::is_same_v<std::variant_alternative_t<kAnnouncements, Message>, Announcement>);

// What is looked at first when several have something: what is short and urgent.
inline constexpr std::array<std::size_t, kMessageKinds> kUrgency = {3, 1, 5, 6, 4, 0, 2};

inline std::string topic_name(std::size_t kind, std::uint32_t protocol) {
  if (kind == kAnnouncements) return std::string("accord/") + kTopics[kind].name;
  return "accord/v" + std::to_string(protocol) + "/" + kTopics[kind].name;
}

// Where coordinators listen, and where one worker does.
inline std::string coordinators_partition(const std::string& cluster) {
  return cluster + "/coordinators";
}
inline std::string worker_partition(const std::string& cluster, EndpointId worker) {
  return cluster + "/workers/" + to_string(worker);
}

}  // namespace accord::dds
