// The public topics: one a kind of value. docs/topics.md says the same to their users.
#pragma once

#include <cstddef>
#include <string>

#include "common/transport/fleet/fleet_messages.h"
#include "common/transport/fleet/plan_parts.h"

namespace accord::dds {

struct FleetTopic {
  const char* name;  // after accord/fleet/v1/
  // Requests: nothing is thrown away, and who cannot send is told. News: the latest `depth`.
  enum class Kind { kRequest, kNews } kind;
  std::size_t writer_depth;
  std::size_t reader_depth;
  // Whether who comes later gets the writer's history. Paths are too many: they are asked for. And
  // why a request was refused an hour ago is no answer to the same request now.
  bool late;
};

template <typename Value>
inline constexpr FleetTopic kFleetTopic{};

// A request's depth bounds memory: each may be 68 MiB.
template <>
inline constexpr FleetTopic kFleetTopic<PlanRequest>{"plan_requests", FleetTopic::Kind::kRequest, 8,
                                                     32, false};
template <>
inline constexpr FleetTopic kFleetTopic<CancelRequest>{"cancels", FleetTopic::Kind::kRequest, 64,
                                                       4096, false};
template <>
inline constexpr FleetTopic kFleetTopic<ResendRequest>{"resends", FleetTopic::Kind::kRequest, 64,
                                                       4096, false};
template <>
inline constexpr FleetTopic kFleetTopic<RequestReply>{"replies", FleetTopic::Kind::kNews, 1024,
                                                      1024, false};
template <>
inline constexpr FleetTopic kFleetTopic<RequestState>{"statuses", FleetTopic::Kind::kNews, 1024,
                                                      1024, true};
template <>
inline constexpr FleetTopic kFleetTopic<PlanOutline>{"plans", FleetTopic::Kind::kNews, 128, 1024,
                                                     false};
// A thousand robots' paths with room for some more.
template <>
inline constexpr FleetTopic kFleetTopic<PathPiece>{"robot_plans", FleetTopic::Kind::kNews, 4096,
                                                   4096, false};
// Pieces of its path that a robot on its own finds which comes later: some 16 MiB.
inline constexpr std::size_t kRobotPathDepth = 256;
template <>
inline constexpr FleetTopic kFleetTopic<WorkerStatus>{"workers", FleetTopic::Kind::kNews, 1024,
                                                      1024, true};
template <>
inline constexpr FleetTopic kFleetTopic<ServiceStatus>{"service", FleetTopic::Kind::kNews, 1, 8,
                                                       true};

inline std::string fleet_topic_name(const FleetTopic& topic) {
  return std::string("accord/fleet/v1/") + topic.name;
}

// What participants say of themselves, so that a client knows the service from others that listen
// to requests. The bus does not know these, and passes over them.
inline std::string fleet_user_data(const std::string& cluster, const char* role) {
  return "accord-fleet/" + cluster + "/1/" + role;
}
inline constexpr const char* kServiceRole = "service";
inline constexpr const char* kClientRole = "client";

}  // namespace accord::dds
