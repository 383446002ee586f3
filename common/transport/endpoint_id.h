// Who is on the bus.
#pragma once

#include <compare>
#include <cstdint>
#include <string>

namespace accord {

// One life of one process: drawn at random when it joins, so that who comes back after a crash is
// somebody else, and what was meant for its former self does not reach it. 0: nobody.
struct EndpointId {
  std::uint64_t value = 0;

  friend constexpr auto operator<=>(EndpointId, EndpointId) = default;
};

// 16 hexadecimal digits.
std::string to_string(EndpointId id);

// From the system's entropy. Never 0. Throws std::runtime_error where there is none.
EndpointId random_endpoint_id();

// Coordinators talk to workers and workers to coordinators, never to their own kind.
enum class Role : std::uint8_t { kCoordinator = 0, kWorker = 1 };

}  // namespace accord
